// SPDX-License-Identifier: BSD-3-Clause
// The median and other values by their place in the order.
#pragma once

#include <algorithm>
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

}  // namespace tiretherm::solver
