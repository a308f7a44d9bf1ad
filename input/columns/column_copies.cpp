// SPDX-License-Identifier: BSD-3-Clause
// Columns of a recording that are one another's copies, perhaps shifted by a constant: a channel that was computed from
// another one, or logged twice.

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t fewest = 50;    ///< samples
constexpr double least_range = 20.0;  ///< steps of the logger; what moves less may agree by chance
constexpr double most_spread = 0.51;  ///< steps of the logger; a copy is rounded once more

/// The constant difference between two columns; nothing where it is none.
std::optional<double> constant_difference(const RecordedColumn& a, const RecordedColumn& b) {
    if (a.si != b.si || a.value.size() != b.value.size() || a.value.size() < fewest || a.time != b.time) {
        return std::nullopt;
    }
    const double step = std::max(a.resolution(), b.resolution());
    const auto [low, high] = std::ranges::minmax(a.value);
    if (!(high - low >= least_range * step) || step == 0.0) {
        return std::nullopt;
    }
    const double first = a.value.front() - b.value.front();
    double smallest = first;
    double largest = first;
    for (std::size_t i = 0; i < a.value.size(); ++i) {
        smallest = std::min(smallest, a.value[i] - b.value[i]);
        largest = std::max(largest, a.value[i] - b.value[i]);
        if (largest - smallest > 2.0 * most_spread * step) {
            return std::nullopt;
        }
    }
    return 0.5 * (smallest + largest);
}

}  // namespace

std::vector<std::string> find_copies(const Recording& recording) {
    std::vector<std::string> sentences;
    for (auto b = recording.columns.begin(); b != recording.columns.end(); ++b) {
        for (auto a = recording.columns.begin(); a != b; ++a) {
            const std::optional<double> shift = constant_difference(*b, *a);
            if (!shift) {
                continue;
            }
            const bool equal = std::abs(*shift) <= most_spread * std::max(a->resolution(), b->resolution());
            sentences.push_back(
                equal ? fmt::format("{} is a copy of {}, sample by sample: one of them was not measured", b->name,
                                    a->name)
                      : fmt::format("{} is a copy of {} with {} added, sample by sample: one of them was not measured",
                                    b->name, a->name, a->show_difference(*shift)));
            break;
        }
    }
    return sentences;
}

}  // namespace tiretherm::input
