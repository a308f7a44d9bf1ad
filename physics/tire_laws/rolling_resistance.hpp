// SPDX-License-Identifier: BSD-3-Clause
// Rolling resistance: M_y = E R_R/V, F_R = M_y/R_L (thesis (50), (51)); drum and air-temperature corrections (ISO
// 28580); coast-down regression (SAE J2452).
#pragma once

#include "physics/tire.hpp"

namespace tiretherm::physics {

/// Moment about the axle that the dissipated power needs: M_y = E R_R / V.                            thesis (50)
/// @param dissipated_power W  @param speed m/s, its sign does not count  @returns N m, 0 at standing_speed and below
[[nodiscard]] double rolling_moment(const Tire& tire, double dissipated_power, double speed, double vertical_load);

/// Drag of the tire: F_R = M_y / R_L = E R_R / (V R_L).                                               thesis (51)
/// @returns N, 0 at standing_speed and below and without contact
[[nodiscard]] double rolling_drag(const Tire& tire, double dissipated_power, double speed, double vertical_load);

/// Rolling resistance on a drum of another radius: F02 = F01 sqrt((R1/R2) (R2 + r)/(R1 + r)).          ISO 28580
/// By curvatures 1/R, of which the flat road's is 0: F02 = F01 sqrt((1 + r/R2)/(1 + r/R1)).
/// @param measured N, on the drum of curvature `from` 1/m  @param tire_radius m, r, half the nominal diameter
/// @returns N, on the drum of curvature `to` 1/m
[[nodiscard]] double to_drum(double measured, double from, double to, double tire_radius);

/// Rolling resistance that a measurement at another air temperature would have given at 25 degC:
/// F25 = F (1 + K_t (t - 25 degC)).                                                                   ISO 28580
struct AirCorrection {
    double per_kelvin = 0.008;  ///< 1/K, K_t of passenger car tires
    double reference = 298.15;  ///< K

    /// @param measured N  @param air_temperature K
    [[nodiscard]] double to_reference(double measured, double air_temperature) const {
        return measured * (1.0 + per_kelvin * (air_temperature - reference));
    }
};

/// Regression of a coast-down in steps: F = P^alpha Z^beta (a + b V + c V^2).                         SAE J2452
/// The coefficients have the units in which they were fitted; the standard's are N, kPa and km/h.
struct CoastdownLaw {
    double pressure_exponent = 0.0;  ///< alpha, usually negative
    double load_exponent = 0.0;      ///< beta, near 1
    double constant = 0.0;           ///< a
    double linear = 0.0;             ///< b
    double quadratic = 0.0;          ///< c

    /// @param pressure kPa  @param vertical_load N  @param speed km/h  @returns N
    [[nodiscard]] double force(double pressure, double vertical_load, double speed) const;
};

}  // namespace tiretherm::physics
