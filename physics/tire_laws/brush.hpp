// SPDX-License-Identifier: BSD-3-Clause
// Brush model of the contact: force F = mu Fz (1 - (1 - |sigma|/sigma_sl)^3), aligning moment and sliding power under a
// parabolic pressure (thesis (1)-(3)).
#pragma once

#include <cstddef>
#include <vector>

namespace tiretherm::physics {

/// Brush model of the contact: bristles on a rigid belt, under a parabolic pressure.                  thesis (1)-(3)
///     q(x) = 3 Fz/(4 a) (1 - (x/a)^2),  x from the leading edge a to the trailing edge -a
/// A bristle enters unbent and is bent by v = sigma (a - x) while it adheres; where that needs more than the friction,
/// c_p v = mu q (1), it slides with v = mu q / c_p to the trailing edge.
/// The slip sigma is that of the rolling speed: tan(alpha) of a slip angle, kappa/(1 + kappa) of a slip ratio
/// (`of_slip_ratio`). Forces have the sign of the slip.
struct Brush {
    double half_length = 0.0;      ///< m, a > 0
    double tread_stiffness = 0.0;  ///< N/m2, c_p > 0: force per contact length and deflection
    double friction = 0.0;         ///< mu >= 0; infinite: every bristle adheres to the trailing edge
    double load = 0.0;             ///< N, Fz

    /// c_p of a tire of cornering (or slip) stiffness C = 2 c_p a^2.                                  thesis (3)
    /// @param stiffness N/rad  @param contact_length m, 2 a  @returns N/m2
    [[nodiscard]] static double tread_stiffness_of(double stiffness, double contact_length) {
        return 2.0 * stiffness / (contact_length * contact_length);
    }
    /// sigma = kappa / (1 + kappa). @param kappa > -1
    [[nodiscard]] static double of_slip_ratio(double kappa) { return kappa / (1.0 + kappa); }

    /// C = 2 c_p a^2                                                                     thesis (3). @returns N/rad
    [[nodiscard]] double stiffness() const { return 2.0 * tread_stiffness * half_length * half_length; }
    /// Slip beyond which the whole contact slides: sigma_sl = 3 mu Fz / (2 c_p a^2).
    [[nodiscard]] double full_sliding_slip() const;
    /// Where adhesion ends: x_t = a (2 |sigma|/sigma_sl - 1), at most a. @returns m, from the middle of the contact
    [[nodiscard]] double adhesion_end(double slip) const;
    /// F = mu Fz (1 - (1 - |sigma|/sigma_sl)^3), from C sigma at a small slip to mu Fz. @returns N
    [[nodiscard]] double force(double slip) const;
    /// M_z = -mu Fz a (|sigma|/sigma_sl) (1 - |sigma|/sigma_sl)^3, from -(2/3) c_p a^3 sigma to 0; of a lateral slip.
    /// @returns N m
    [[nodiscard]] double aligning_moment(double slip) const;

    /// Power that friction turns into heat. What the tire takes up is F V |sigma|; a bristle leaves the contact unbent,
    /// for the pressure ends there, so that under a finite friction all of it is sliding power.
    /// @param rolling_speed m/s, V: V_cx of a slip angle, (1 + kappa) V_cx of a slip ratio  @returns W
    [[nodiscard]] double sliding_power(double slip, double rolling_speed) const;
    /// The part of it that was stored in the bristles where adhesion ends: V c_p (sigma (a - x_t))^2 / 2. @returns W
    [[nodiscard]] double stored_power(double slip, double rolling_speed) const;
    /// Power that bent bristles carry out of the contact, V c_p v(-a)^2 / 2: 0 under a finite friction, all of
    /// F V |sigma| under an infinite one. @returns W
    [[nodiscard]] double released_power(double slip, double rolling_speed) const;
    /// Sliding power in equal slices of the contact, the leading edge first; they sum up to `sliding_power`. @returns W
    [[nodiscard]] std::vector<double> sliding_power_slices(double slip, double rolling_speed, std::size_t slices) const;

private:
    [[nodiscard]] double pressure(double x) const;     ///< N/m
    [[nodiscard]] double load_before(double x) const;  ///< N, of the contact from -a to x
    [[nodiscard]] double sliding_between(double low, double high, double slip) const;  ///< J/m of rolling
};

}  // namespace tiretherm::physics
