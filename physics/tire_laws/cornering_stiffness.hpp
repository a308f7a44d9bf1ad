// SPDX-License-Identifier: BSD-3-Clause
// Cornering stiffness against bulk temperature: CP = E_eq l^2/2, 1/E_eq = 1/E_l + 1/E_T, lambda_Tb = CP/|K_ref| (thesis
// (52), (59), (60), (69)-(71), errata E12, E13, E17).
#pragma once

#include "physics/tire.hpp"

namespace tiretherm::physics {

/// A value and how it changes with temperature.
struct WithSlope {
    double value = 0.0;
    double by_temperature = 0.0;  ///< per K
};

/// Equivalent circumferential modulus of a tire: belt and tread as two springs in series, 1/E_eq = 1/E_l + 1/E_T. The
/// belt's modulus depends on the contact length, the tread's on the bulk temperature:
///     E_l = E_max - dE + dE / (1 + exp(slope (l_t - l)))                                 thesis (69), erratum E12
///     E_T = E_mid + (dE_T/2) s,  s = -sgn(x) (1 - exp(-a |x|)),  x = T - T_g,  a = -2 ln(0.003)/dT
///                                                                                    thesis (70)(71), erratum E17
/// The thesis prints none of the numbers: its users tune them to two cornering tests at different temperatures. The
/// defaults are assumptions for its 225/50 R17:
/// - at 4000 N (l = 96.7 mm) and 70 degC CP is 1.21e5 N/rad, 30 times the load, that is E_eq = 2 CP / l^2 = 26 MPa.
///   It is not measured on this tire and stiff: a public set of a car tire (pKy1 21.92, pKy2 2.00) has 17.5 times its
///   nominal load. E_max, dE, E_mid and dE_T times one factor are CP times that factor;
/// - 15 K about 70 degC change CP by a tenth there, as two procedures of the thesis 15 K apart do;
/// - the tread has two fifths of the compliance there, so E_T = 66 MPa has to fall by 1.6 % per K, which with the
///   loss-tangent peak T_g = -8 degC and a transition of 300 K makes it 1.17 GPa deep in the glass (rubber: about
///   1 GPa) and 38 MPa when hot;
/// - E_l makes CP against the load follow sin(2 atan(Fz / 8 kN)), Magic Formula sets of car tires having their largest
///   stiffness at about twice their nominal load: within 8 % from 2 to 7 kN. The slope is negative: a long contact
///   bends the belt more.
struct EquivalentModulus {
    double E_max = 3.30e8;  ///< Pa, of the belt
    double dE = 3.10e8;     ///< Pa, < E_max; fall of the belt's modulus from short to long contacts
    double slope = -54.0;   ///< 1/m
    double l_t = 0.050;     ///< m, contact length of half the fall
    double E_mid = 6.03e8;  ///< Pa, of the tread at T_g
    double dE_T = 1.13e9;   ///< Pa, < 2 E_mid; from glass to rubber
    double T_g = 265.15;    ///< K, peak of the loss tangent, -8 degC
    double dT = 300.0;      ///< K, > 0; width of the transition

    /// @param contact_length m  @returns Pa
    [[nodiscard]] double belt(double contact_length) const;
    /// @param T_bulk K
    [[nodiscard]] WithSlope tread(double T_bulk) const;
    /// E_eq. @param contact_length m  @param T_bulk K  @returns Pa
    [[nodiscard]] WithSlope value(double contact_length, double T_bulk) const;
};

/// Cornering stiffness of the tire at a bulk temperature: CP = E_eq l^2 / 2.                          thesis (52)
/// @param T_bulk K  @returns N/rad, positive, with its change per K; 0 without contact
[[nodiscard]] WithSlope cornering_stiffness(const EquivalentModulus& modulus, const Tire& tire, double vertical_load,
                                            double T_bulk);

/// Scaling factor on a Magic Formula's cornering stiffness: lambda_Tb = CP(Fz, T_b) / |K_ref(Fz, gamma)|.
///                                                                                thesis (59)(60), erratum E13
/// Applied to K_ref it *replaces* the stiffness by CP, camber included, and keeps its sign (that of the axis system of
/// the coefficients). It stays near 1 only where CP was tuned to K_ref.
/// @param CP N/rad  @param K_ref N/rad  @returns 1 where K_ref is 0
[[nodiscard]] double bulk_temperature_factor(double CP, double K_ref);

}  // namespace tiretherm::physics
