// SPDX-License-Identifier: BSD-3-Clause
// One side of a study's grid as an axis of a picture: numbers at their places, words and uneven numbers in equal steps.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/study/study_record.hpp"
#include "post/pictures/axes.hpp"

namespace tiretherm::post {

/// A side of a study's grid as an axis: numbers at their places, in round powers of ten of their unit; words, and
/// numbers too unevenly spaced for a linear axis, side by side in steps.
struct StudyAxis {
    std::string name;                 ///< with its unit
    bool is_number = true;            ///< false: steps
    std::vector<double> at;           ///< [side]
    std::vector<std::string> labels;  ///< [side] of steps, as written
    double low = 0.0;
    double high = 1.0;

    /// Indices in the order of their places.
    [[nodiscard]] std::vector<std::size_t> order() const;
    /// The same in steps, from the lowest number or the first word on.
    [[nodiscard]] StudyAxis in_steps() const;
    /// Place between `from` and `to`, px.
    [[nodiscard]] Scale scale(double from, double to) const;
    [[nodiscard]] Ticks ticks(int about) const;
};

[[nodiscard]] StudyAxis study_axis(const diagnosis::StudyRecord& study, std::size_t side);

/// The name of a quantity, or the last key of its path where the whole has no room. @param room px
[[nodiscard]] std::string fitting(const Canvas& canvas, const std::string& name, double room);

/// Sides of the grid with more than one value.
[[nodiscard]] std::vector<std::size_t> wide_sides(const diagnosis::StudyRecord& study);

/// Points of the grid from one value of a side to the next.
[[nodiscard]] std::size_t stride(const diagnosis::StudyRecord& study, std::size_t side);

void draw_below(Canvas& canvas, const StudyAxis& axis, const Scale& scale, double y);
void draw_left(Canvas& canvas, const StudyAxis& axis, const Scale& scale, double x);
/// Room that numbers or words to the left of an axis need, with its name. px
[[nodiscard]] double room_left(const Canvas& canvas, const StudyAxis& axis);

/// The title of a study's picture, and lines below it.
void draw_heads(Canvas& canvas, const diagnosis::StudyRecord& study, const std::vector<std::string>& lines);

}  // namespace tiretherm::post
