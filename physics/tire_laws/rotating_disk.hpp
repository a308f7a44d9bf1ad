// SPDX-License-Identifier: BSD-3-Clause
// Film on a disk that turns in still air: Nu_r = 0.36 Re_r^0.5 near the axis, 0.0195 Re_r^0.8 beyond Re_r = w r^2/nu =
// 2.4e5, as means over a ring (Cobb & Saunders 1956).
#pragma once

namespace tiretherm::physics {

/// Dry air at atmospheric pressure, from its temperature in K. Power laws through the value at 300 K; 250 to 400 K
/// within about 1 % of the tables of Incropera & DeWitt (22.3 to 33.8 mW/(m K), 11.44 to 26.41 mm2/s).
struct Air {
    static constexpr double conductivity_exponent = 0.85;
    static constexpr double viscosity_exponent = 1.78;

    /// @returns W/(m K)
    [[nodiscard]] static double conductivity(double T);
    /// @returns m2/s, kinematic
    [[nodiscard]] static double viscosity(double T);
};

/// The film on one face of a smooth disk of even temperature in still air. Where the flow is laminar its coefficient is
/// the same at every radius, h = laminar k sqrt(w/nu); where it is turbulent h = turbulent (k/r) (w r^2/nu)^0.8.
///
/// Cobb & Saunders, Proc. R. Soc. A 236, 1956, 343, measured means of 0.36 Re^0.5 and 0.015 Re^0.8 in air with the
/// transition at 2.4e5 (recalled). A mean over a disk of c Re_r^0.8 is 2/2.6 c Re^0.8: c = 1.3 x 0.015 = 0.0195.
struct RotatingDisk {
    double laminar = 0.36;
    double turbulent = 0.0195;
    double transition = 2.4e5;  ///< Re_r = w r^2/nu at which the flow becomes turbulent

    /// Mean coefficient over a ring as a sum: what its laminar part gives and what its turbulent part gives, both
    /// over the area of the whole ring. W/(m2 K)
    struct Film {
        double laminar = 0.0;
        double turbulent = 0.0;
    };

    /// @param turning rad/s, >= 0  @param inner, outer m, 0 <= inner < outer  @param T K, of the air in the film
    /// Without a jump where the transition enters or leaves the ring.
    [[nodiscard]] Film mean(double turning, double inner, double outer, double T) const;

    /// How the two parts follow the temperature of the film at a given place of the transition: h ~ T^exponent.
    static constexpr double laminar_exponent = Air::conductivity_exponent - 0.5 * Air::viscosity_exponent;
    static constexpr double turbulent_exponent = Air::conductivity_exponent - 0.8 * Air::viscosity_exponent;
};

}  // namespace tiretherm::physics
