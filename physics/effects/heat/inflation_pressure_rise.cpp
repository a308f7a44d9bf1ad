// SPDX-License-Identifier: BSD-3-Clause
// Loss that falls as the gas heats up: SEL' = SEL (p_hot/p)^-exponent, gauge pressures, p_hot of a lumped gas node (ideal
// gas at constant volume; pressure exponents of SAE J2452). Without a pressure, absolute ones: (T_gas/reference)^-exponent.

#include <algorithm>
#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { exponent, reference, liner, rim, capacity_of_gas };

constexpr std::array parameters{
    ParameterSpec{"exponent", "1", 0.45, 0.0, 3.0,
                  "the loss falls with this power of the pressure; 0.4 to 0.5 in the pressure exponents of SAE J2452",
                  false, 0.0},
    ParameterSpec{"reference", "K", 294.15, 200.0, 400.0, "gas temperature at which the loss is left as it is"},
    ParameterSpec{"liner", "W K-1", 9.0, 0.0, 1000.0, "conductance from the bulk to the gas of this effect"},
    ParameterSpec{"rim", "W K-1", 4.0, 0.0, 1000.0, "conductance from the gas of this effect to the air"},
    ParameterSpec{"capacity", "J K-1", 70.0, 1.0, 1e5, "heat capacity of the gas of this effect, at constant volume"},
};
constexpr std::array confounded{
    ConfoundedGroup{{"inflation_pressure_rise", "loss_tangent_slope"},
                    "pressure or loaded radius; cold bulk with hot gas, as after a short stop"}};
constexpr std::array plausible{
    PlausibleRange{"exponent", 0.0, 1.0, "SAE J2452: 0.4 to 0.5, tires from 0.2 to 0.8; recalled",
                   "no tire's loss follows its pressure like that: the loss changes with temperature otherwise"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::array<std::string_view, 1> may_read{"inflation_pressure"};
constexpr double atmosphere = 101325.0;  // Pa
enum : std::size_t { to_air, pressure };
constexpr std::string_view own = "pressure_gas";
constexpr double least_pressure = 0.1;  ///< of that at the reference: the law knows no flat tire

/// A gas of its own that follows the bulk's mean. The coupling face carries nothing: no heat is taken from the bulk.
void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int gas = mesh.add_lumped_node(own);
    const mesh::Functional& bulk = mesh.regions[static_cast<std::size_t>(mesh.find_region("bulk"))].mean;
    active.lumped_nodes = {gas};
    active.coupling_faces = {mesh.add_coupling_face(bulk.nodes.front(), gas, 1.0)};
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_gas]; }

/// The gas that counts: that of inner_gas when it exchanges heat with the liner, its own otherwise.
void place(const PlacementContext& context, ActiveEffect& active) {
    const ActiveEffect* inner = context.find("inner_gas");
    const bool exchanges = inner != nullptr && (*inner)[0] > 0.0 && !inner->lumped_nodes.empty();
    active.nodes = {exchanges ? inner->lumped_nodes.front() : active.lumped_nodes.front()};
}

/// A heat effect that carries a law of the loss: the gas whose temperature the law follows is a node that this effect
/// adds and heats, so that the two cannot be switched on apart.
LossFactor scale_loss(const EvaluationState& m) {
    const bool is_user_effect = m.active.nodes.front() == m.active.lumped_nodes.front();
    const int region = m.mesh.find_region(is_user_effect ? own : "gas");
    const double T = m.region_mean[static_cast<std::size_t>(region)];
    // Gauge pressure over that at the reference temperature, or absolute where none is given; straight in T.
    const double cold = m.coefficients[pressure];
    const double per_kelvin = (cold > 0.0 ? (cold + atmosphere) / cold : 1.0) / m.active[reference];
    const double relative = std::max(least_pressure, 1.0 + per_kelvin * (T - m.active[reference]));
    const double value = std::pow(relative, -m.active[exponent]);
    const double slope = relative > least_pressure ? -m.active[exponent] * value / relative * per_kelvin : 0.0;
    return {.value = value, .dvalue_dT_mean = slope, .region = region};
}

void evaluate_coefficients(const ActiveEffect& /*active*/, const OperatingPoint& point, std::span<double> out) {
    out[to_air] = point.inputs.air_temperature;
    out[pressure] = point.inputs.inflation_pressure;
}

void add_terms(const EvaluationState& m, Terms& terms) {
    const int gas = m.active.lumped_nodes.front();
    const int bulk = m.mesh.find_region("bulk");
    terms.exchange(gas, m.active[liner], m.region_mean[static_cast<std::size_t>(bulk)]);
    terms.add_source_derivative(gas, bulk, m.active[liner]);
    terms.exchange(gas, m.active[rim], m.coefficients[to_air]);
}

}  // namespace

extern const Effect inflation_pressure_rise;
const Effect inflation_pressure_rise{
    .id = "inflation_pressure_rise",
    .kind = EffectKind::source,
    .equation =
        "SEL' = SEL (p_hot/p)^-exponent, p_hot = (p + p_atm) T_gas/reference - p_atm; C dT_gas/dt = liner (T_bulk - "
        "T_gas) "
        "- rim (T_gas - T_air)",
    .source =
        "ideal gas at constant volume; loss ~ p^a of SAE J2452 with a near -0.4 (recalled); conductances and capacity "
        "assumed for a car tire",
    .valid = "a constant mass and volume of gas; pressures of 0.5 to 1.7 times the cold one, of J2452's tests",
    .meaning =
        "Hot gas stiffens the tire: deflection and loss fall over minutes. Its own gas is the memory of this law: it "
        "costs "
        "the bulk nothing, which keeps this cause apart from inner_gas, and no heat budget counts it; where inner_gas "
        "is on, the temperature of that gas counts. "
        "inflation_pressure is that of the gas at `reference`; without it the ratio is that of absolute pressures, "
        "T_gas/reference. A pressure that was measured on the hot tire has the rise in it: the laws of [tire] follow "
        "it by "
        "themselves, and this effect stays off.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .reads = reads,
    .may_read = may_read,
    .needs_tire = true,
    .model =
        HeatEffect{
            .is_memory = true,
            .n_coefficients = 2,
            .extend = extend,
            .capacity = capacity,
            .place = place,
            .scale_loss = scale_loss,
            .evaluate_coefficients = evaluate_coefficients,
            .add_terms = add_terms,
        },
};

}  // namespace tiretherm::physics::effects
