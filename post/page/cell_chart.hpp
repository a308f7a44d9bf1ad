// SPDX-License-Identifier: BSD-3-Clause
// Rectangles with a colour for their value: maps of studies, correlations, heat over place and time.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "post/report/value.hpp"

namespace tiretherm::post {

/// One side of a map: numbers between two ends, or words in steps of 1 from 0 on.
struct CellAxis {
    std::string name;
    std::string unit{};
    double low = 0.0;
    double high = 1.0;
    std::vector<std::string> words{};  ///< of steps; then low and high have no meaning
};

/// A rectangle of a map. Its sides are in the unit of the axes; a word's step i reaches from i to i + 1.
struct MapCell {
    double x_from = 0.0;
    double x_to = 0.0;
    double y_from = 0.0;
    double y_to = 0.0;
    double value = 0.0;
    bool is_marked = false;  ///< framed: above a critical temperature
    std::string text{};      ///< shown in the place of the value; empty: the value
};

/// What the colours of a map mean.
struct CellScale {
    std::string name;
    std::string unit{};
    bool is_signed = false;  ///< from blue over white to red, 0 in the middle; otherwise dark to light
    double reach = 0.0;      ///< of a signed one, the end of the scale; 0: the largest value
    double low = std::numeric_limits<double>::quiet_NaN();  ///< of one that is not signed; NaN: the lowest value
    double high = std::numeric_limits<double>::quiet_NaN();
    std::string marked{};  ///< what a frame means
};

/// Data of a map for report.js. @param cells not finite values are left out
[[nodiscard]] Value cell_chart(const CellAxis& x, const CellAxis& y, const CellScale& scale,
                               const std::vector<MapCell>& cells);

/// Borders between numbers, halfway from one to the next; the outer ones as far out as the nearest is in.
/// @param at ascending, at least one  @returns [at + 1]
[[nodiscard]] std::vector<double> borders_between(const std::vector<double>& at);

}  // namespace tiretherm::post
