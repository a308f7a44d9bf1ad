// SPDX-License-Identifier: BSD-3-Clause
// Heat from the tread to the air: q = lambda_h max(floor, h_forced + h_exp) (S_tot - S_cont) (T_air - T_surf), h_exp =
// min(8.59e-11 exp(0.0879 T_surf), exponential_limit h_forced) (thesis (31)-(33), (35), errata E4, E9; the bound is ours).

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "physics/celsius.hpp"
#include "physics/convection.hpp"
#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t {
    lambda_h,
    coefficient,
    exponent,
    exponential_factor,
    exponential_rate,
    clamp_low,
    clamp_high,
    floor_h,
    air_conductivity,
    air_viscosity,
    exponential_limit
};
enum : std::size_t { exponential };
enum : int { bounded, unbounded, off };

constexpr std::array parameters{
    ParameterSpec{"lambda_h", "1", 1.0, 0.0, 10.0, "scale of the whole coefficient, the floor included"},
    ParameterSpec{"coefficient", "1", 0.318, 0.0, 10.0, "coefficient of the Nusselt law (32)"},
    ParameterSpec{"exponent", "1", 0.571, 0.0, 2.0, "exponent of the Reynolds number in (32)"},
    ParameterSpec{"exponential_factor", "W m-2 K-1", 8.59e-11, 0.0, 1.0, "factor of the exponential term of (33)"},
    ParameterSpec{"exponential_rate", "K-1", 0.0879, 0.0, 1.0, "rate of the exponential term of (33)"},
    ParameterSpec{"clamp_low", "K", 0.0, 0.0, 1000.0, "surface temperature below which the exponential is held"},
    ParameterSpec{"clamp_high", "K", 1000.0, 0.0, 1000.0, "surface temperature above which the exponential is held"},
    ParameterSpec{"floor", "W m-2 K-1", 30.0, 0.0, 1000.0, "natural convection: the sum of (33) never falls below it"},
    ParameterSpec{"air_conductivity", "W m-1 K-1", 0.025, 1e-4, 1.0, "conductivity of air"},
    ParameterSpec{"air_viscosity", "m2 s-1", 1.5e-5, 1e-7, 1e-3, "kinematic viscosity of air"},
    ParameterSpec{"exponential_limit", "1", 2.0, 0.0, 1e6,
                  "most that a bounded exponential term adds, over the forced part; assumed"},
};
constexpr std::string_view above =
    "the air film compensates for a missing heat path: try sidewall_convection, inner_gas or resolved_contact, or run "
    "diagnose";
constexpr std::string_view below =
    "the air film compensates for another error of the heat balance: look at road_contact and at sources that are off, "
    "or run diagnose";
constexpr std::array plausible{
    PlausibleRange{"lambda_h", 0.5, 2.0,
                   "published laws beside the thesis's (32): Hilpert -27 % at 20 km/h to +36 % at 250 km/h, 5.9 + 3.7 "
                   "V of a racing simulation +68 % at 100 km/h",
                   "no air film is that far from the law: another loss is missing, or heat is made that is not there",
                   SensorKind::any, above, below},
    PlausibleRange{"coefficient", 0.16, 0.64, "half to twice the thesis's 0.318, as lambda_h",
                   "no air film is that far from the law: another loss is missing, or heat is made that is not there",
                   SensorKind::any, above, below},
    PlausibleRange{"exponent", 0.5, 0.85,
                   "laminar 0.5 to turbulent 0.8 (boundary layers), Hilpert's cylinder 0.805 at Re > 40 000",
                   "no flow over a body follows such a power of the speed"},
    PlausibleRange{"floor", 5.0, 40.0, "still air 5 to 10 W/(m2 K); the thesis 30",
                   "natural convection with radiation is not stronger than that"},
};
constexpr std::array<std::string_view, 3> ways{"bounded", "on", "off"};
constexpr std::array choices{Choice{
    "exponential", ways,
    "the exponential term of (33): bounded by exponential_limit times the forced part; on, as the thesis has it, "
    "without bound; or off"}};
constexpr std::array<std::string_view, 3> reads{"speed", "vertical_load", "air_temperature"};
constexpr std::array<std::string_view, 2> may_read{"inflation_pressure", "slip_speed"};
constexpr std::array<std::string_view, 1> patches{"outside"};

