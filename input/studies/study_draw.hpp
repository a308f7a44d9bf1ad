// SPDX-License-Identifier: BSD-3-Clause
// Random draws for studies: normal, lognormal and uniform distributions, which may be truncated.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace tiretherm::input {

/// How a drawn quantity is spread.
enum class Spread : std::uint8_t { normal, lognormal, uniform };

/// A distribution, cut off where the user says that it ends: what is beyond has no probability, the rest keeps its
/// shape.
struct Distribution {
    Spread spread = Spread::normal;
    double a = 0.0;  ///< mean, also of a lognormal quantity itself; lower end of a uniform one
    double b = 1.0;  ///< standard deviation, also of a lognormal quantity itself; upper end of a uniform one
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    /// Probability of a value below x, before the cut.
    [[nodiscard]] double below(double x) const;
    /// What of the distribution lies between `low` and `high`.
    [[nodiscard]] double kept() const { return below(high) - below(low); }
    /// The value below which a share of the cut distribution lies. @param share in (0, 1)
    [[nodiscard]] double quantile(double share) const;
};

/// A number in (0, 1) that depends on the seed, the sample and the key alone: neither the order of the runs nor other
/// keys nor the number of samples change it. Samples are independent of one another (not a Latin hypercube), so that
/// more of them can be added to those that have been run, and counts among them have binomial intervals.
[[nodiscard]] double draw(std::uint64_t seed, std::uint64_t sample, std::string_view key);

}  // namespace tiretherm::input
