#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { exponent, reference, liner, rim, capacity_of_gas };

constexpr std::array parameters{
    Parameter{"exponent", "1", 0.45, 0.0, 3.0,
              "the loss falls with this power of the pressure; 0.4 to 0.5 in the pressure exponents of SAE J2452",
              false, 0.0},
    Parameter{"reference", "K", 294.15, 200.0, 400.0, "gas temperature at which the loss is left as it is"},
    Parameter{"liner", "W K-1", 9.0, 0.0, 1000.0, "conductance from the bulk to the gas of this effect"},
    Parameter{"rim", "W K-1", 4.0, 0.0, 1000.0, "conductance from the gas of this effect to the air"},
    Parameter{"capacity", "J K-1", 70.0, 1.0, 1e5, "heat capacity of the gas of this effect, at constant volume"},
};
constexpr std::array<std::string_view, 1> reads{"air_temperature"};
constexpr std::string_view own = "pressure_gas";

/// A gas of its own that follows the bulk's mean. The joint carries nothing: no heat is taken from the bulk.
void extend(mesh::Mesh& mesh, ActiveEffect& active) {
    const int gas = mesh.append(own);
    const mesh::Functional& bulk = mesh.regions[static_cast<std::size_t>(mesh.find_region("bulk"))].mean;
    active.appended = {gas};
    active.joints = {mesh.add_joint(bulk.nodes.front(), gas, 1.0)};
}

double capacity(const ActiveEffect& active, std::size_t /*index*/) { return active[capacity_of_gas]; }

/// The gas that counts: that of inner_gas when it exchanges heat with the liner, its own otherwise.
void place(const Setting& setting, ActiveEffect& active) {
    const ActiveEffect* inner = setting.find("inner_gas");
    const bool exchanges = inner != nullptr && (*inner)[0] > 0.0 && !inner->appended.empty();
    active.nodes = {exchanges ? inner->appended.front() : active.appended.front()};
}

Factor scale_loss(const Moment& m) {
    const bool is_own = m.active.nodes.front() == m.active.appended.front();
    const int region = m.mesh.find_region(is_own ? own : "gas");
    const double T = m.region_mean[static_cast<std::size_t>(region)];
    const double value = std::pow(T / m.active[reference], -m.active[exponent]);
    return {.value = value, .by_mean = -m.active[exponent] / T * value, .region = region};
}

void drive(const ActiveEffect& /*active*/, const Driving& driving, std::span<double> out) {
    out[0] = driving.inputs.air_temperature;
}

void speak(const Moment& m, Terms& terms) {
    const int gas = m.active.appended.front();
    const int bulk = m.mesh.find_region("bulk");
    terms.exchange(gas, m.active[liner], m.region_mean[static_cast<std::size_t>(bulk)]);
    terms.heat_follows(gas, bulk, m.active[liner]);
    terms.exchange(gas, m.active[rim], m.intensities[0]);
}

}  // namespace

extern const Effect inflation_pressure_rise;
const Effect inflation_pressure_rise{
    .id = "inflation_pressure_rise",
    .kind = Kind::source,
    .equation =
        "SEL' = SEL (T_gas/reference)^-exponent; C dT_gas/dt = liner (T_bulk - T_gas) - rim (T_gas - T_air), "
        "p/p0 = T_gas/T0",
    .source =
        "ideal gas at constant volume; loss ~ p^a of SAE J2452 with a near -0.4 (recalled); conductances and capacity "
        "assumed for a car tire",
    .meaning =
        "Hot gas stiffens the tire: deflection and loss fall over minutes. Its own gas costs the bulk nothing, which "
        "keeps this cause apart from inner_gas; where inner_gas is on, the temperature of that gas counts.",
    .parameters = parameters,
    .reads = reads,
    .needs_tire = true,
    .n_intensities = 1,
    .extend = extend,
    .capacity = capacity,
    .place = place,
    .scale_loss = scale_loss,
    .drive = drive,
    .speak = speak,
};

}  // namespace tiretherm::physics::effects
