// SPDX-License-Identifier: BSD-3-Clause
// Effects of the user's own: where they act and how the places share what they give.
#include <numeric>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"
#include "physics/user_effect_place.hpp"

namespace tiretherm::physics {

namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

ActiveEffect own(const Bench& bench, std::string_view id, std::vector<int> nodes) {
    ActiveEffect active = activate(*find_effect(id), bench.mesh);
    active.parameters.front() = 100.0;
    active.tables.front() = Curve::table({0.0, 10.0}, {0.0, 1.0});
    active.nodes = std::move(nodes);
    bench.place(active);
    return active;
}

}  // namespace

// 100 W at a signal of 1, which it reaches in 10 s: 25 W after 2.5 s, 100 W for ever after 10 s.
TEST(OwnSource, FollowsItsSignal) {
    const Bench bench = section();
    const ActiveEffect active = own(bench, "own_source", nodes_of_place(bench.mesh, "crown"));
    EXPECT_NEAR(bench.watts(active, {.time = 2.5}), 25.0, 1e-12);
    EXPECT_NEAR(bench.watts(active, {.time = 50.0}), 100.0, 1e-12);
    EXPECT_NEAR(bench.watts(active, {.time = -1.0}), 0.0, 1e-12);
}

// G = 100 W/K at a signal of 1, half of it after 5 s; a surface at T sees air at 290 K: 50 (290 - T), by area.
TEST(OwnExchange, MeetsTheAirOrWhatItIsTold) {
    const Bench bench = specimen();  // 300 K throughout
    ActiveEffect active = own(bench, "own_exchange", nodes_of_place(bench.mesh, "surface"));
    EXPECT_NEAR(bench.watts(active, {.time = 5.0, .air_temperature = 290.0}), -500.0, 1e-10);
    active.tables[1] = Curve::table({0.0, 10.0}, {300.0, 340.0});
    EXPECT_NEAR(bench.watts(active, {.time = 5.0, .air_temperature = 290.0}), 1000.0, 1e-10);
    EXPECT_EQ(bench.watts(active, {.time = 0.0, .air_temperature = 290.0}), 0.0);
}

// Twice the heat capacity per volume takes twice the heat per volume: all of it warms alike.
TEST(OwnSource, CellsShareByHeatCapacity) {
    Bench bench = section();
    bench.materials[1].heat_capacity = Curve::constant(900.0);
    bench.materials[2].density = 2200.0;
    const ActiveEffect active = own(bench, "own_source", nodes_of_place(bench.mesh, "crown"));
    const MaterialModel material_model = bench.material_model();
    const Terms terms = bench.said(active, {.time = 10.0}, bench.T);
    double rate = 0.0;
    for (std::size_t i = 0; i < active.nodes.size(); ++i) {
        const auto cell = static_cast<std::size_t>(active.nodes[i]);
        const Material& material = material_model.materials[static_cast<std::size_t>(bench.mesh.layer[cell])];
        const double here =
            terms.node_q[cell] / (material.density * material.heat_capacity.value(300.0) * bench.mesh.volume[cell]);
        rate = rate == 0.0 ? here : rate;
        EXPECT_NEAR(here, rate, 1e-12 * rate) << "cell " << cell;
    }
    EXPECT_EQ(active.nodes.size(), 3U * 5U);  // 3 columns; 2 cells of tread, 1 each of belt, carcass and liner
    EXPECT_NEAR(sum(active.weights), 1.0, 1e-14);
}

TEST(OwnSource, SurfacesShareByArea) {
    const Bench bench = section();
    const ActiveEffect active = own(bench, "own_source", nodes_of_place(bench.mesh, "outside"));
    const mesh::Patch& patch = bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("outside"))];
    ASSERT_EQ(active.nodes.size(), patch.faces.size());
    for (std::size_t i = 0; i < active.nodes.size(); ++i) {
        EXPECT_NEAR(active.weights[i], patch.faces[i].area / patch.area(), 1e-14);
    }
}

TEST(UserEffectPlace, IsARegionALayerAZoneOrAPatch) {
    const Bench bench = section();
    EXPECT_EQ(nodes_of_place(bench.mesh, "surface"), bench.mesh.regions[0].mean.nodes);
    EXPECT_EQ(nodes_of_place(bench.mesh, "belt").size(),
              2U + 3U + 2U);  // one cell in each column between the sidewalls
    EXPECT_EQ(nodes_of_place(bench.mesh, "inside_sidewall").size(), 2U * 2U);
    EXPECT_FALSE(nodes_of_place(bench.mesh, "inside").empty());
    EXPECT_TRUE(nodes_of_place(bench.mesh, "moon").empty());
    for (const std::string& name : names_of_places(bench.mesh)) {
        EXPECT_FALSE(nodes_of_place(bench.mesh, name).empty()) << name;
    }
}

TEST(UserEffectPlace, SurfacesAndVolumesCannotShare) {
    const Bench bench = section();
    std::vector<int> both = nodes_of_place(bench.mesh, "belt");
    both.push_back(bench.mesh.regions[0].mean.nodes.front());
    EXPECT_TRUE(shares_of_nodes(bench.mesh, bench.materials, both).empty());
    EXPECT_EQ(shares_of_nodes(bench.mesh, bench.materials, std::vector{both.back()}), std::vector{1.0});
}

// An effect that is switched on from the catalogue has nothing to follow and nowhere to act.
TEST(UserEffects, ObjectToBeingSwitchedOnWithoutACourse) {
    const Bench bench = two_nodes();
    for (const std::string_view id : {"own_source", "own_exchange"}) {
        ActiveEffect active = activate(*find_effect(id), bench.mesh);
        EXPECT_NE(
            active.effect->invalid_on_mesh(active, bench.mesh).find(id == "own_source" ? "[[source]]" : "[[exchange]]"),
            std::string::npos);
        EXPECT_EQ(own(bench, id, {0}).effect->invalid_on_mesh(own(bench, id, {0}), bench.mesh), "");
        active.parameters.front() = 100.0;
        EXPECT_EQ(bench.watts(active, rolling()), 0.0);
    }
}

}  // namespace tiretherm::physics
