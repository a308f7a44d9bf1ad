// SPDX-License-Identifier: BSD-3-Clause
// The truth of the bench of two nodes: that it converges, agrees with what others computed and with this project where
// nothing is hidden, and that what is hidden shows. It shares no source file with it (house.hidden_effects_border).
#include <stdexcept>

#include "hidden_effects/case_rows.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

namespace {

Programme steady(double load, double speed) {
    return {.time = {0.0, 3600.0},
            .speed = {speed / 3.6, speed / 3.6},
            .vertical_load = {load, load},
            .slip_angle = {0.0, 0.0},
            .lateral_force = {0.0, 0.0},
            .air_temperature = {296.15, 296.15},
            .road_temperature = {296.15, 296.15},
            .throttle = {0.0, 0.0}};
}

}  // namespace

// Thesis-notes section 4, LSODA at 1e-8, printed to 0.1 K.
TEST(BenchTruth, SettlesWhereAnIndependentIntegrationDoes) {
    const double load[] = {4000.0, 7000.0, 7500.0};
    const double speed[] = {100.0, 100.0, 150.0};
    const double expected[][2] = {{38.3, 64.0}, {43.6, 80.6}, {46.6, 93.5}};
    for (int i = 0; i < 3; ++i) {
        const BenchTrace trace = drive_bench({}, steady(load[i], speed[i]));
        EXPECT_NEAR(trace.surface.back() - celsius, expected[i][0], 0.05);
        EXPECT_NEAR(trace.bulk.back() - celsius, expected[i][1], 0.05);
    }
}

// The same case as this project computes it, with a local error of 1e-6 K over some hundreds of steps.
TEST(BenchTruth, FollowsTheProjectsCase) {
    const std::vector<std::vector<double>> rows = run_case("two_node/7500N_150kmh", 1e-6);
    ASSERT_EQ(rows.size(), 2U);
    Programme programme = steady(7500.0, 150.0);
    for (double t = 10.0; t < 3600.0; t += 10.0) {
        programme.time.insert(programme.time.end() - 1, t);
    }
    for (std::vector<double>* signal :
         {&programme.speed, &programme.vertical_load, &programme.slip_angle, &programme.lateral_force,
          &programme.air_temperature, &programme.road_temperature, &programme.throttle}) {
        signal->assign(programme.time.size(), signal->front());
    }
    BenchTrace truth = drive_bench({}, programme);
    for (std::vector<double>* channel : {&truth.surface, &truth.bulk}) {
        channel->erase(channel->begin());
        for (double& T : *channel) {
            T -= celsius;
        }
    }
    EXPECT_LT(largest_difference(rows[0], truth.surface), 2e-4);
    EXPECT_LT(largest_difference(rows[1], truth.bulk), 2e-4);
}

// A hundredth of the local error moves nothing by a micro-kelvin, although inputs jump and the floor of the film
// makes a kink.
TEST(BenchTruth, IsConvergedOverAProgramme) {
    const Programme programme = draw_programme(1);
    const Bench bench{.causes = {{"standing_wave", {{"gain", 1e-4}, {"critical_speed", 120.0}}}}};
    const BenchTrace coarse = drive_bench(bench, programme);
    const BenchTrace fine = drive_bench(bench, programme, 1e-11);
    EXPECT_LT(largest_difference(coarse.surface, fine.surface), 1e-6);
    EXPECT_LT(largest_difference(coarse.bulk, fine.bulk), 1e-6);
}

// Each cause at its absent value is no cause; at another one it shows.
TEST(BenchTruth, ACauseThatIsAbsentDoesNothing) {
    struct Example {
        const char* id;
        const char* key;
        double absent, present;
        const char* channel = "";
    };
    const std::vector<Example> examples{
        {"sidewall_convection", "conductance", 0.0, 1.0},
        {"inner_gas", "liner", 0.0, 9.0},
        {"inflation_pressure_rise", "exponent", 0.0, 0.45},
        {"cornering_loss", "coefficient", 0.0, 1e-6},
        {"convection_exponent", "exponent", 0.571, 0.65},
        {"partition_speed", "slope", 0.0, 0.05},
        {"loss_tangent_slope", "slope", 0.0, 1e-3},
        {"load_exponent_of_loss", "exponent", 0.0, 0.1},
        {"standing_wave", "gain", 0.0, 1e-4},
        {"road_temperature_drift", "rate", 0.0, 5.0},
        {"air_temperature_drift", "rate", 0.0, 5.0},
        {"sensor_lag", "tau", 0.0, 10.0, "bulk_temperature"},
        {"sensor_lag", "tau", 0.0, 10.0, "surface_temperature"},
        {"sensor_offset", "kelvin", 0.0, 0.5, "bulk_temperature"},
        {"sensor_offset", "kelvin", 0.0, 0.5, "surface_temperature"},
        {"sensor_gain", "excess", 0.0, 0.02, "bulk_temperature"},
        {"sensor_gain", "excess", 0.0, 0.02, "surface_temperature"},
        {"camera_emissivity", "emissivity", 1.0, 0.95},
        {"layer_heat_capacity", "scale", 1.0, 1.1},
        {"layer_conductivity", "scale", 1.0, 1.1},
        {"slip_input_gain", "gain", 1.0, 1.1},
        {"unknown_surface", "watts", 0.0, 50.0},
        {"unknown_bulk", "watts", 0.0, 50.0},
    };
    const Programme programme = draw_programme(3);
    const BenchTrace plain = drive_bench({}, programme);
    for (const Example& example : examples) {
        SCOPED_TRACE(example.id);
        const auto with = [&](double value) {
            return drive_bench({.causes = {{example.id, {{example.key, value}}, example.channel}}}, programme);
        };
        const BenchTrace absent = with(example.absent);
        EXPECT_LT(largest_difference(absent.surface, plain.surface), 1e-6);
        EXPECT_LT(largest_difference(absent.bulk, plain.bulk), 1e-6);
        const BenchTrace present = with(example.present);
        EXPECT_GT(
            std::max(largest_difference(present.surface, plain.surface), largest_difference(present.bulk, plain.bulk)),
            0.1);
    }
    EXPECT_THROW((void)drive_bench({.causes = {{"sensor_lag", {{"tau", 1.0}}}}}, programme), std::invalid_argument);
    EXPECT_THROW((void)drive_bench({.causes = {{"radiation", {{"emissivity", 0.9}}}}}, programme),
                 std::invalid_argument);
}

// Readings in their order: emissivity, lag, offset, gain. At rest and in equilibrium at 40 degC with air of 20 degC,
// before anything has moved, the camera of emissivity 0.9 shows (0.9 313.15^4 + 0.1 293.15^4)^(1/4) = 311.3176 K,
// 38.1676 degC; with 2 K more 40.1676; with a gain of 1.1 about 25 degC 41.6843 degC.
TEST(BenchTruth, ReadingsActInTheirOrder) {
    Programme programme = steady(0.0, 0.0);
    programme.air_temperature = {293.15, 293.15};
    const Bench bench{.surface_start = 313.15,
                      .causes = {{"sensor_gain", {{"excess", 0.1}}, "surface_temperature"},
                                 {"sensor_offset", {{"kelvin", 2.0}}, "surface_temperature"},
                                 {"camera_emissivity", {{"emissivity", 0.9}}},
                                 {"sensor_lag", {{"tau", 20.0}}, "surface_temperature"}}};
    EXPECT_NEAR(drive_bench(bench, programme).surface.front() - celsius, 41.6843, 1e-4);
}

}  // namespace hidden_effects
