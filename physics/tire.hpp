// SPDX-License-Identifier: BSD-3-Clause
// Dimensions of a tire and its laws: contact length and area, radii, loss tangent, power of the strain-energy loss
// (thesis (35), (37)-(49), (57), (62), (66)-(68), errata E1 to E3, E5, E7, E8, E16), and how they follow the inflation
// pressure (Rhyne 2005; SAE J2452).
#pragma once

#include <optional>
#include <string>

#include "physics/curve.hpp"
#include "physics/signals.hpp"

namespace tiretherm::physics {

/// Dimensions and load laws of a tire. The default values are the thesis's 225/50 R17; each law may be replaced by a
/// measured table against the vertical load in N.
struct Tire {
    std::string name = "225/50 R17";
    double width = 0.225;               ///< m, W
    double section_height = 0.1125;     ///< m, H = aspect ratio * W (65)
    double unloaded_radius = 0.3308;    ///< m, R0
    double tread_thickness = 0.012;     ///< m, through crown and tread
    double sidewall_thickness = 0.009;  ///< m
    double density = 1100.0;            ///< kg/m3
    double minimum_load = 1.0;          ///< N, below it the tire is not in contact

    double contact_length_limit = 0.160;      ///< m, l_max of (57)
    double contact_length_slope = 0.35;       ///< 1/kN, k of (57)
    double contact_area_at_zero = 0.0;        ///< m2, A of (35)
    double contact_area_slope = 2.333e-6;     ///< m2/N, B of (35)
    double loaded_radius_at_zero = 0.3308;    ///< m
    double loaded_radius_slope = -4.2e-6;     ///< m/N
    double rolling_radius_factor = 0.3483;    ///< m at 1 N
    double rolling_radius_exponent = -0.009;  ///< 1

    /// Pa above the atmosphere at which the laws of the load hold; 0: they do not follow the pressure.
    double reference_pressure = 0.0;
    double pressure_exponent_of_loss = 0.45;  ///< 1, the loss falls with this power of the pressure
    double loss_drum_diameter = 0.0;          ///< m, of the drum on which the loss was measured; 0: a flat road
    std::optional<Curve> contact_length_table;
    std::optional<Curve> contact_area_table;
    std::optional<Curve> loaded_radius_table;
    std::optional<Curve> rolling_radius_table;

    [[nodiscard]] bool touches(double vertical_load) const { return vertical_load > minimum_load; }
    /// l = l_max - 2 l_max / (1 + exp(k Fz))                                     thesis (57), erratum E2. @returns m
    [[nodiscard]] double contact_length(double vertical_load) const;
    /// S_cont = A + B Fz, 0 without contact, never beyond the tire's surface          thesis (35). @returns m2
    [[nodiscard]] double contact_area(double vertical_load) const;
    /// R_L = A + B Fz                                                       thesis (37). @returns m
    [[nodiscard]] double loaded_radius(double vertical_load) const;
    /// R_R = A (Fz / 1 N)^B                                           thesis (62), erratum E5. @returns m
    [[nodiscard]] double rolling_radius(double vertical_load) const;
    /// S_tot = 2 pi R0 W                                                    thesis (35). @returns m2
    [[nodiscard]] double outer_area() const;
    /// m = rho 2 pi R0 W h: the crown band only                         thesis (68), erratum E16. @returns kg
    [[nodiscard]] double band_mass() const;
    /// A_CS / A_VC with A_CS = W h_tread + 2 h_sidewall (H - h_tread)    thesis (39)(66)(67), erratum E3
    [[nodiscard]] double area_ratio() const;
    /// Revolutions per second V / (2 pi R_R)                              thesis (47). @returns Hz
    [[nodiscard]] double revolutions(double speed, double vertical_load) const;

