// SPDX-License-Identifier: BSD-3-Clause
// The catalogue as a whole: which effects it holds, and that their order does not matter.
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "physics/effects/effect_contract.hpp"

namespace tiretherm::physics {

TEST(Catalogue, HoldsTheseEffectsAndNoOther) {
    const std::set<std::string_view> thesis_model{
        "conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact", "laser", "still_air"};
    const std::set<std::string_view> extensions{"sidewall_convection",
                                                "inner_gas",
                                                "rim_conduction",
                                                "camber_asymmetry",
                                                "pressure_across_tread",
                                                "brake_heat",
                                                "cornering_loss",
                                                "inflation_pressure_rise",
                                                "groove_convection",
                                                "radiation",
                                                "natural_convection",
                                                "road_temperature_drift",
                                                "air_temperature_drift",
                                                "wet_road",
                                                "resolved_contact",
                                                "travelling_contact",
                                                "contact_pressure_conductance",
                                                "convection_exponent",
                                                "wind",
                                                "partition_speed",
                                                "loss_tangent_slope",
                                                "loss_frequency_shift",
                                                "load_exponent_of_loss",
                                                "drum_curvature",
                                                "drum_heating",
                                                "standing_wave",
                                                "tread_wear",
                                                "belt_anisotropy",
                                                "layer_conductivity",
                                                "layer_heat_capacity",
                                                "laser_absorptivity",
                                                "laser_spot_size",
                                                "initial_temperature",
                                                "sensor_lag",
                                                "sensor_offset",
                                                "sensor_gain",
                                                "sensor_drift",
                                                "sensor_depth",
                                                "camera_emissivity",
                                                "pressure_reading_speed",
                                                "clock_delay",
                                                "clock_rate",
                                                "slip_input_gain",
                                                "slip_angle_offset",
                                                "load_input_gain",
                                                "speed_input_gain",
                                                "input_delay",
                                                "own_source",
                                                "own_exchange"};
    std::set<std::string_view> seen;
    for (const Effect* effect : catalogue()) {
        EXPECT_TRUE(seen.insert(effect->id).second) << effect->id << " is there twice";
        // For reference problems, beside the catalogue.
        EXPECT_TRUE(thesis_model.contains(effect->id) || extensions.contains(effect->id) ||
                    effect->id == "uniform_source")
            << effect->id;
        EXPECT_EQ(has_absent(*effect), extensions.contains(effect->id)) << effect->id;
    }
    EXPECT_EQ(seen.size(), thesis_model.size() + extensions.size() + 1);
    for (const char* id : {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"}) {
        EXPECT_TRUE(find_effect(id)->on) << id;
    }
    EXPECT_EQ(std::ranges::count_if(catalogue(), [](const Effect* e) { return e->on; }), 5);
    EXPECT_EQ(find_effect("phlogiston"), nullptr);
}

TEST(Catalogue, ReadingsStandInTheirOrder) {
    std::vector<std::string_view> order;
    for (const Effect* effect : catalogue()) {
        if (effect->sensor_model() != nullptr) {
            order.push_back(effect->id);
        }
    }
    EXPECT_EQ(order, (std::vector<std::string_view>{"camera_emissivity", "sensor_depth", "clock_delay", "clock_rate",
                                                    "sensor_lag", "sensor_offset", "sensor_gain", "sensor_drift",
                                                    "pressure_reading_speed"}));
}

TEST(Catalogue, OrderOfEffectsDoesNotMatter) {
    // Everything that can act, switched on from first to last and from last to first: the same sums but for the order of
    // additions. Lumped nodes, whose numbers differ, are compared by name.
    // A zero error of the slip angle is added to what its gain makes, as the catalogue has them: here it stays away.
    for (const Bench& bench : {two_nodes(), specimen(), section()}) {
        std::vector<Part> parts;
        for (const Effect* effect : catalogue()) {
            if (effect->sensor_model() == nullptr && can_act(*effect, bench) && effect->id != "slip_angle_offset") {
                parts.push_back(loud(effect->id));
            }
        }
        Whole forwards(bench, parts);
        std::reverse(parts.begin(), parts.end());
        Whole backwards(bench, parts);
        ASSERT_EQ(n_nodes(forwards), n_nodes(backwards));
        const auto field = [&](const Whole& whole) {
            std::vector<double> T = bench.T;
            T.resize(n_nodes(whole));
            for (const mesh::LumpedNode& lumped_node : whole.problem().mesh.lumped_nodes) {
                T[static_cast<std::size_t>(lumped_node.node)] = 300.0 + static_cast<double>(lumped_node.name.size());
            }
            return T;
        };
        forwards.ask(lively(), field(forwards));
        backwards.ask(lively(), field(backwards));
        double turnover = 0.0;
        for (const double q : forwards.system().heat_flow()) {
            turnover += std::abs(q);
        }
        for (std::size_t node = 0; node < bench.T.size(); ++node) {
            const int same = static_cast<int>(node);
            EXPECT_NEAR(forwards.flow(same), backwards.flow(same), 1e-12 * turnover);
            EXPECT_NEAR(forwards.system().capacity(node, 310.0), backwards.system().capacity(node, 310.0), 1e-9);
        }
        for (const mesh::LumpedNode& lumped_node : forwards.problem().mesh.lumped_nodes) {
            EXPECT_NEAR(forwards.flow(lumped_node.node), backwards.flow(backwards.node(lumped_node.name)),
                        1e-12 * turnover)
                << lumped_node.name;
        }
    }
}

}  // namespace tiretherm::physics
