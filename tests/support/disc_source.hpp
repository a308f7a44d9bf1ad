// SPDX-License-Identifier: BSD-3-Clause
// Exact surface temperature of a half-space heated over a disc: Carslaw and Jaeger, Conduction of Heat in Solids (2nd
// ed. 1959), section 10.5.
#pragma once

#include <cmath>
#include <numbers>

namespace tiretherm::support {

/// Half-space z > 0, insulated, at zero, heated from t = 0 by q [W/m2] over a disc of radius a of its surface.
///
/// A point of the surface that lets off heat Q at once warms the surface at a distance r by
/// 2 Q / (rho c (4 pi alpha t)^(3/2)) exp(-r^2/(4 alpha t)); over the disc, at its centre, that gives
/// q / (rho c sqrt(pi alpha t)) (1 - exp(-a^2/(4 alpha t))), and over the time from 0 to t
///
///     T(0, 0, t) = 2 q sqrt(alpha t)/k [1/sqrt(pi) - ierfc(a / (2 sqrt(alpha t)))],
///
/// Carslaw and Jaeger, Conduction of Heat in Solids (2nd ed. 1959), section 10.5.
struct DiscSource {
    double flux;          ///< W/m2
    double radius;        ///< m
    double conductivity;  ///< W/(m K)
    double diffusivity;   ///< m2/s

    [[nodiscard]] double at_centre(double t) const {
        const double reach = std::sqrt(diffusivity * t);
        return 2.0 * flux * reach / conductivity * (std::numbers::inv_sqrtpi - ierfc(radius / (2.0 * reach)));
    }

    /// On the surface at a distance of several radii: the disc as a continuous point source, q a^2 pi / (2 pi k r)
    /// erfc(r / (2 sqrt(alpha t))), averaged over the disc by the midpoint rule.
    [[nodiscard]] double far_away(double distance, double t) const {
        constexpr int rings = 8;
        constexpr int sectors = 16;
        double sum = 0.0;
        for (int i = 0; i < rings; ++i) {
            const double s = radius * (i + 0.5) / rings;
            const double area = 2.0 * std::numbers::pi * s * radius / rings / sectors;
            for (int j = 0; j < sectors; ++j) {
                const double angle = 2.0 * std::numbers::pi * (j + 0.5) / sectors;
                const double r = std::sqrt(distance * distance + s * s - 2.0 * distance * s * std::cos(angle));
                sum += area * std::erfc(r / (2.0 * std::sqrt(diffusivity * t))) /
                       (2.0 * std::numbers::pi * conductivity * r);
            }
        }
        return flux * sum;
    }

    /// Integral of erfc from x to infinity.
    [[nodiscard]] static double ierfc(double x) {
        return std::exp(-x * x) * std::numbers::inv_sqrtpi - x * std::erfc(x);
    }
};

}  // namespace tiretherm::support