    /// Vertical stiffness of a radial tire of these dimensions, by Rhyne's formula (tire_laws/scaled_tire.hpp).
    /// @param pressure Pa above the atmosphere  @returns N/m
    [[nodiscard]] double vertical_stiffness(double pressure) const;
    /// The load that deflects the tire at its reference pressure as the vertical load does at the pressure of the moment:
    /// Fz K_z(reference_pressure) / K_z(p). Contact length and area and the radii follow the deflection, and with it this
    /// load. The vertical load itself without a reference pressure. @returns N
    [[nodiscard]] double reference_load(const Inputs& inputs) const;
    /// The laws of the load at the pressure of a moment.
    [[nodiscard]] double contact_length(const Inputs& inputs) const { return contact_length(reference_load(inputs)); }
    /// 0 without contact
    [[nodiscard]] double contact_area(const Inputs& inputs) const {
        return touches(inputs.vertical_load) ? contact_area(reference_load(inputs)) : 0.0;
    }
    [[nodiscard]] double loaded_radius(const Inputs& inputs) const { return loaded_radius(reference_load(inputs)); }
    [[nodiscard]] double rolling_radius(const Inputs& inputs) const { return rolling_radius(reference_load(inputs)); }
    /// Of the tire as it rolls, at `rolling_speed`. @returns Hz
    [[nodiscard]] double revolutions(const Inputs& inputs) const {
        return revolutions(rolling_speed(inputs), reference_load(inputs));
    }
    /// How the loss follows the pressure: (p / reference_pressure)^-pressure_exponent_of_loss, 1 without a reference;
    /// below a fifth of the reference it is held. SAE J2452, whose exponents of the pressure are -0.4 to -0.5 (recalled).
    [[nodiscard]] double pressure_factor_of_loss(double pressure) const;
    /// 1 / radius of the drum on which the loss was measured. @returns 1/m, 0 of a flat road
    [[nodiscard]] double curvature_of_loss() const { return loss_drum_diameter > 0.0 ? 2.0 / loss_drum_diameter : 0.0; }

    friend bool operator==(const Tire&, const Tire&) = default;
};

/// Loss tangent of the compound: a Gaussian of an equivalent temperature that WLF shifts with frequency.
///     T_eq = T + C2 log10(f/f0) / (C1 - log10(f/f0)),   tan delta = a exp(-((T_eq - b)/c)^2)
/// thesis (48)(49), errata E1 (kelvin), E7 (sign)
/// In the cold the Gaussian alone would go on rising. Rubber's loss has a peak near its glass transition instead: below
/// the peak at 265.15 K it falls as it rose, and within 8 K of the peak a parabola joins the two branches smoothly. A
/// Gaussian with b above that temperature has a peak of its own and stays as it is.
struct LossTangent {
    double a = 2.14e15;
    double b = -4989.0;  ///< K
    double c = 882.0;    ///< K
    double f0 = 52.0;    ///< Hz
    double C1 = -8.86;   ///< 1
    double C2 = 101.6;   ///< K
    /// K, the equivalent temperature of the peak; 0: the Gaussian alone. -8 degC is that of the thesis's figure (5).
    double peak = 265.15;

    /// @param frequency Hz, > 0  @returns K, added to the temperature
    [[nodiscard]] double shift(double frequency) const;
    /// @param T_eq K
    [[nodiscard]] double value(double T_eq) const;
    /// Its logarithmic derivative d ln(tan delta)/dT. @returns 1/K
    [[nodiscard]] double log_slope(double T_eq) const;

private:
    /// Where on the Gaussian the loss is that of an equivalent temperature, and the derivative of the one with the other.
    struct Place {
        double T = 0.0;
        double dT = 1.0;
    };
    [[nodiscard]] Place on_gaussian(double T_eq) const;
};

/// Power lost per unit of loss tangent: Fz eps Ratio H (2 pi R0 / l) (V / (2 pi R_R))   thesis (37)-(47). @returns W
/// 0 at rest and without contact (erratum E8).
[[nodiscard]] double strain_power(const Tire& tire, double speed, double vertical_load);
/// The same at the rolling speed and the inflation pressure of a moment.
[[nodiscard]] double strain_power(const Tire& tire, const Inputs& inputs);

/// Speed below which the tire counts as standing. m/s
inline constexpr double standing_speed = 0.1;

}  // namespace tiretherm::physics
