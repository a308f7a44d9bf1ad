// SPDX-License-Identifier: BSD-3-Clause
// One side of a study's grid as an axis of a chart: numbers at their places, words and uneven numbers in equal steps.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::post {

/// A side of a study's grid as an axis: numbers at their places; words, and numbers too unevenly spaced for a linear axis,
/// side by side in steps.
struct StudyAxis {
    std::string name;
    std::string unit;                 ///< of numbers
    bool is_number = true;            ///< false: steps
    std::vector<double> at;           ///< [side]
    std::vector<std::string> labels;  ///< [side] as written
    double low = 0.0;
    double high = 1.0;

    /// Indices in the order of their places.
    [[nodiscard]] std::vector<std::size_t> order() const;
    /// The same in steps, from the lowest number or the first word on.
    [[nodiscard]] StudyAxis in_steps() const;
    /// Labels in the order of the places, for steps.
    [[nodiscard]] std::vector<std::string> labels_in_order() const;
};

[[nodiscard]] StudyAxis study_axis(const diagnosis::StudyRecord& study, std::size_t side);

/// Sides of the grid with more than one value.
[[nodiscard]] std::vector<std::size_t> wide_sides(const diagnosis::StudyRecord& study);

/// Points of the grid from one value of a side to the next.
[[nodiscard]] std::size_t stride(const diagnosis::StudyRecord& study, std::size_t side);

}  // namespace tiretherm::post
