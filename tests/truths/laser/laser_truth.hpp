// SPDX-License-Identifier: BSD-3-Clause
// Independent truth of the laser experiment: biquadratic finite elements and RODAS (Hairer and Wanner, Solving Ordinary
// Differential Equations II, IV.10).
#pragma once

#include <array>
#include <vector>

/// Truths that the project is compared with. Files called *_truth share no source file with it: they include only the
/// standard library, Eigen and each other, and a test watches that border.
namespace hidden_effects {

/// A conductivity that is quadratic in temperature, by its values at 40, 90 and 140 degC. W/mK
using Conductivity = std::array<double, 3>;

/// A disc of rubber in still air under a laser: two layers, K1 outside and K2 inside, an adiabatic rim, and light
/// absorbed evenly over a round spot about the axis.
///     rho c dT/dt = (1/r) d(r k dT/dr)/dr + d(k dT/dz)/dz,   k dT/dn = absorptivity P/(pi a^2) [r < a] - h (T - T_air)
struct LaserSpecimen {
    Conductivity K1{};              ///< of the outer layer
    Conductivity K2{};              ///< of the inner layer
    double outer_depth = 0.008;     ///< m
    double depth = 0.012;           ///< m, of both
    double radius = 0.060;          ///< m, of the specimen
    double density = 1100.0;        ///< kg/m3
    double heat_capacity = 1800.0;  ///< J/kgK
    double h_top = 10.0;            ///< W/m2K
    double h_bottom = 10.0;         ///< W/m2K
    double air = 23.0;              ///< degC
    double start = 23.0;            ///< degC, everywhere
    double absorptivity = 1.0;
    double power = 0.0;            ///< W
    double spot = 5.6419e-3;       ///< m, radius of the light
    double seen_spot = 5.6419e-3;  ///< m, radius over which the camera takes the mean
    double ring_inside = 0.015;    ///< m, of the ring on the inner face over which a mean is taken
    double ring_outside = 0.025;   ///< m
    double outer_heat_capacity_scale = 1.0;
    double inner_heat_capacity_scale = 1.0;
    double emissivity = 0.0;          ///< of the outer face, towards surroundings at the air's temperature
    double natural_convection = 0.0;  ///< factor on 1.32 (|T - T_air|/0.66 m)^0.25 W/m2K, on the outer face
};

/// How finely the truth is computed.
struct LaserResolution {
    int refinement = 1;       ///< 1: 15 x 11 elements; 2: twice as many each way
    double tolerance = 4e-3;  ///< K, local error of a step
};

/// What is read, in degC, at the times asked for.
struct LaserTrace {
    std::vector<double> spot_mean;     ///< outer face, mean over `seen_spot`
    std::vector<double> spot_centre;   ///< outer face, on the axis
    std::vector<double> inner_centre;  ///< inner face, on the axis
    std::vector<double> inner_ring;    ///< inner face, mean over the ring
    int n_steps = 0;
};

/// Biquadratic finite elements whose edges are those of the spot and of the layers, finer towards the edge of the spot
/// and towards the outer face; the Rosenbrock method RODAS of order 4(3) (Hairer and Wanner, Solving Ordinary
/// Differential Equations II, IV.10) with the exact Jacobian; cubic Hermite interpolation between its steps.
/// @param times s, ascending, the first >= 0
[[nodiscard]] LaserTrace heat_with_laser(const LaserSpecimen& specimen, const std::vector<double>& times,
                                         const LaserResolution& resolution = {});

}  // namespace hidden_effects
