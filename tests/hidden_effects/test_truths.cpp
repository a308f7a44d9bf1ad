// The truths themselves: that they converge, that they agree with what others computed, and with this project where
// nothing is hidden. They share no source file with it (house.hidden_effects_border).
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "cases/written.hpp"
#include "hidden_effects/laser_truth.hpp"
#include "hidden_effects/random_truth.hpp"
#include "hidden_effects/shipped_truth.hpp"
#include "hidden_effects/two_node_truth.hpp"
#include "solver/march.hpp"

namespace hidden_effects {

namespace {

constexpr double celsius = 273.15;

/// K1 and K2 of cases/laser: straight lines through 20 and 90 degC.
LaserSpecimen specimen_of_the_cases(double power) {
    const auto line = [](double at_20, double at_90) {
        const double slope = (at_90 - at_20) / 70.0;
        return Conductivity{at_20 + 20.0 * slope, at_90, at_20 + 120.0 * slope};
    };
    return {.K1 = line(0.29, 0.95), .K2 = line(0.06, 0.075), .power = power};
}

std::vector<double> every(double interval, double end) {
    std::vector<double> times;
    for (double t = interval; t <= end; t += interval) {
        times.push_back(t);
    }
    return times;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return a.size() == b.size() ? largest : HUGE_VAL;
}

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

/// The rows of a case of the library: [channel][row], degC, at its output times without the first.
/// @param tolerance K, local error of a step; 0: the case's
std::vector<std::vector<double>> run_case(const std::string& name, double tolerance = 0.0) {
    namespace cases = tiretherm::cases;
    cases::Reading reading = cases::read_case(cases::source_folder() / "cases" / (name + ".toml"));
    if (!reading.problem) {
        ADD_FAILURE() << cases::render(reading);
        return {};
    }
    if (tolerance > 0.0) {
        reading.problem->settings.tolerance = tolerance;
    }
    std::vector<std::vector<double>> rows(reading.problem->channels.size());
    const auto report = tiretherm::solver::run(*reading.problem, [&](const tiretherm::solver::Snapshot& now) {
        for (std::size_t c = 0; c < rows.size() && now.time > 0.0; ++c) {
            rows[c].push_back(now.channels[c] - celsius);
        }
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return rows;
}

}  // namespace

// Four times the elements move no reading by more than the 0.02 K that the truth is used at (time alone, below, moves
// it by a tenth of that); 3 W, from 1 s on, while the spot rises by 142 K.
TEST(LaserTruth, IsConvergedToAFiftiethOfAKelvin) {
    const std::vector<double> times = every(1.0, 900.0);
    const LaserTrace coarse = heat_with_laser(specimen_of_the_cases(3.0), times);
    const LaserTrace fine = heat_with_laser(specimen_of_the_cases(3.0), times, {.refinement = 2});
    EXPECT_LT(largest_difference(coarse.spot_mean, fine.spot_mean), 0.02);
    EXPECT_LT(largest_difference(coarse.spot_centre, fine.spot_centre), 0.02);
    EXPECT_LT(largest_difference(coarse.inner_centre, fine.inner_centre), 0.02);
    EXPECT_LT(largest_difference(coarse.inner_ring, fine.inner_ring), 0.02);
    RecordProperty("spot_mean", std::to_string(largest_difference(coarse.spot_mean, fine.spot_mean)));
    RecordProperty("steps", coarse.n_steps);
}

// In time alone: with a local error of 2.5e-4, a sixteenth, a method of order 4(3) takes twice as many steps.
TEST(LaserTruth, StepsGrowAsTheFourthRootOfTheError) {
    const std::vector<double> times = every(10.0, 900.0);
    const LaserTrace loose = heat_with_laser(specimen_of_the_cases(3.0), times, {.tolerance = 4e-3});
    const LaserTrace tight = heat_with_laser(specimen_of_the_cases(3.0), times, {.tolerance = 2.5e-4});
    EXPECT_LT(largest_difference(loose.spot_centre, tight.spot_centre), 2e-3);
    EXPECT_NEAR(static_cast<double>(tight.n_steps) / loose.n_steps, 2.0, 0.3);
}

// Without films the specimen keeps what it takes up: after 300 s the light's 0.5 * 2 W * 300 s have warmed
// rho c pi R^2 L = 268.7 J/K by 1.1165 K on the mean. Read over the whole faces, the mean lies between them.
TEST(LaserTruth, KeepsTheHeatThatItTakesUp) {
    LaserSpecimen specimen{.K1 = {50.0, 50.0, 50.0},
                           .K2 = {50.0, 50.0, 50.0},
                           .h_top = 0.0,
                           .h_bottom = 0.0,
                           .absorptivity = 0.5,
                           .power = 2.0};
    specimen.seen_spot = specimen.radius;
    specimen.ring_inside = 0.0;
    specimen.ring_outside = specimen.radius;
    const LaserTrace trace = heat_with_laser(specimen, {300.0});
    const double capacity = 1100.0 * 1800.0 * 3.14159265358979 * 0.060 * 0.060 * 0.012;
    const double rise = 0.5 * 2.0 * 300.0 / capacity;
    // At 50 W/mK the faces differ by q L/(2 k) of 1 W over 0.0113 m2, which is 0.011 K.
    EXPECT_NEAR(0.5 * (trace.spot_mean[0] + trace.inner_ring[0]) - 23.0, rise, 0.003);
}

// Thesis-notes section 4, a finite-volume model apart from both: centre 100.8 and 182.3, inner face 47.3 and 82.0 degC,
// printed to 0.1 K; the rim at 60 mm adds 0.02 and 0.07 K.
TEST(LaserTruth, SettlesWhereAnIndependentModelDoes) {
    const LaserTrace one = heat_with_laser(specimen_of_the_cases(1.0), {20000.0});
    const LaserTrace three = heat_with_laser(specimen_of_the_cases(3.0), {20000.0});
    EXPECT_NEAR(one.spot_centre[0], 100.8, 0.05 + 0.02 + 0.02);
    EXPECT_NEAR(one.inner_centre[0], 47.3, 0.05 + 0.02 + 0.02);
    EXPECT_NEAR(three.spot_centre[0], 182.3, 0.05 + 0.07 + 0.02);
    EXPECT_NEAR(three.inner_centre[0], 82.0, 0.05 + 0.07 + 0.02);
}

// The cases of the library, every 10 s over 1800 s: finite volumes and TR-BDF2 against finite elements and RODAS.
// Truth 0.02 K, the case's steps 0.01 K, and its grid: with twice and three times as many cells each way the 1 W case
// ends at 99.723, 99.696, 99.692 (centre), 91.227, 91.176, 91.166 (mean), 45.939, 45.920, 45.917 degC (inner face), so
// that the grid it is run on adds 0.035 of 76.7, 0.069 of 68.2 and 0.025 of 22.9 K.
TEST(LaserTruth, FollowsTheProjectsCases) {
    const double powers[] = {1.0, 3.0};
    const char* names[] = {"laser/one_watt", "laser/three_watts"};
    for (int i = 0; i < 2; ++i) {
        SCOPED_TRACE(names[i]);
        const std::vector<std::vector<double>> rows = run_case(names[i]);
        ASSERT_EQ(rows.size(), 3U);
        const LaserTrace truth = heat_with_laser(specimen_of_the_cases(powers[i]), every(10.0, 1800.0));
        const auto within = [](double grid, const std::vector<double>& of) { return 0.03 + grid * (of.back() - 23.0); };
        EXPECT_LT(largest_difference(rows[0], truth.spot_centre), within(0.035 / 76.7, truth.spot_centre));
        EXPECT_LT(largest_difference(rows[1], truth.spot_mean), within(0.069 / 68.2, truth.spot_mean));
        EXPECT_LT(largest_difference(rows[2], truth.inner_centre), within(0.025 / 22.9, truth.inner_centre));
    }
}

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

// Over 2e5 samples at 2 s: variance 1, neighbours correlate by 0.7 0.9^2 = 0.567, those after 10 s by 0.7 0.9^10 =
// 0.244. Standard errors: the correlated part forgets itself over some 20 s, so about 2e4 independent values and 0.01.
TEST(NoiseTruth, HasItsVarianceAndItsMemory) {
    std::vector<double> times;
    for (int i = 0; i < 200000; ++i) {
        times.push_back(2.0 * i);
    }
    Random random(7);
    const std::vector<double> noise = draw_noise({.standard_deviation = 1.0}, times, random);
    const auto covariance = [&](std::size_t lag) {
        double sum = 0.0;
        for (std::size_t i = 0; i + lag < noise.size(); ++i) {
            sum += noise[i] * noise[i + lag];
        }
        return sum / static_cast<double>(noise.size() - lag);
    };
    EXPECT_NEAR(covariance(0), 1.0, 0.03);
    EXPECT_NEAR(covariance(1), 0.567, 0.03);
    EXPECT_NEAR(covariance(5), 0.244, 0.03);
}

// Gaps of 1 and of 9 s in turn: neighbours correlate by 0.7 0.9 = 0.63 and by 0.7 0.9^9 = 0.271.
TEST(NoiseTruth, KeepsItsMemoryOverUnevenTimes) {
    std::vector<double> times;
    for (int i = 0; i < 100000; ++i) {
        times.push_back(10.0 * i);
        times.push_back(10.0 * i + 1.0);
    }
    Random random(8);
    const std::vector<double> noise = draw_noise({.standard_deviation = 1.0}, times, random);
    double near = 0.0;
    double far = 0.0;
    for (std::size_t i = 0; i + 2 < noise.size(); i += 2) {
        near += noise[i] * noise[i + 1] / 1e5;
        far += noise[i + 1] * noise[i + 2] / 1e5;
    }
    EXPECT_NEAR(near, 0.63, 0.03);
    EXPECT_NEAR(far, 0.271, 0.03);
}

// A programme starts with a minute at rest, moves, slips and never leaves what the model is made for.
TEST(ProgrammeTruth, IsAProgramme) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Programme programme = draw_programme(seed);
        ASSERT_EQ(programme.time.size(), 1201U);
        for (std::size_t i = 0; i <= 30; ++i) {
            EXPECT_EQ(programme.speed[i], 0.0);
        }
        const auto [least, most] = std::minmax_element(programme.speed.begin(), programme.speed.end());
        EXPECT_GE(*least, 0.0);
        EXPECT_GT(*most, 30.0 / 3.6);
        EXPECT_LE(*most, 190.0 / 3.6 + 1e-9);
        for (std::size_t i = 0; i < programme.time.size(); ++i) {
            EXPECT_LE(programme.slip_angle[i] * programme.lateral_force[i], 0.0);
            EXPECT_LE(std::abs(programme.lateral_force[i]), 1.06 * programme.vertical_load[i]);
            EXPECT_GE(programme.throttle[i], 0.0);
            EXPECT_LE(programme.throttle[i], 1.0);
        }
    }
    EXPECT_EQ(draw_programme(5).speed, draw_programme(5).speed);
    EXPECT_NE(draw_programme(5).speed, draw_programme(6).speed);
    const Programme dull = draw_dull_programme(5);
    EXPECT_EQ(dull.speed.front(), dull.speed.back());
    EXPECT_EQ(dull.vertical_load.front(), dull.vertical_load.back());
}

}  // namespace hidden_effects
