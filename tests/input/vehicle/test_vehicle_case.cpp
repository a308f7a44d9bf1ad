// SPDX-License-Identifier: BSD-3-Clause
// What a case with [vehicle] makes of the log of a car, against a car whose loads and slips are known.

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "input/vehicle/known_car.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input::known_car {

TEST(VehicleCase, LogGivesTheLoadsAndSlipsOfAKnownCar) {
    // Without smoothing everything but the yaw acceleration is exact at the samples. That one is the slope over 0.1 s:
    // off by h^2/6 of its second derivative, 0.05^2/6 x 0.0054 = 2e-6 rad/s2, times I/L less than 2e-3 N; at the ends, where
    // the slope is over 0.05 s on one side, by h/2 x 0.018 = 4.5e-4 rad/s2, 0.4 N, so these are left out.
    for (std::size_t corner = 0; corner < physics::n_corners; ++corner) {
        const std::string keys = fmt::format("corner = \"{}\"\nsmoothing = \"0 s\"\n", physics::corner_names[corner]);
        const solver::Problem problem = problem_of(read(plain_log(), keys));
        const bool front = corner < 2;
        const bool left = corner % 2 == 0;
        for (std::size_t i = 2; i + 2 < n_samples; ++i) {
            const double t = step * static_cast<double>(i);
            const Truth truth(t);
            const physics::Inputs in = problem.input_signals.at(t, solver::JumpSide::after);
            ASSERT_NEAR(in.vertical_load, truth.load(front, left), 1e-3) << t;
            ASSERT_NEAR(std::tan(in.slip_angle), truth.tan_slip_angle(front, left), 1e-6) << t;
            ASSERT_NEAR(in.slip_ratio, truth.slip_ratio(front, left), 1e-6) << t;
            ASSERT_NEAR(in.speed, truth.V + (left ? -0.75 : 0.75) * truth.r, 1e-6) << t;
        }
    }
}

// The motion is in the loads and slips; the brakes may heat the tire besides, so their column stays one that explains
// what is left over.
TEST(VehicleCase, OfTheColumnsOfACarTheBrakesAloneAreNotUsedUp) {
    for (const VehicleSignal& signal : vehicle_signals()) {
        EXPECT_EQ(is_used_up_by_vehicle(signal.name), signal.name != "brake_pressure") << signal.name;
    }
    EXPECT_FALSE(is_used_up_by_vehicle("tire_temperature"));
}

TEST(VehicleCase, LoggerThatIsPositiveInRightTurnsIsFoundOut) {
    // The column has the other sign, the yaw rate says so, and the tire gets the same load.
    const Reading turned = read(plain_log(-1.0), "");
    EXPECT_TRUE(warns(turned,
                      "lateral_acceleration is taken as positive in right turns: its correlation with speed "
                      "times yaw_rate is -1.00"));
    const Reading plain = read(plain_log(), "");
    EXPECT_TRUE(warns(plain, "lateral_acceleration is taken as positive in left turns: its correlation"));
    for (const double t : {5.0, 20.0, 41.0}) {
        EXPECT_NEAR(problem_of(turned).input_signals.at(t, solver::JumpSide::after).vertical_load,
                    problem_of(plain).input_signals.at(t, solver::JumpSide::after).vertical_load, 1e-9);
    }
}

// A tenth of what speed and yaw rate say: a column in g whose heading says m/s2.
TEST(VehicleCase, AnAccelerationInAnotherUnitIsRefused) {
    const Reading tenth = read(plain_log(0.1), "");
    ASSERT_FALSE(tenth.problem.has_value());
    ASSERT_EQ(tenth.errors.size(), 1U);
    EXPECT_EQ(tenth.errors[0].what, "lateral_acceleration is 0.1 times speed times yaw_rate");
    EXPECT_EQ(tenth.errors[0].about, "lateral_acceleration");
    EXPECT_TRUE(read(plain_log(0.7), "").problem.has_value());  // a curve on a bank, a sensor off its place
    const Reading along = read(log_of_the_truth("V [km/h],AccX [g],yaw_rate [deg/s]",
                                                [](const Truth& truth, double) {
                                                    return fmt::format("{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, truth.ax,
                                                                       truth.r * 180.0 / 3.14159265358979323846);
                                                }),
                               "", "columns = { V = \"speed\", AccX = \"longitudinal_acceleration\" }\n");
    ASSERT_EQ(along.errors.size(), 1U);  // m/s2 under a heading of g
    EXPECT_TRUE(along.errors[0].what.starts_with("longitudinal_acceleration is 9.")) << along.errors[0].what;
}

