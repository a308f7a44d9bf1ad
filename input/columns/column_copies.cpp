// SPDX-License-Identifier: BSD-3-Clause
// Columns of a recording that are one another's copies, perhaps shifted by a constant: a channel that was computed from
// another one, or logged twice.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t fewest = 50;    ///< samples
constexpr double least_range = 20.0;  ///< steps of the logger; what moves less may agree by chance
constexpr double most_spread = 0.51;  ///< steps of the logger; a copy is rounded once more

double range_of(const RecordedColumn* column) { return column->most() - column->least(); }

/// The constant difference between two columns; nothing where it is none.
std::optional<double> constant_difference(const RecordedColumn& a, const RecordedColumn& b) {
    const double step = std::max(a.resolution(), b.resolution());
    if (a.si != b.si || a.value.size() != b.value.size() || !(range_of(&a) >= least_range * step) || step == 0.0) {
        return std::nullopt;
    }
    double smallest = a.value.front() - b.value.front();
    double largest = smallest;
    for (std::size_t i = 0; i < a.value.size(); ++i) {
        smallest = std::min(smallest, a.value[i] - b.value[i]);
        largest = std::max(largest, a.value[i] - b.value[i]);
        if (largest - smallest > 2.0 * most_spread * step) {
            return std::nullopt;
        }
    }
    return a.time == b.time ? std::optional(0.5 * (smallest + largest)) : std::nullopt;
}

/// The first earlier column that one is a copy of.
struct Original {
    const RecordedColumn* column = nullptr;
    double shift = 0.0;
};

/// Ranges of copies differ by rounding alone: of all columns only those beside one another in the order of their ranges are
/// compared.
std::vector<Original> originals(const std::vector<RecordedColumn>& columns) {
    std::vector<const RecordedColumn*> by_range;
    for (const RecordedColumn& column : columns) {
        if (column.value.size() >= fewest && range_of(&column) > 0.0) {
            by_range.push_back(&column);
        }
    }
    std::ranges::stable_sort(by_range, {}, range_of);
    std::vector<Original> found(columns.size());
    const auto compare = [&](const RecordedColumn* one, const RecordedColumn* other) {
        const auto [a, b] = std::minmax(one, other);
        Original& of = found[static_cast<std::size_t>(b - columns.data())];
        if (of.column == nullptr || a < of.column) {
            if (const std::optional<double> shift = constant_difference(*b, *a)) {
                of = {a, *shift};
            }
        }
    };
    for (auto one = by_range.begin(); one != by_range.end(); ++one) {
        const auto is_near = [&](const RecordedColumn* other) {
            return std::abs(range_of(other) - range_of(*one)) <= 2.0 * most_spread * (*one)->resolution();
        };
        for (auto other = one + 1; other != by_range.end() && is_near(*other); ++other) {
            compare(*one, *other);
        }
        for (auto other = one; other != by_range.begin() && is_near(*(other - 1)); --other) {
            compare(*one, *(other - 1));
        }
    }
    return found;
}

}  // namespace

std::vector<std::string> find_copies(const Recording& recording) {
    const std::vector<Original> found = originals(recording.columns);
    std::vector<std::string> sentences;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& [original, shift] = found[i];
        if (original == nullptr) {
            continue;
        }
        const RecordedColumn& copy = recording.columns[i];
        const bool equal = std::abs(shift) <= most_spread * std::max(original->resolution(), copy.resolution());
        sentences.push_back(
            equal ? fmt::format("{} is a copy of {}, sample by sample: one of them was not measured", copy.name,
                                original->name)
                  : fmt::format("{} is a copy of {} with {} added, sample by sample: one of them was not measured",
                                copy.name, original->name, original->show_difference(shift)));
    }
    return sentences;
}

}  // namespace tiretherm::input
