// SPDX-License-Identifier: BSD-3-Clause
// The median and other values by their place in the order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace tiretherm::solver {

/// The value that n others are not above. @pre n < values.size()
template <typename Value>
[[nodiscard]] Value nth_smallest(std::vector<Value> values, std::size_t n) {
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(n);
    std::ranges::nth_element(values, place);
    return *place;
}

/// The middle one, of an even number the upper of the two; 0 of none.
[[nodiscard]] inline double median(std::vector<double> values) {
    const std::size_t middle = values.size() / 2;
    return values.empty() ? 0.0 : nth_smallest(std::move(values), middle);
}

/// The median of the steps by which times go on, those that stand or go back left out; 0 where none goes on.
/// @param times NaN: left out
[[nodiscard]] inline double median_step(const std::vector<double>& times) {
    std::vector<double> steps;
    steps.reserve(times.size());
    double last = std::nan("");
    for (const double time : times) {
        if (time > last) {
            steps.push_back(time - last);
        }
        last = std::isnan(time) ? last : time;
    }
    return median(std::move(steps));
}

}  // namespace tiretherm::solver
