// SPDX-License-Identifier: BSD-3-Clause
// Uniform and normal numbers (Box and Muller) and noise with AR(1) and white parts.

#include "numerics/random_truth.hpp"

#include <cmath>
#include <numbers>

namespace hidden_effects {

double Random::uniform(double from, double to) {
    constexpr double one = 9007199254740992.0;  // 2^53
    return from + (to - from) * static_cast<double>(engine_() >> 11U) / one;
}

double Random::normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

std::vector<double> draw_noise(const Noise& noise, const std::vector<double>& times, Random& random) {
    const double correlated = noise.standard_deviation * std::sqrt(noise.correlated_share);
    const double white = noise.standard_deviation * std::sqrt(1.0 - noise.correlated_share);
    std::vector<double> out;
    double state = correlated * random.normal();
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (i > 0) {
            const double kept = std::pow(noise.correlation, times[i] - times[i - 1]);
            state = kept * state + correlated * std::sqrt(1.0 - kept * kept) * random.normal();
        }
        out.push_back(state + white * random.normal());
    }
    return out;
}

}  // namespace hidden_effects
