// SPDX-License-Identifier: BSD-3-Clause
// The variants of the two-node bench with their physical ranges, and the cause that belongs to a number.

#include "exam/exam_causes_truth.hpp"

namespace hidden_effects {

const std::vector<Variant>& single_variants() {
    static const std::string camera = "surface_temperature";
    static const std::string probe = "bulk_temperature";
    // Where the range ends: a tire's side loses 10 to 25 W/K and not 60; friction heat is shared between tire and road,
    // so that 0.6 (1 + slope v_s) stays between 0.24 and 1 up to a sliding speed of 2.8 m/s; cornering adds at most 6 kW
    // at 4 kN and 40 m/s; a tire's loss halves in 70 K at most; and nobody trusts a sensor that is off by more.
    static const std::vector<Variant> variants{
        {.id = "sidewall_convection", .key = "conductance", .typical = 0.3, .high = 60.0},
        {.id = "inner_gas", .key = "liner", .typical = 0.5, .high = 60.0},
        {.id = "inflation_pressure_rise", .key = "exponent", .typical = 0.1, .high = 2.0},
        {.id = "cornering_loss", .key = "coefficient", .typical = 1e-7, .high = 1e-5},
        {.id = "convection_exponent", .key = "exponent", .absent = 0.571, .typical = 0.02, .low = 0.3, .high = 1.0},
        {.id = "partition_speed", .key = "slope", .typical = 0.02, .low = -0.21, .high = 0.24},
        {.id = "loss_tangent_slope", .key = "slope", .typical = 1e-3, .low = -0.03, .high = 0.03},
        {.id = "load_exponent_of_loss", .key = "exponent", .typical = 0.02, .low = -1.0, .high = 1.0},
        {.id = "standing_wave", .key = "gain", .typical = 2e-5, .high = 2e-3},
        {.id = "road_temperature_drift", .key = "rate", .typical = 5.0, .low = -60.0, .high = 60.0},
        {.id = "air_temperature_drift", .key = "rate", .typical = 2.0, .low = -60.0, .high = 60.0},
        {.id = "sensor_lag", .channel = camera, .key = "tau", .typical = 2.0, .high = 120.0},
        {.id = "sensor_lag", .channel = probe, .key = "tau", .typical = 5.0, .high = 120.0},
        {.id = "sensor_offset", .channel = camera, .key = "kelvin", .typical = 0.5, .low = -15.0, .high = 15.0},
        {.id = "sensor_offset", .channel = probe, .key = "kelvin", .typical = 0.5, .low = -15.0, .high = 15.0},
        {.id = "sensor_gain", .channel = camera, .key = "excess", .typical = 0.02, .low = -0.3, .high = 0.3},
        {.id = "sensor_gain", .channel = probe, .key = "excess", .typical = 0.02, .low = -0.3, .high = 0.3},
        {.id = "camera_emissivity", .key = "emissivity", .absent = 1.0, .typical = -0.02, .low = 0.3, .high = 1.0},
        {.id = "layer_heat_capacity", .key = "scale", .absent = 1.0, .typical = 0.02, .low = 0.3, .high = 3.0},
        {.id = "layer_conductivity", .key = "scale", .absent = 1.0, .typical = 0.02, .low = 0.3, .high = 3.0},
        {.id = "slip_input_gain", .key = "gain", .absent = 1.0, .typical = 0.02, .low = 0.3, .high = 3.0},
    };
    return variants;
}

bool acts_on_layer(std::string_view id) { return id.starts_with("layer_"); }

std::string name_of(const Cause& cause) {
    return cause.id + (cause.channel.empty() ? "" : (acts_on_layer(cause.id) ? " in " : " of ") + cause.channel);
}

std::string Variant::name() const {
    return name_of(Cause{.id = id, .parameters = {}, .channel = layer.empty() ? channel : layer});
}

Cause cause_of(const Variant& variant, double number, double critical_speed) {
    Cause cause{.id = variant.id,
                .parameters = {{variant.key, number}},
                .channel = variant.layer.empty() ? variant.channel : variant.layer};
    if (variant.id == "inner_gas") {
        cause.parameters["rim"] = number * 4.0 / 9.0;
    }
    if (variant.id == "standing_wave") {
        cause.parameters["critical_speed"] = critical_speed;
    }
    return cause;
}

}  // namespace hidden_effects
