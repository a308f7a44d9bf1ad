// SPDX-License-Identifier: BSD-3-Clause
// Random numbers and sensor noise that are the same with every standard library.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace hidden_effects {

/// Random numbers that are the same on every standard library.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// Between from and to, evenly.
    [[nodiscard]] double uniform(double from = 0.0, double to = 1.0);
    /// Normal, mean 0, standard deviation 1 (Box and Muller).
    [[nodiscard]] double normal();

private:
    std::mt19937_64 engine_;
};

/// Noise of a sensor: a share of its variance follows itself (AR(1), a correlation over one second), the rest is white.
struct Noise {
    double standard_deviation = 0.0;  ///< of the sum
    double correlated_share = 0.7;    ///< of the variance
    double correlation = 0.9;         ///< over 1 s, of the correlated part
};

/// @param times s, ascending, not necessarily even  @returns [n_times], in the unit of the standard deviation
[[nodiscard]] std::vector<double> draw_noise(const Noise& noise, const std::vector<double>& times, Random& random);

}  // namespace hidden_effects
