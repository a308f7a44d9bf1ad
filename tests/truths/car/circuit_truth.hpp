// SPDX-License-Identifier: BSD-3-Clause
// A made-up circuit: a closed curve with its curvature, and where on the earth it lies.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace hidden_effects {

/// A circuit, sampled evenly along its length. Left turns have a positive curvature.
struct Circuit {
    double step = 0.0;                         ///< m, between two points
    std::vector<double> curvature;             ///< 1/m
    std::vector<std::array<double, 2>> place;  ///< m east and north of the start line

    [[nodiscard]] double length() const { return step * static_cast<double>(curvature.size()); }
    /// Straight between two points. @param s m, from the start line on, of any lap
    [[nodiscard]] double curvature_at(double s) const;
    [[nodiscard]] std::array<double, 2> place_at(double s) const;
};

/// The curve r = 330 m (1 + 0.30 cos 2a + 0.16 sin 3a), driven counter-clockwise: long fast bends and two slow corners, one
/// of them to the right. The start line is at a = 0.
[[nodiscard]] Circuit made_up_circuit();

/// Degrees of latitude and longitude of a place near 41.5 N, 12.5 E, on a sphere of 6371 km.
[[nodiscard]] std::array<double, 2> on_earth(const std::array<double, 2>& place);

}  // namespace hidden_effects
