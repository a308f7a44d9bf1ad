// SPDX-License-Identifier: BSD-3-Clause
// Quadratic shape functions and three-point Gauss quadrature on a line.
#pragma once

#include <array>
#include <vector>

/// Quadratic elements on a line, what the biquadratic ones of the truths are made of.
namespace hidden_effects::quadratic {

/// Gauss's three points on -1..1, exact to degree 5.
inline constexpr std::array<double, 3> gauss_place{-0.77459666924148337704, 0.0, 0.77459666924148337704};
inline constexpr std::array<double, 3> gauss_weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};

/// The quadratics that are 1 at one of -1, 0, 1 and 0 at the others, and their slopes.
[[nodiscard]] inline std::array<double, 3> shapes(double x) {
    return {0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)};
}
[[nodiscard]] inline std::array<double, 3> slopes(double x) { return {x - 0.5, -2.0 * x, x + 0.5}; }

/// Appends the nodes of `count` elements that grow geometrically from the last node to `to`: the last is `ratio` times
/// as long as the first.
void append_elements(std::vector<double>& nodes, double to, int count, double ratio);

}  // namespace hidden_effects::quadratic
