// SPDX-License-Identifier: BSD-3-Clause
// Straight lines between points, held beyond the first and the last.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace tiretherm::physics {

/// The two points of an ascending list between which something lies, or twice the same beyond its ends.
struct Bracket {
    std::size_t below = 0;
    std::size_t above = 0;
    double share = 0.0;  ///< of the way from `below` to `above`

    /// @param value of a point, by its index
    template <typename Value>
    [[nodiscard]] double between(const Value& value) const {
        return below == above ? value(below) : (1.0 - share) * value(below) + share * value(above);
    }
};

/// @param at ascending  @pre at least one
[[nodiscard]] inline Bracket bracket(std::span<const double> at, double x) {
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(at, x) - at.begin());
    if (next == 0 || next == at.size()) {
        const std::size_t end = next == 0 ? 0 : next - 1;
        return {.below = end, .above = end};
    }
    return {.below = next - 1, .above = next, .share = (x - at[next - 1]) / (at[next] - at[next - 1])};
}

}  // namespace tiretherm::physics