TEST(VehicleCase, WithoutYawRateTheSignIsThatOfIsoAndSaysSo) {
    // Ignored, the yaw rate tells nothing; a_y / V takes its place, and the assumption is a warning.
    const Reading reading = read(plain_log(), "", columns + "ignore = [\"yaw_rate\"]\n");
    EXPECT_TRUE(warns(reading, "lateral_acceleration is taken as positive in left turns (ISO 8855)"));
    EXPECT_TRUE(warns(reading, "yaw rate is lateral_acceleration over speed"));
    const Truth truth(20.0);
    EXPECT_NEAR(problem_of(reading).input_signals.at(20.0, solver::JumpSide::after).speed, truth.V - 0.75 * truth.r,
                1e-3);
}

TEST(VehicleCase, YawRateAloneTellsTheTurn) {
    // Here a_y = V r is exact, and a_x is the slope of the speed over 1 s: off by 0.5^2/6 x 0.024 = 1e-3 m/s2, 0.24 N.
    const Reading alone =
        read(plain_log(), "smoothing = \"0 s\"", "columns = { V = \"speed\" }\nignore = [\"AccY\", \"AccX\"]\n");
    EXPECT_TRUE(warns(alone, "lateral acceleration is speed times yaw_rate"));
    EXPECT_TRUE(warns(alone, "longitudinal acceleration is the slope of speed over 1 s"));
    EXPECT_NEAR(problem_of(alone).input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                Truth(20.0).load(true, true), 0.3);
}

TEST(VehicleCase, SteeringAloneTellsTheTurnOfALinearCar) {
    // K = m_f/C_f - m_r/C_r = 528/180e3 - 672/200e3 = -4.26667e-4; at 25 m/s and 2 deg of the road wheels
    // r = V delta/(L + K V^2) = 25 x 0.0349066/(2.5 - 0.2666667) = 0.3907454 rad/s; a_y = V r = 9.768634 m/s2:
    // dF = 0.6 x 1200 x 9.768634 x 0.5/1.5 = 2344.4721 N of 2588.9556 N.
    const std::string log = log_of_the_truth("speed [m/s],steering_wheel_angle [deg]",
                                             [](const Truth&, double) { return std::string("25,30"); });
    const Reading reading = read(log, "steering_ratio = 15", "");
    EXPECT_TRUE(warns(reading, "follow from steering_wheel_angle"));
    EXPECT_NEAR(problem_of(reading).input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                2588.9556 - 2344.4721, 1e-3);
}

TEST(VehicleCase, MeasuredLoadGoesBeforeTheComputedOne) {
    // The log's load of this wheel counts, also in its slip; the page says which inputs are computed and which are not.
    const std::string log = log_of_the_truth("speed [m/s],lateral_acceleration [m/s2],vertical_load [N]",
                                             [](const Truth&, double) { return std::string("30,2,3000"); });
    const Reading reading = read(log, "", "");
    EXPECT_TRUE(warns(reading, "at FL: vertical_load is not computed: the case gives it"));
    EXPECT_TRUE(warns(reading, "at FL: slip_angle, slip_ratio, lateral_force and longitudinal_force are"));
    const physics::Inputs in = problem_of(reading).input_signals.at(20.0, solver::JumpSide::after);
    EXPECT_EQ(in.vertical_load, 3000.0);
    // Right: 2588.9556 + 0.6 x 1200 x 2 x 0.5/1.5 = 3068.9556 N; the axle's 1056 N at tan(alpha) = Fy Fz_s/(C sum Fz).
    EXPECT_NEAR(std::tan(in.slip_angle), -1056.0 * 2588.9556 / 90e3 / 6068.9556, 1e-8);
}

TEST(VehicleCase, SmoothingKeepsNoiseOutOfTheFrictionPower) {
    // Power goes with the square of a_y: white noise of 1.5 m/s2 adds its variance, 2.25, to a mean square of 0.02 V^2/1,
    // about 18 (m/s2)^2: 12 %. A triangle over 0.4 s, 8 samples with weights (1/4) (1 - |k|/4) and a sum of squares of
    // 0.17, leaves 2 %; it takes nothing from a motion of 0.3 rad/s. Within 2 % for the luck of the draw.
    std::mt19937 random(9);
    std::normal_distribution<double> noise(0.0, 1.5);
    const std::string log =
        log_of_the_truth("V [km/h],AccY [m/s2],AccX [m/s2],yaw_rate [deg/s]", [&](const Truth& truth, double) {
            return fmt::format("{:.9f},{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, truth.ay + noise(random), truth.ax,
                               truth.r * 180.0 / 3.14159265358979323846);
        });
    const double clean = lateral_power(problem_of(read(plain_log(), "smoothing = \"0 s\"")));
    const double noisy = lateral_power(problem_of(read(log, "smoothing = \"0 s\"")));
    const Reading reading = read(log, "smoothing = \"0.4 s\"");
    const double smooth = lateral_power(problem_of(reading));
    EXPECT_GT(noisy / clean, 1.08);
    EXPECT_NEAR(smooth / clean, 1.02, 0.02);
    EXPECT_TRUE(warns(reading, "lateral_acceleration is smoothed over 0.4 s, which takes away 0.1"));
}

