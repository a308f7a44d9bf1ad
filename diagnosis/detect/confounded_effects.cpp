// SPDX-License-Identifier: BSD-3-Clause
// The table of confounded groups, and the search for the groups that an effect belongs to.

#include "diagnosis/detect/confounded_effects.hpp"

#include <algorithm>

namespace tiretherm::diagnosis {

std::span<const ConfoundedGroup> confounded_groups() {
    static const std::vector<ConfoundedGroup> all{
        {.members = {"convection_exponent", "groove_convection", "air_convection.lambda_h"},
         .separated = "speed steps over a wide range at constant load: an exponent changes sign at one speed, area and "
                      "level do not; standing still shows none of them"},
        {.members = {"sidewall_convection", "inner_gas", "radiation"},
         .separated = "a channel in the gas or on the liner; a long cool-down: gas gives back for minutes what it "
                      "took, radiation falls with the fourth power, sidewalls do neither"},
        {.members = {"sliding_friction.partition", "sliding_friction.lambda_x", "sliding_friction.lambda_y",
                     "slip_input_gain"},
         .separated = "a second measurement of the slip, or of the forces: temperatures see only the product"},
        {.members = {"load_exponent_of_loss", "strain_energy_loss.tan_delta_a", "drum_curvature"},
         .separated = "load steps at constant speed; the same tire on the drum and on a flat track"},
        {.members = {"loss_tangent_slope", "loss_frequency_shift"},
         .separated = "drag force, or the same speed at different bulk temperatures: a slope follows the temperature, "
                      "a shift the frequency"},
        {.members = {"sensor_lag", "clock_delay"},
         .separated = "a step of the load or the laser: a lag rounds it, a delay moves it; a finer grid, for coarse "
                      "cells lag too"},
        {.members = {"inflation_pressure_rise", "loss_tangent_slope"},
         .separated = "pressure or loaded radius; cold bulk with hot gas, as after a short stop"},
        {.members = {"partition_speed", "slip_input_gain"}, .separated = "the same slip angle at several speeds"},
        {.members = {"layer_conductivity", "layer_heat_capacity"},
         .separated = "a steady state: it sees the conductivity alone"},
        {.members = {"camera_emissivity", "sidewall_convection"},
         .separated = "a contact probe on the surface, or a soak at the temperature of the air"},
        {.members = {"sensor_offset", "sidewall_convection"},
         .separated = "the reading before the start, with the tire at the air's temperature: only an offset shows"},
    };
    return all;
}

std::vector<const ConfoundedGroup*> confounded_groups_of(std::string_view id) {
    std::vector<const ConfoundedGroup*> found;
    for (const ConfoundedGroup& group : confounded_groups()) {
        if (std::ranges::find(group.members, id) != group.members.end()) {
            found.push_back(&group);
        }
    }
    return found;
}

std::string others_of(const ConfoundedGroup& group, std::string_view id) {
    std::string text;
    for (const std::string_view member : group.members) {
        if (member != id) {
            text += (text.empty() ? "" : ", ") + std::string(member);
        }
    }
    return text;
}

}  // namespace tiretherm::diagnosis
