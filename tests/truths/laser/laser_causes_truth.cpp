// SPDX-License-Identifier: BSD-3-Clause
// Finds the number that a cause sets in the laser's equations by its id and channel.

#include "laser/laser_causes_truth.hpp"

#include <algorithm>
#include <stdexcept>

namespace hidden_effects {

namespace {

double* find_sensor(LaserCauses& causes, const std::string& name, const std::string& channel) {
    const auto found = std::find(laser_channels.begin(), laser_channels.end(), channel);
    if (found == laser_channels.end()) {
        return nullptr;
    }
    Reading& reading = causes.reading.at(static_cast<std::size_t>(found - laser_channels.begin()));
    const std::map<std::string, double*> by_name{{"sensor_lag.tau", &reading.tau},
                                                 {"sensor_offset.kelvin", &reading.kelvin},
                                                 {"sensor_gain.excess", &reading.excess},
                                                 {"camera_emissivity.emissivity", &reading.emissivity}};
    const auto number = by_name.find(name);
    return number == by_name.end() ? nullptr : number->second;
}

double* find(LaserCauses& causes, const std::string& name, const std::string& channel) {
    const std::map<std::string, double*> by_name{
        {"laser_absorptivity.factor", &causes.absorbed}, {"laser_absorptivity.fall", &causes.fall},
        {"laser_spot_size.scale", &causes.spot},         {"radiation.emissivity", &causes.emissivity},
        {"natural_convection.scale", &causes.natural},   {"unknown_lamp.watts", &causes.lamp_watts},
        {"unknown_hours.watts", &causes.hourly_watts}};
    if (const auto found = by_name.find(name); found != by_name.end()) {
        return found->second;
    }
    const std::map<std::string, std::array<double, 2>*> by_layer{
        {"layer_conductivity.scale", &causes.conductivity},
        {"layer_conductivity.slope", &causes.conductivity_slope},
        {"layer_heat_capacity.scale", &causes.capacity}};
    if (const auto found = by_layer.find(name); found != by_layer.end()) {
        std::array<double, 2>& layers = *found->second;
        return channel == "tread" ? &layers[0] : channel == "bulk" ? &layers[1] : nullptr;
    }
    return find_sensor(causes, name, channel);
}

}  // namespace

LaserCauses gather_laser(const std::vector<Cause>& causes) {
    LaserCauses gathered;
    for (const Cause& cause : causes) {
        for (const auto& [key, value] : cause.parameters) {
            double* number = find(gathered, cause.id + "." + key, cause.channel);
            if (number == nullptr) {
                throw std::invalid_argument("the laser's bench knows no " + cause.id + "." + key + " on '" +
                                            cause.channel + "'");
            }
            *number = value;
        }
    }
    return gathered;
}

}  // namespace hidden_effects
