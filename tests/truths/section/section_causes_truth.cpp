// SPDX-License-Identifier: BSD-3-Clause
// Finds the number that a cause sets in the section's equations by its id and channel.

#include "section/section_causes_truth.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hidden_effects {

namespace {

using Channels = std::span<const std::string_view>;

double* find_sensor(SectionCauses& causes, Channels channels, const std::string& name, const std::string& channel) {
    const auto found = std::find(channels.begin(), channels.end(), channel);
    if (found == channels.end()) {
        return nullptr;
    }
    Reading& reading = causes.reading.at(static_cast<std::size_t>(found - channels.begin()));
    const std::map<std::string, double*> by_name{{"sensor_lag.tau", &reading.tau},
                                                 {"sensor_offset.kelvin", &reading.kelvin},
                                                 {"sensor_gain.excess", &reading.excess}};
    const auto number = by_name.find(name);
    return number == by_name.end() ? nullptr : number->second;
}

double* find(SectionCauses& causes, Channels channels, const std::string& name, const std::string& channel) {
    const std::map<std::string, double*> by_name{
        {"camber_asymmetry.c", &causes.camber},
        {"sidewall_convection.conductance", &causes.sidewall},
        {"unknown_inside_sidewall.conductance", &causes.inside_sidewall},
        {"inner_gas.liner", &causes.liner},
        {"inner_gas.rim", &causes.rim},
        {"inflation_pressure_rise.exponent", &causes.pressure},
        {"cornering_loss.coefficient", &causes.cornering},
        {"convection_exponent.exponent", &causes.convection},
        {"partition_speed.slope", &causes.partition},
        {"loss_tangent_slope.slope", &causes.loss_slope},
        {"load_exponent_of_loss.exponent", &causes.load},
        {"road_temperature_drift.rate", &causes.road_rate},
        {"air_temperature_drift.rate", &causes.air_rate},
        {"slip_input_gain.gain", &causes.slip},
        {"radiation.emissivity", &causes.emissivity},
        {"camera_emissivity.emissivity", &causes.reading[0].emissivity},
        {"unknown_inside_shoulder.watts", &causes.shoulder_watts},
        {"unknown_surface.watts", &causes.surface_watts},
        {"unknown_crown.watts", &causes.crown_watts},
    };
    if (const auto found = by_name.find(name); found != by_name.end()) {
        return found->second;
    }
    if (name == "layer_conductivity.scale" || name == "layer_heat_capacity.scale") {
        std::array<double, 2>& scale = name == "layer_conductivity.scale" ? causes.conductivity : causes.capacity;
        return channel == "tread" ? &scale[0] : channel == "carcass" ? &scale[1] : nullptr;
    }
    return find_sensor(causes, channels, name, channel);
}

}  // namespace

SectionCauses gather_section(SectionCauses before, Channels channels, const std::vector<Cause>& causes) {
    SectionCauses gathered = std::move(before);
    gathered.reading.resize(channels.size());
    for (const Cause& cause : causes) {
        for (const auto& [key, value] : cause.parameters) {
            double* number = find(gathered, channels, cause.id + "." + key, cause.channel);
            if (number == nullptr) {
                throw std::invalid_argument("the section knows no " + cause.id + "." + key + " on '" + cause.channel +
                                            "'");
            }
            *number = value;
        }
    }
    return gathered;
}

}  // namespace hidden_effects