ForcedConvection forced_of(const ActiveEffect& active) {
    return {.coefficient = active[coefficient],
            .exponent = active[exponent],
            .air_conductivity = active[air_conductivity],
            .air_viscosity = active[air_viscosity]};
}

/// Of the air along the tread: the thesis's V, or that of a wheel that spins on the spot; a slip ratio leaves V.
double speed_of_air(const Inputs& inputs) {
    return std::max(std::abs(inputs.speed), std::abs(inputs.speed + inputs.slip_speed));
}

double reynolds_in_millions(const ActiveEffect& active, const Tire& tire, const Inputs& inputs) {
    return 1e-6 * forced_of(active).reynolds(tire, speed_of_air(inputs));
}

/// Re of 1e4 to 1e6, where the thesis fitted (32).
constexpr std::array compared{
    ComparedRange{"", 0.01, 1.0, "fitted", "million (Reynolds number)", reynolds_in_millions}};

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const double area = point.tire.outer_area() - point.tire.contact_area(point.inputs);
    out[0] = area;
    out[1] = area * point.laws.forced * forced_of(active)(point.tire, speed_of_air(point.inputs));
    out[2] = point.inputs.air_temperature;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const ActiveEffect& active = m.active;
    const double area = m.coefficients[0];
    if (area <= 0.0) {
        return;
    }
    const double h_forced = m.coefficients[1] / area;
    for (const int patch : active.patches) {
        const mesh::Patch& outside = m.mesh.patches[static_cast<std::size_t>(patch)];
        const double per_area = area / outside.area();
        for (const mesh::PatchFace& face : outside.faces) {
            const double T = m.temperature[static_cast<std::size_t>(face.node)];
            double h = h_forced;
            double dh_dT = 0.0;
            if (active.choices[exponential] != off) {
                const double held = std::clamp(T, active[clamp_low], active[clamp_high]);
                const double term = active[exponential_factor] * std::exp(active[exponential_rate] * held);
                const double most = active.choices[exponential] == bounded ? active[exponential_limit] * h_forced
                                                                           : std::numeric_limits<double>::infinity();
                h += std::min(term, most);
                dh_dT = held == T && term < most ? active[exponential_rate] * term : 0.0;
            }
            if (h < active[floor_h]) {
                h = active[floor_h];
                dh_dT = 0.0;
            }
            const double scale = active[lambda_h] * per_area * face.area;
            terms.exchange(face.node, scale * h, m.coefficients[2], scale * dh_dT);
        }
    }
}

/// The thesis's surfaces were between 15 and 50 degC; beyond, the exponential doubles every 8 K, and nothing stops it.
std::string range_warning(const ActiveEffect& active, double /*coldest*/, double hottest) {
    constexpr double known_up_to = zero_celsius + 50.0;
    const bool too_hot = hottest > known_up_to && active[clamp_high] > known_up_to;
    if (active.choices[exponential] != unbounded || !too_hot) {
        return {};
    }
    return "air_convection: above 50 degC of the outer surface the exponential of (33) is an extrapolation that "
           "doubles "
           "every 8 K: bound it with exponential = \"bounded\", or hold it with clamp_high";
}

}  // namespace

extern const Effect air_convection;
const Effect air_convection{
    .id = "air_convection",
    .kind = EffectKind::loss,
    .on = true,
    .equation =
        "q = lambda_h max(floor, h_forced + min(8.59e-11 exp(0.0879 T_surf), exponential_limit h_forced)) "
        "(S_tot - S_cont) (T_air - T_surf), h_forced = (k_air/L) 0.318 (V L/nu)^0.571",
    .source = "thesis (31)-(33), (35), errata E4 (kelvin), E9 (floor); the bound is assumed",
    .valid =
        "Re of 1e4 to 1e6, where (32) was fitted on rolling tires (thesis); the exponential from 15 to 50 degC of the "
        "surface; air at 20 degC and atmospheric pressure",
    .meaning =
        "Heat to the air from the part of the tread that does not touch the road. The thesis's exponential term was "
        "fitted to surfaces of 15 to 50 degC on a rolling tire and doubles every 8 K: at 90 degC it alone would be 6 "
        "kW/m2K, also in still air. It is therefore bounded by a multiple of the forced part, so that a parked tire "
        "keeps "
        "the floor; exponential = \"on\" is the thesis's own form. h_forced holds for Re of 1e4 to 1e6.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .choices = choices,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 3,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
            .range_warning = range_warning,
        },
};

}  // namespace tiretherm::physics::effects
