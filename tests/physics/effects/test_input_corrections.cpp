// SPDX-License-Identifier: BSD-3-Clause
// Effects on the inputs and on the initial state: one number each, by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"

namespace tiretherm::physics {

TEST(RoadTemperatureDrift, WarmsTheRoadByItsRate) {
    // 6 K/h for half an hour: 3 K. Contact 4.666 W/K at 4000 N; the surface stands 12 K above the logged road.
    Whole whole(two_nodes(), {{"road_contact"}, {"road_temperature_drift", {{"rate", 6.0}}}});
    Inputs in = rolling();
    in.time = 1800.0;
    EXPECT_NEAR(whole.ask(in).watts("road_contact"), -4.666 * (12.0 - 3.0), 1e-9);
    EXPECT_EQ(whole.system().transformed(in).air_temperature, in.air_temperature);
}

TEST(RoadTemperatureDrift, HasAnOffsetThatAFitMayFree) {
    // 8 K more than logged, and 3 K of drift after half an hour. Of the surface's 12 K above the logged road 1 K is left.
    Whole whole(two_nodes(), {{"road_contact"}, {"road_temperature_drift", {{"rate", 6.0}, {"offset", 8.0}}}});
    Inputs in = rolling();
    in.time = 1800.0;
    EXPECT_NEAR(whole.ask(in).watts("road_contact"), -4.666 * 1.0, 1e-9);
}

TEST(AirTemperatureDrift, WarmsTheAirByItsRate) {
    // -6 K/h for half an hour: -3 K. A sidewall of 12 W/K at the bulk's 55 C in air logged at 23 C.
    Whole whole(two_nodes(),
                {{"sidewall_convection", {{"conductance", 12.0}}}, {"air_temperature_drift", {{"rate", -6.0}}}});
    Inputs in = rolling();
    in.time = 1800.0;
    EXPECT_NEAR(whole.ask(in).watts("sidewall_convection"), -12.0 * (32.0 + 3.0), 1e-9);
    EXPECT_EQ(whole.system().transformed(in).road_temperature, in.road_temperature);
}

TEST(SlipInputGain, IsAFactorOnTheHeatOfFriction) {
    // 0.6 (138.889 + 1940.04) W at 2 degrees and 1 % (SlidingFrictionEffect), each times 1.3.
    Whole plain(two_nodes(), {{"sliding_friction"}});
    Whole more(two_nodes(), {{"sliding_friction"}, {"slip_input_gain", {{"gain", 1.3}}}});
    EXPECT_NEAR(more.ask(driven()).watts("sliding_friction"), 1.3 * 1247.36, 0.01);
    Inputs large = driven();
    large.slip_angle = -0.4;  // where the tangent is no longer the angle
    EXPECT_NEAR(more.ask(large).watts("sliding_friction"), 1.3 * plain.ask(large).watts("sliding_friction"), 1e-9);
}

TEST(SlipAngleOffset, ShiftsTheAngle) {
    // 2 degrees logged and 0.5 degrees of zero error are a slip angle of 2.5 degrees, and none logged one of 0.5.
    constexpr double degree = 3.14159265358979 / 180.0;
    Whole plain(two_nodes(), {{"sliding_friction"}});
    Whole shifted(two_nodes(), {{"sliding_friction"}, {"slip_angle_offset", {{"offset", 0.5 * degree}}}});
    for (const double logged : {2.0, 0.0, -0.2}) {
        Inputs in = driven();
        in.slip_angle = logged * degree;
        Inputs as_it_was = in;
        as_it_was.slip_angle = (logged + 0.5) * degree;
        EXPECT_NEAR(shifted.ask(in).watts("sliding_friction"), plain.ask(as_it_was).watts("sliding_friction"), 1e-9);
    }
}

TEST(LoadInputGain, IsAFactorOnTheLoad) {
    // Contact conductance 500 * 2.333e-6 * 4000 = 4.666 W/K, proportional to the load; 12 K above the road.
    Whole whole(two_nodes(), {{"road_contact"}, {"load_input_gain", {{"gain", 1.1}}}});
    EXPECT_NEAR(whole.ask(rolling()).watts("road_contact"), -1.1 * 4.666 * 12.0, 1e-9);
}

TEST(SpeedInputGain, IsAFactorOnTheSpeed) {
    // Friction power is proportional to the speed: 0.9 * 1247.36 W.
    Whole whole(two_nodes(), {{"sliding_friction"}, {"speed_input_gain", {{"gain", 0.9}}}});
    EXPECT_NEAR(whole.ask(driven()).watts("sliding_friction"), 0.9 * 1247.36, 0.01);
}

TEST(LaserAbsorptivity, IsAFactorThatFalls) {
    // A quarter of 1 W, 0.9 of it absorbed, falling by exp(-0.2/h * 0.5 h) = 0.904837.
    Whole whole(specimen(), {{"laser"}, {"laser_absorptivity", {{"factor", 0.9}, {"fall", 0.2}}}});
    EXPECT_NEAR(whole.ask(rolling()).watts("laser"), 0.225, 1e-12);
    Inputs later = rolling();
    later.time = 1800.0;
    EXPECT_NEAR(whole.ask(later).watts("laser"), 0.225 * 0.904837, 1e-6);
}

TEST(LaserSpotSize, SpreadsTheSamePowerWider) {
    // Three times the radius of 1 cm2: 9 cm2, which covers the central face of 5 x 6 mm: 1 W * 0.3 / 9 = 33.3 mW.
    const Bench bench = specimen();
    Whole whole(bench, {{"laser"}, {"laser_spot_size", {{"scale", 3.0}}}});
    const int node = bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("top"))].faces.front().node;
    whole.ask(rolling());
    EXPECT_NEAR(whole.flow(node), 0.3 / 9.0, 1e-6);
    EXPECT_NEAR(whole.watts("laser"), 0.25, 1e-12);
}

TEST(InitialTemperature, ShiftsTheLayersNamed) {
    // The standard layers are those below the surface: the bulk starts at 55 + 5 C.
    const Whole whole(two_nodes(), {{"initial_temperature", {{"offset", 5.0}}}});
    EXPECT_EQ(whole.system().initial(), (std::vector<double>{308.15, 333.15}));
}

TEST(InitialTemperature, CanDifferFromLayerToLayer) {
    // Surface nodes go with their layer: the tread starts 2 K colder with its outer surface, everything else 4 K warmer.
    const Bench bench = section();
    ActiveEffect effect = activate(*find_effect("initial_temperature"), bench.mesh);
    effect.layers = {0, 1, 2, 3};
    effect.parameters = {4.0};
    effect.overrides = {{.scope = Scope::layer, .index = 0, .parameter = 0, .value = -2.0}};
    std::vector<double> T(bench.T.size(), 300.0);
    effect.effect->input_correction()->start(effect, bench.mesh, T);
    for (std::size_t node = 0; node < T.size(); ++node) {
        EXPECT_EQ(T[node], bench.mesh.layer[node] == 0 ? 298.0 : 304.0);
    }
}

}  // namespace tiretherm::physics
