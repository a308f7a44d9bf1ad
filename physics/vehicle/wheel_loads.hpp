// SPDX-License-Identifier: BSD-3-Clause
// Vertical loads and shared forces of a car in quasi-static equilibrium: longitudinal and lateral load transfer with the
// split of the roll stiffness, aerodynamic loads, wheels that lift.
#pragma once

#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::physics {

/// Forces on a car at one moment, before they are shared between the wheels of an axle.
struct VehicleForces {
    std::array<double, n_corners> vertical{};      ///< N, >= 0
    std::array<double, n_corners> longitudinal{};  ///< N, positive forwards
    std::array<double, 2> lateral_of_axle{};       ///< N, positive to the left
    std::array<bool, n_corners> lifted{};          ///< the wheel would need a load below 0, which is moved to others
    bool rolls_over = false;                       ///< both wheels of a side would need one
};

/// The road's plane under a car, level where nothing is said.
struct RoadPlane {
    double bank = 0.0;                  ///< rad, positive where it falls to the left: in a left turn it helps
    double gravity = standard_gravity;  ///< m/s2 across the heading: g cos(slope) + V d(slope)/dt

    /// By how much less the tires give across than the turn takes, m/s2: a_y = A cos(bank) - gravity sin(bank), A horizontal.
    [[nodiscard]] double across() const;
    /// a_z of a car with an acceleration a_y: the turn presses it into the bank,
    ///     a_z = gravity cos(bank) + A sin(bank) = gravity / cos(bank) + a_y tan(bank)
    /// 37 degrees and a_y = 0.3 g: A = (0.3 + 0.6018) / 0.7986 g = 1.1292 g, a_z = (0.7986 + 1.1292 0.6018) g = 1.478 g.
    [[nodiscard]] double vertical_acceleration(double lateral_acceleration) const;
};

/// Loads and forces of a rigid car on springs, in equilibrium with its accelerations; q = rho V^2 / 2, L = a + b:
///     Fz_f = m a_z b/L - m a_x h/L + q A_f,   Fz_r = m a_z a/L + m a_x h/L + q A_r  Milliken & Milliken 1995, ch. 18
///     Fy_f + Fy_r = m a_y,   Fy_f a - Fy_r b = I_zz dr/dt                              Guiggiani 2018, ch. 3
///     M = m a_y h - Fy_f d_f - Fy_r d_r                   about the roll axis, d: heights of the roll centres
///     dFz_i t_i = Fy_i d_i + s_i M                        half the difference of right and left, s: share of stiffness
///     Fx = m a_x + q C_D A                                driven axles, or brakes where it is negative
/// The moment of the drag is in the split of the downforce, as a wind tunnel gives it. A load below 0 goes to the other
/// wheel of the axle, the moment that this cannot carry to the other axle, the load of a lifted axle to the other one.
[[nodiscard]] VehicleForces vehicle_forces(const Vehicle& vehicle, const VehicleMotion& motion);

}  // namespace tiretherm::physics
