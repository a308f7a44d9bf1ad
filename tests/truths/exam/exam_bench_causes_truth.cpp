// SPDX-License-Identifier: BSD-3-Clause
// What the benches of layers, of a section and of a laser can hide, cases/practice/section_bench.md and laser_bench.md.
#include <span>

#include "exam/exam_causes_truth.hpp"
#include "laser/laser_bench_truth.hpp"
#include "section/section_truth.hpp"

namespace hidden_effects {

namespace {

using Variants = std::vector<Variant>;

void add_sensors(Variants& variants, std::span<const std::string_view> channels) {
    for (const std::string_view name : channels) {
        const std::string channel(name);
        variants.push_back({.id = "sensor_lag", .channel = channel, .key = "tau", .typical = 5.0, .high = 120.0});
        variants.push_back(
            {.id = "sensor_offset", .channel = channel, .key = "kelvin", .typical = 0.5, .low = -15.0, .high = 15.0});
        variants.push_back(
            {.id = "sensor_gain", .channel = channel, .key = "excess", .typical = 0.02, .low = -0.3, .high = 0.3});
    }
}

/// A third to three times what the case says.
void add_layer(Variants& variants, const std::string& layer) {
    for (const char* id : {"layer_conductivity", "layer_heat_capacity"}) {
        variants.push_back(
            {.id = id, .layer = layer, .key = "scale", .absent = 1.0, .typical = 0.02, .low = 0.3, .high = 3.0});
    }
}

/// What both benches of the tire can have; ranges as of two nodes, and a body radiates at most as a black one.
Variants tire_variants() {
    Variants variants{
        {.id = "sidewall_convection", .key = "conductance", .typical = 0.5, .high = 60.0},
        {.id = "inflation_pressure_rise", .key = "exponent", .typical = 0.1, .high = 2.0},
        {.id = "cornering_loss", .key = "coefficient", .typical = 1e-7, .high = 1e-5},
        {.id = "convection_exponent", .key = "exponent", .absent = 0.571, .typical = 0.02, .low = 0.3, .high = 1.0},
        {.id = "partition_speed", .key = "slope", .typical = 0.02, .low = -0.21, .high = 0.24},
        {.id = "loss_tangent_slope", .key = "slope", .typical = 1e-3, .low = -0.03, .high = 0.03},
        {.id = "load_exponent_of_loss", .key = "exponent", .typical = 0.02, .low = -1.0, .high = 1.0},
        {.id = "slip_input_gain", .key = "gain", .absent = 1.0, .typical = 0.02, .low = 0.3, .high = 3.0},
        {.id = "radiation", .key = "emissivity", .typical = 0.2, .high = 1.0},
        {.id = "road_temperature_drift", .key = "rate", .typical = 5.0, .low = -60.0, .high = 60.0},
        {.id = "air_temperature_drift", .key = "rate", .typical = 2.0, .low = -60.0, .high = 60.0},
        {.id = "camera_emissivity", .key = "emissivity", .absent = 1.0, .typical = -0.02, .low = 0.3, .high = 1.0},
    };
    add_layer(variants, "tread");
    add_layer(variants, "carcass");
    return variants;
}

}  // namespace

const Variants& layers_variants() {
    static const Variants all = [] {
        Variants variants = tire_variants();
        variants.push_back({.id = "inner_gas", .key = "liner", .typical = 0.5, .high = 60.0});
        add_sensors(variants, layers_channels);
        return variants;
    }();
    return all;
}

const Variants& section_variants() {
    static const Variants all = [] {
        Variants variants = tire_variants();
        // Leaning by the 4 degrees of the programmes moves at most half of a shoulder's loss: abs(c gamma) <= 0.56.
        variants.push_back({.id = "camber_asymmetry", .key = "c", .typical = 0.2, .high = 8.0});
        add_sensors(variants, section_channels);
        return variants;
    }();
    return all;
}

const Variants& laser_variants() {
    // The light fades or grows by two thirds in an hour at most; three times the law of a plate is no plate any more; a
    // line of conductivity that turns about 20 degC is still positive at 107 degC with a slope of -0.01/K.
    static const Variants all = [] {
        Variants variants{
            {.id = "laser_absorptivity", .key = "fall", .typical = 0.05, .low = -1.0, .high = 1.0},
            {.id = "laser_spot_size", .key = "scale", .absent = 1.0, .typical = 0.02, .low = 0.5, .high = 2.0},
            {.id = "radiation", .key = "emissivity", .typical = 0.2, .high = 1.0},
            {.id = "natural_convection", .key = "scale", .typical = 0.2, .high = 3.0},
        };
        for (const char* layer : {"tread", "bulk"}) {
            add_layer(variants, layer);
            variants.push_back({.id = "layer_conductivity",
                                .layer = layer,
                                .key = "slope",
                                .typical = 5e-4,
                                .low = -0.01,
                                .high = 0.01});
        }
        for (const char* camera : {"spot_centre_temperature", "spot_mean_temperature"}) {
            variants.push_back({.id = "camera_emissivity",
                                .channel = camera,
                                .key = "emissivity",
                                .absent = 1.0,
                                .typical = -0.02,
                                .low = 0.3,
                                .high = 1.0});
        }
        add_sensors(variants, laser_channels);
        return variants;
    }();
    return all;
}

}  // namespace hidden_effects
