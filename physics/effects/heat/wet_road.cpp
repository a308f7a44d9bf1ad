// SPDX-License-Identifier: BSD-3-Clause
// Heat into water on the road: q = wet rho d W V (heated c_w + evaporated L) (T_road - T_surf), the enthalpy balance of
// the film, derived in this file.

#include <array>
#include <cmath>

#include "physics/spread.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { film_depth, heated, evaporated, density, heat_capacity, latent_heat };

// The contact, W = S_cont/l wide, meets rho d W V of water a second: 0.27 kg/s for a film of 0.1 mm at 100 km/h and 96.5 mm
// (93 cm2 over 96.7 mm, the tire at 4 kN), which could carry 1.12 kW/K. Rubber that meets cold water for the l/V = 3.5 ms of a
// contact gives 2 e/sqrt(pi t) = 14 kW/m2K with e = 758 W s^0.5/(m2 K), 135 W/K on 93 cm2: 0.12 of the film are heated
// through. The evaporated share is a guess.
constexpr std::array parameters{
    ParameterSpec{"film_depth", "m", 1e-4, 0.0, 0.02, "water on the road; 0.05 to 1 mm", false, 0.0},
    ParameterSpec{"heated", "1", 0.12, 0.0, 1.0, "share of the film that leaves at the tire's temperature; estimated"},
    ParameterSpec{"evaporated", "K-1", 1e-5, 0.0, 1.0, "share that evaporates per kelvin of tire over film; assumed"},
    ParameterSpec{"density", "kg m-3", 998.0, 1.0, 1e4, "density of water"},
    ParameterSpec{"heat_capacity", "J kg-1 K-1", 4186.0, 1.0, 1e5, "specific heat of water"},
    ParameterSpec{"latent_heat", "J kg-1", 2.45e6, 0.0, 1e7, "heat of evaporation at 20 degC"},
};
constexpr std::array plausible{
    PlausibleRange{"film_depth", 0.0, 0.002, "wet roads carry 0.05 to 1 mm, puddles more; recalled",
                   "a tire at speed would float: the road was not that wet"},
};
constexpr std::array<std::string_view, 4> reads{"speed", "vertical_load", "road_temperature", "wet"};
constexpr std::array<std::string_view, 1> may_read{"inflation_pressure"};
constexpr std::array<std::string_view, 1> patches{"outside"};

void place(const PlacementContext& context, ActiveEffect& active) { spread_over_patches(context, active); }

void evaluate_coefficients(const ActiveEffect& active, const OperatingPoint& point, std::span<double> out) {
    const Inputs& in = point.inputs;
    double film = 0.0;  // kg/s
    if (point.tire.touches(in.vertical_load)) {
        const double width = point.tire.contact_area(in) / point.tire.contact_length(in);
        film = active[density] * active[film_depth] * width * std::abs(in.speed);
    }
    out[0] = in.wet * film * (active[heated] * active[heat_capacity] + active[evaporated] * active[latent_heat]);
    out[1] = out[0] * in.road_temperature;
}

}  // namespace

extern const Effect wet_road;
const Effect wet_road{
    .id = "wet_road",
    .kind = EffectKind::loss,
    .equation = "q = wet rho d W V (heated c_w + evaporated L) (T_road - T_surf), W = S_cont/l",
    .source = "enthalpy balance of the film, this file; latent heat of water at 20 degC",
    .valid =
        "films of 0.05 to 1 mm that do not lift the tire (no aquaplaning); the shares that are heated and that "
        "evaporate are assumed, to be fitted",
    .meaning =
        "Water that the tire heats and partly evaporates, at the road's temperature when they meet. Follows the flag "
        "`wet` and the speed; the surface falls as a step when the rain begins.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .patches = patches,
    .model =
        HeatEffect{
            .n_coefficients = 2,
            .place = place,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = exchange_by_weights,
        },
};

}  // namespace tiretherm::physics::effects