TEST(VehicleCase, GripThatIsNotThereIsCounted) {
    // 0.98 g on tires of friction 0.8: more than they give, at all times.
    const std::string log = log_of_the_truth("speed [m/s],lateral_acceleration [g]",
                                             [](const Truth&, double) { return std::string("30,0.98"); });
    const Written written;
    written.add("log.csv", log);
    const std::string base = (source_folder() / "tests/bad_cases/good/car.toml").string();
    const Reading slippery = read_case(written.add("case.toml", "include = [\"" + base +
                                                                    "\"]\n[vehicle]\ncorner = \"FR\"\nfriction = 0.8\n"
                                                                    "[[drive.file]]\npath = \"log.csv\"\n"));
    EXPECT_TRUE(warns(slippery, "at FR: the forces exceed what the tire can give in 100 % of the time"));
}

TEST(VehicleCase, EachRunMayHaveItsCorner) {
    // Two runs of one log: the tire at the front left in one, at the rear right in the other; the columns are inputs of the
    // car and not what a diagnosis may take for a cause.
    const Written written;
    written.add("log.csv", log_of_the_truth("V [km/h],AccY [g],AccX [m/s2],yaw_rate [deg/s],bulk_temperature [degC]",
                                            [](const Truth& truth, double t) {
                                                return fmt::format(
                                                    "{:.9f},{:.9f},{:.9f},{:.9f},{:.3f}", 3.6 * truth.V, truth.ay / g,
                                                    truth.ax, truth.r * 180.0 / 3.14159265358979323846, 30.0 + 0.1 * t);
                                            }));
    const std::string base = (source_folder() / "tests/bad_cases/good/car.toml").string();
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml",
        "include = [\"" + base + "\"]\n[vehicle]\nsmoothing = \"0 s\"\n[[run]]\nname = \"one\"\nfile = \"log.csv\"\n" +
            columns + "[[run]]\nname = \"two\"\nfile = \"log.csv\"\n" + columns + "vehicle = { corner = \"RR\" }\n"));
    ASSERT_TRUE(reading.experiment.has_value());
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_TRUE(runs[0].unused.empty());
    EXPECT_NEAR(runs[0].problem.input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                Truth(20.0).load(true, true), 1e-3);
    EXPECT_NEAR(runs[1].problem.input_signals.at(20.0, solver::JumpSide::after).vertical_load,
                Truth(20.0).load(false, false), 1e-3);
}

// Written once more, in steps of 5 ms: 5000 J/K, 40 W/K, and the front left wheel's 32.5 % of m a_x wherever the car slows down. The
// program smooths the signals over 0.2 s, which blunts the power by less than 1 %.
TEST(VehicleCase, BrakeWarmsUpByThePowerOfBraking) {
    const solver::Problem problem = problem_of(read(plain_log(), "corner = \"FL\"\ndrag_area = \"0 m2\""));
    const auto inputs = [&](double t) { return problem.input_signals.at(t, solver::JumpSide::after); };
    const double air = inputs(0.0).air_temperature;
    double T = air;
    double hottest = air;
    for (int i = 0; i < 12000; ++i) {
        const Truth truth(0.005 * i);
        const double power = std::max(0.0, -0.325 * 1200.0 * truth.ax) * (truth.V - 0.75 * truth.r);
        T += 0.005 * (power - 40.0 * (T - air)) / 5000.0;
        hottest = std::max(hottest, T);
        if (i % 1000 == 0) {
            EXPECT_NEAR(inputs(0.005 * (i + 1)).brake_temperature, T, 0.01 * (hottest - air) + 0.02) << 0.005 * i;
        }
    }
    EXPECT_GT(hottest - air, 10.0);
    const solver::Problem stated =
        problem_of(read(plain_log(), "corner = \"FL\"\nbrake_heat_capacity = \"10 kJ/K\"\nbrake_cooling = \"0 W/K\""));
    EXPECT_LT(stated.input_signals.at(30.0, solver::JumpSide::after).brake_temperature, hottest);
}

}  // namespace tiretherm::input::known_car
