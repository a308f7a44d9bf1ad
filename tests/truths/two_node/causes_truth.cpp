// SPDX-License-Identifier: BSD-3-Clause
// Finds the number that a parameter of a cause sets in the bench's equations.

#include "two_node/causes_truth.hpp"

#include <stdexcept>

namespace hidden_effects {

namespace {

/// The number of `causes` that a parameter of a cause sets, or null.
double* find(Causes& causes, const std::string& id, const std::string& key, const std::string& channel) {
    const std::string name = id + "." + key;
    const std::map<std::string, double*> by_name{
        {"sidewall_convection.conductance", &causes.sidewall},
        {"inner_gas.liner", &causes.liner},
        {"inner_gas.rim", &causes.rim},
        {"inflation_pressure_rise.exponent", &causes.pressure},
        {"cornering_loss.coefficient", &causes.cornering},
        {"convection_exponent.exponent", &causes.convection},
        {"partition_speed.slope", &causes.partition},
        {"loss_tangent_slope.slope", &causes.loss_slope},
        {"load_exponent_of_loss.exponent", &causes.load},
        {"standing_wave.gain", &causes.wave},
        {"standing_wave.critical_speed", &causes.critical},
        {"road_temperature_drift.rate", &causes.road_rate},
        {"air_temperature_drift.rate", &causes.air_rate},
        {"layer_heat_capacity.scale", &causes.capacity},
        {"layer_conductivity.scale", &causes.conductivity},
        {"slip_input_gain.gain", &causes.slip},
        {"camera_emissivity.emissivity", &causes.surface.emissivity},
        {"unknown_surface.watts", &causes.surface_watts},
        {"unknown_bulk.watts", &causes.bulk_watts},
    };
    if (const auto found = by_name.find(name); found != by_name.end()) {
        return found->second;
    }
    if (channel != "surface_temperature" && channel != "bulk_temperature") {
        return nullptr;
    }
    Reading& reading = channel == "surface_temperature" ? causes.surface : causes.bulk;
    const std::map<std::string, double*> by_sensor{{"sensor_lag.tau", &reading.tau},
                                                   {"sensor_offset.kelvin", &reading.kelvin},
                                                   {"sensor_gain.excess", &reading.excess}};
    const auto found = by_sensor.find(name);
    return found == by_sensor.end() ? nullptr : found->second;
}

}  // namespace

Causes gather(const std::vector<Cause>& causes) {
    Causes gathered;
    for (const Cause& cause : causes) {
        for (const auto& [key, value] : cause.parameters) {
            double* number = find(gathered, cause.id, key, cause.channel);
            if (number == nullptr) {
                throw std::invalid_argument("the bench knows no " + cause.id + "." + key + " on channel '" +
                                            cause.channel + "'");
            }
            *number = value;
        }
    }
    return gathered;
}

}  // namespace hidden_effects
