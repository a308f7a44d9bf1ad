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

/// Loads and forces of a rigid car on springs, in equilibrium with its accelerations; q = rho V^2 / 2, L = a + b:
///     Fz_f = m g b/L - m a_x h/L + q A_f,   Fz_r = m g a/L + m a_x h/L + q A_r      Milliken & Milliken 1995, ch. 18
///     Fy_f + Fy_r = m a_y,   Fy_f a - Fy_r b = I_zz dr/dt                              Guiggiani 2018, ch. 3
///     M = m a_y h - Fy_f d_f - Fy_r d_r                   about the roll axis, d: heights of the roll centres
///     dFz_i t_i = Fy_i d_i + s_i M                        half the difference of right and left, s: share of stiffness
///     Fx = m a_x + q C_D A                                driven axles, or brakes where it is negative
/// The moment of the drag is in the split of the downforce, as a wind tunnel gives it. A load below 0 goes to the other
/// wheel of the axle, the moment that this cannot carry to the other axle, the load of a lifted axle to the other one.
[[nodiscard]] VehicleForces vehicle_forces(const Vehicle& vehicle, const VehicleMotion& motion);

}  // namespace tiretherm::physics
