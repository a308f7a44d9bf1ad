// SPDX-License-Identifier: BSD-3-Clause
// The median and other values by their place in the order.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/// The values that as many others are not above as `places` say. Looked for is only in those of 4096 equal parts of the range
/// where they lie. @param places ascending, each below values.size()
[[nodiscard]] inline std::vector<double> smallest_at(const std::vector<double>& values,
                                                     const std::vector<std::size_t>& places) {
    constexpr std::size_t n_parts = 4096;
    std::vector<double> found;
    const auto [low, high] = values.empty() ? std::ranges::minmax_result<double>{} : std::ranges::minmax(values);
    const double scale = static_cast<double>(n_parts - 1) / (high - low);
    const bool has_parts = scale > 0.0 && std::isfinite(scale);  // otherwise all are one
    std::vector<std::uint16_t> part(values.size());
    std::vector<std::size_t> size(n_parts);
    for (std::size_t i = 0; i < values.size(); ++i) {
        part[i] = has_parts ? static_cast<std::uint16_t>((values[i] - low) * scale) : 0;
        ++size[part[i]];
    }
    std::size_t before = 0;
    std::size_t here = 0;
    std::vector<double> inside;
    for (const std::size_t place : places) {
        for (; before + size[here] <= place; ++here) {
            before += size[here];
            inside.clear();
        }
        if (inside.empty()) {
            inside.reserve(size[here]);
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (part[i] == here) {
                    inside.push_back(values[i]);
                }
            }
        }
        const auto at = inside.begin() + static_cast<std::ptrdiff_t>(place - before);
        std::ranges::nth_element(inside, at);
        found.push_back(*at);
    }
    return found;
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
