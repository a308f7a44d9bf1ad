// SPDX-License-Identifier: BSD-3-Clause
// What the signals of a car's log are checked against: channels that are dead, clocks that differ, turns over ground.

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/vehicle/clock_shift.hpp"
#include "input/vehicle/dead_channels.hpp"
#include "input/vehicle/known_car.hpp"

namespace tiretherm::input::known_car {

namespace {

constexpr double pi = std::numbers::pi;

/// Heading of the known car, degrees clockwise from north: r = 0.2 sin 0.3 t rad/s to the left, so it has turned by
/// 0.2/0.3 (1 - cos 0.3 t).
double heading(double t) { return std::fmod(720.0 + 10.0 - 180.0 / pi * 0.2 / 0.3 * (1.0 - std::cos(0.3 * t)), 360.0); }

std::string log_with_heading(double side, const std::string& more_heads = "") {
    return log_of_the_truth("V [km/h]," + more_heads + "GPS Heading [deg]", [&](const Truth& truth, double t) {
        const std::string yaw = fmt::format("{:.9f},", side * truth.r * 180.0 / pi);
        return fmt::format("{:.9f},{}{:.6f}", 3.6 * truth.V, more_heads.empty() ? "" : yaw, heading(t));
    });
}

const std::string speed_alone = "columns = { V = \"speed\" }\n";

double load_at(const Reading& reading, double t) {
    return problem_of(reading).input_signals.at(t, solver::JumpSide::after).vertical_load;
}

VehicleLog moving_car() {
    VehicleLog log;
    for (std::size_t i = 0; i < n_samples; ++i) {
        const double t = step * static_cast<double>(i);
        const Truth truth(t);
        for (const auto& [history, value] :
             {std::pair{&log.speed, truth.V}, std::pair{&log.longitudinal_acceleration, truth.ax},
              std::pair{&log.lateral_acceleration, truth.ay}, std::pair{&log.yaw_rate, truth.r}}) {
            history->time.push_back(t);
            history->value.push_back(value);
        }
    }
    return log;
}

}  // namespace

// Without accelerations and yaw rate the heading tells the turn: its slope over 1 s of r = 0.2 sin 0.3 t is off by
// (0.3 x 1)^2/24 of it, 0.4 %; the load transfer of 1200 x 6 x 0.5/1.5 x 0.6 = 1440 N then by 6 N at most, besides the neglected
// moment of the yaw acceleration and the smoothing.
TEST(CarSignals, AHeadingAloneTellsTheTurn) {
    const Reading reading = read(log_with_heading(1.0), "", speed_alone);
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_TRUE(warns(reading, "yaw rate is the slope of the course over ground by GPS Heading, over 1 s"));
    for (const double t : {5.0, 20.0, 41.0}) {
        EXPECT_NEAR(load_at(reading, t), Truth(t).load(true, true), 25.0) << t;
    }
}

// The same way as positions on the Earth, 1e-7 degrees fine, at a fifth of the samples and repeated between.
TEST(CarSignals, PositionsAloneTellTheTurn) {
    double north = 0.0;
    double east = 0.0;
    double course = 0.0;
    std::size_t line = 0;
    std::string place;
    const std::string log =
        log_of_the_truth("V [km/h],GPS Latitude [deg],GPS Longitude [deg]", [&](const Truth& truth, double) {
            if (line++ % 5 == 0) {
                place = fmt::format("{:.7f},{:.7f}", 48.0 + north / 111195.0,
                                    11.0 + east / 111195.0 / std::cos(pi * 48.0 / 180.0));
            }
            course += truth.r * step;
            north += truth.V * std::sin(course) * step;
            east += truth.V * std::cos(course) * step;
            return fmt::format("{:.9f},{}", 3.6 * truth.V, place);
        });
    const Reading reading = read(log, "", speed_alone);
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_TRUE(warns(reading, "yaw rate is the slope of the course over ground by the positions"));
    for (const double t : {5.0, 20.0, 41.0}) {
        EXPECT_NEAR(load_at(reading, t), Truth(t).load(true, true), 120.0)
            << t;  // a transfer of 1440 N, twice smoothed
    }
}

// A yaw rate that is positive in right turns, as in SAE J670: the heading says so, and the tire gets the load it has.
TEST(CarSignals, AHeadingTellsTheSignOfTheYawRate) {
    const Reading right = read(log_with_heading(-1.0, "yaw_rate [deg/s],"), "", speed_alone);
    EXPECT_TRUE(warns(right,
                      "yaw_rate is taken as positive in right turns: its correlation with the course by GPS Heading is "
                      "-1.00"));
    EXPECT_NEAR(load_at(right, 5.0), Truth(5.0).load(true, true), 25.0);
    const Reading stated = read(log_with_heading(-1.0, "yaw_rate [deg/s],"), "yaw_rate_sign = \"left\"", speed_alone);
    EXPECT_TRUE(warns(stated,
                      "left and right are exchanged: yaw_rate_sign says positive in left turns, and beside the course "
                      "by GPS Heading it "
                      "is positive in right ones (r = -1.00)"));
}

// An accelerometer that is not connected gives nothing: the acceleration is then the slope of the speed, as without it.
TEST(CarSignals, AnAccelerationThatIsAlwaysZeroIsNotUsed) {
    const auto log = [](bool has_dead) {
        return log_of_the_truth(fmt::format("V [km/h],AccY [g],{}yaw_rate [deg/s]", has_dead ? "AccX [g]," : ""),
                                [&](const Truth& truth, double) {
                                    return fmt::format("{:.9f},{:.9f},{}{:.9f}", 3.6 * truth.V, truth.ay / g,
                                                       has_dead ? "0," : "", truth.r * 180.0 / pi);
                                });
    };
    const Reading reading = read(log(true), "");
    EXPECT_TRUE(
        warns(reading, "longitudinal_acceleration stands at 0 in all its samples while the car moves: not used"));
    EXPECT_TRUE(warns(reading, "longitudinal acceleration is the slope of speed over 1 s"));
    const Reading without = read(log(false), "", "columns = { V = \"speed\", AccY = \"lateral_acceleration\" }\n");
    EXPECT_EQ(load_at(reading, 7.0), load_at(without, 7.0));
}

// Each signal is lost from 10 to 20 s, over two thirds of a period of r = 0.2 sin 0.3 t: at 20 m/s and more the others then tell of more
// than 2 m/s2. It lives otherwise, and a car that is not lost has no such stretch.
TEST(CarSignals, ASignalThatStandsForAWhileIsSaid) {
    EXPECT_TRUE(dead_for_a_while(moving_car()).empty());
    for (const std::string_view name : {"lateral_acceleration", "yaw_rate"}) {
        VehicleLog log = moving_car();
        solver::SignalHistory& history = log.*member_of(name);
        for (std::size_t i = 0; i < n_samples; ++i) {
            history.value[i] = history.time[i] >= 10.0 && history.time[i] <= 20.0 ? 0.0 : history.value[i];
        }
        EXPECT_TRUE(dead_channels(log).empty());
        const std::vector<DeadChannel> dead = dead_for_a_while(log);
        ASSERT_EQ(dead.size(), 1U) << name;
        EXPECT_EQ(dead[0].name, name);
        EXPECT_TRUE(dead[0].why.starts_with("stands still from 10 s to 20 s while ")) << dead[0].why;
    }
}

// What is noise of a converter, 0.01 g, beside turns of 0.6 g by the yaw rate is dead as well; the same noise of a car that
// drives straight on is a reading, and so is a constant of a car that stands.
TEST(CarSignals, NoiseOfAConverterIsDeadWhereTheCarTurns) {
    VehicleLog log = moving_car();
    for (std::size_t i = 0; i < n_samples; ++i) {
        log.lateral_acceleration.value[i] = i % 3 == 0 ? 0.1 : 0.0;
    }
    const std::vector<DeadChannel> dead = dead_channels(log);
    ASSERT_EQ(dead.size(), 1U);
    EXPECT_EQ(dead[0].name, "lateral_acceleration");
    EXPECT_EQ(dead[0].why, "moves by no more than noise while other signals say that the car turns");
    std::ranges::transform(log.yaw_rate.value, log.yaw_rate.value.begin(), [](double r) { return 0.01 * r; });
    EXPECT_TRUE(dead_channels(log).empty());
    std::ranges::fill(log.speed.value, 0.0);
    std::ranges::fill(log.lateral_acceleration.value, 0.0);
    EXPECT_TRUE(dead_channels(log).empty());
    EXPECT_TRUE(dead_channels(moving_car()).empty());
}

// Two channels of a winding drive; in its second half the second one is written 65.5 s late.
TEST(CarSignals, AClockThatIsLateInHalfTheLogIsFound) {
    const auto drive = [](double t) {
        return std::sin(0.11 * t) + std::sin(0.037 * t * (1.0 + 1e-4 * t)) +
               std::sin(0.29 * t + 2.0 * std::sin(0.013 * t));
    };
    std::vector<double> time;
    std::vector<double> first;
    std::vector<double> late;
    for (double t = 0.0; t < 1200.0; t += 0.1) {
        time.push_back(t);
        first.push_back(drive(t));
        late.push_back(drive(t < 600.0 ? t : t - 65.5));
    }
    EXPECT_TRUE(clock_shifts(time, first, first).empty());
    const std::vector<ClockShift> found = clock_shifts(time, first, late);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].delay, 65.5, 0.1);    // a fifth of the step of the search
    EXPECT_NEAR(found[0].from, 600.0, 120.0);  // a window
    EXPECT_NEAR(found[0].to, 1200.0, 1.0);
}

// Laps of 75 s that are alike but for a twentieth, 40 s late throughout: in each window a lap more or less agrees nearly as well
// (0.95 to 1), over all of them 40 s does best. Laps that are quite alike leave it open.
TEST(CarSignals, AShiftIsThatOfAllWindowsAndNotOfALapMore) {
    const auto shifts = [](double of_others) {
        const auto drive = [&](double t) {
            const double lap = 2.0 * pi * t / 75.0;
            return std::sin(lap) + std::sin(3.0 * lap) + of_others * std::sin(0.05 * t + 1e-4 * t * t);
        };
        std::vector<double> time;
        std::vector<double> first;
        std::vector<double> late;
        for (double t = 0.0; t < 1000.0; t += 0.1) {
            time.push_back(t);
            first.push_back(drive(t));
            late.push_back(drive(t - 40.0));
        }
        return clock_shifts(time, first, late);
    };
    const std::vector<ClockShift> found = shifts(0.5);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].all);
    EXPECT_NEAR(found[0].delay, 40.0, 0.1);
    EXPECT_TRUE(found[0].others.empty());
    const std::vector<ClockShift> open = shifts(0.0);
    ASSERT_EQ(open.size(), 1U);
    // 115 and -110 s leave less than half of a window at an end of the log.
    ASSERT_EQ(open[0].others.size(), 1U);
    EXPECT_NEAR(std::abs(open[0].others[0] - open[0].delay), 75.0, 0.6);
}

// The same laps, late by 37.5 s, half a lap, in the last 534 s alone (four windows of nine). Turned round they agree everywhere with half a lap more or
// less, nearly; as they are they agree before without a shift, which is then left alone.
TEST(CarSignals, ASoundPartIsNotSaidToHaveTheOtherSign) {
    const auto drive = [](double t) {
        const double lap = 2.0 * pi * t / 75.0;
        return std::sin(lap) + std::sin(3.0 * lap) + 0.5 * std::sin(0.05 * t + 1e-4 * t * t);
    };
    std::vector<double> time;
    Told first{.name = "yaw_rate", .acceleration = {}};
    Told late{.name = "course", .acceleration = {}};
    for (double t = 0.0; t < 1200.0; t += 0.5) {
        time.push_back(t);
        first.acceleration.push_back(drive(t));
        late.acceleration.push_back(drive(t < 666.0 ? t : t - 37.5));
    }
    const std::vector<std::string> remarks = clock_remarks(time, first, late, true);
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_NE(remarks[0].find("from about 666 s to 1200 s course is 37.5 s late beside yaw_rate"), std::string::npos)
        << remarks[0];
}

// A speed that is 3.7 s late beside the accelerometer in the whole log: the case still runs, and the remedy has the value.
TEST(CarSignals, ALateSpeedIsToldWithItsDelay) {
    const std::string log = log_of_the_truth("V [km/h],AccX [m/s2],yaw_rate [deg/s]", [](const Truth& truth, double t) {
        const auto speed = [](double at) { return 30.0 + 3.0 * std::sin(0.2 * at) + 2.0 * std::sin(0.53 * at); };
        return fmt::format("{:.9f},{:.9f},{:.9f}", 3.6 * speed(t - 3.7),
                           0.6 * std::cos(0.2 * t) + 1.06 * std::cos(0.53 * t), truth.r * 180.0 / pi);
    });
    const Reading reading = read(log, "", "columns = { V = \"speed\", AccX = \"longitudinal_acceleration\" }\n");
    ASSERT_TRUE(reading.problem) << render(reading);
    EXPECT_TRUE(warns(reading, "speed is 3.7")) << render(reading);
    EXPECT_TRUE(warns(reading, "[effects.input_delay] with speed = \"3.7"));
    const Reading mended = read(log, "[effects.input_delay]\nspeed = \"3.7 s\"\n",
                                "columns = { V = \"speed\", AccX = \"longitudinal_acceleration\" }\n");
    ASSERT_TRUE(mended.problem) << render(mended);
    EXPECT_FALSE(warns(mended, "their clocks differ"));
}

// The accelerometer that the case takes is not connected, and another column of the log is one that is.
TEST(CarSignals, TheLiveColumnBesideADeadOneIsNamed) {
    const std::string log =
        log_of_the_truth("V [km/h],AccY [g],AccX [g],Inline Acc [g],Inline Acc 2 [g]", [](const Truth& truth, double) {
            return fmt::format("{:.9f},{:.9f},0,0.01,{:.9f}", 3.6 * truth.V, truth.ay / g, truth.ax / g);
        });
    EXPECT_TRUE(
        warns(read(log, ""),
              "longitudinal_acceleration stands at 0 in all its samples while the car moves: not used; take the column "
              "that moves: columns = { \"Inline Acc 2\" = \"longitudinal_acceleration\" }"));
}

// A car that speeds up on a straight line has a lateral acceleration of 0; it stays where nothing else tells the turns.
TEST(CarSignals, AConstantThatAloneTellsTheTurnsIsUsedWithAQuestion) {
    const std::string log = log_of_the_truth("V [km/h],AccY [g],AccX [m/s2]", [](const Truth& truth, double) {
        return fmt::format("{:.9f},0,{:.9f}", 3.6 * truth.V, truth.ax);
    });
    const Reading reading = read(log, "");
    EXPECT_TRUE(
        warns(reading,
              "lateral_acceleration stands at 0 in all its samples while the car moves, and nothing else says how it "
              "turns: is a sensor connected?"));
    EXPECT_NEAR(load_at(reading, 7.0), 0.5 * 1200.0 * (g * 1.1 - Truth(7.0).ax * 0.5) / 2.5, 25.0);
}

// A heading that stands, one that counts to the left as mathematicians do, and a temperature of a bearing: none of them is
// the course, and the positions are.
TEST(CarSignals, AHeadingThatGoesAgainstThePositionsIsPassedOver) {
    double north = 0.0;
    double east = 0.0;
    double course = 0.0;
    const std::string log = log_of_the_truth(
        "V [km/h],Bearing [degC],Heading [deg],GPS Heading [deg],Latitude [deg],Longitude [deg]",
        [&](const Truth& truth, double t) {
            course += truth.r * step;
            north += truth.V * std::sin(course) * step;
            east += truth.V * std::cos(course) * step;
            return fmt::format("{:.9f},{:.3f},12,{:.6f},{:.8f},{:.8f}", 3.6 * truth.V, 40.0 + t, 720.0 - heading(t),
                               48.0 + north / 111195.0, 11.0 + east / 111195.0 / std::cos(pi * 48.0 / 180.0));
        });
    const Reading reading = read(log, "", speed_alone);
    EXPECT_TRUE(warns(reading, "yaw rate is the slope of the course over ground by the positions")) << render(reading);
    EXPECT_NEAR(load_at(reading, 5.0), Truth(5.0).load(true, true), 120.0);
}

// Where no receiver tells the turns, a steering whose sign is stated does: here to the left, and the yaw rate goes against it.
// Without the statement one of the two is wrong, and nobody knows which.
TEST(CarSignals, TheSteeringTellsTheSignOfTheYawRate) {
    const std::string log =
        log_of_the_truth("V [km/h],yaw_rate [deg/s],steering_wheel_angle [deg]", [](const Truth& truth, double) {
            return fmt::format("{:.9f},{:.9f},{:.9f}", 3.6 * truth.V, -truth.r * 180.0 / pi, 15.0 * truth.r * 10.0);
        });
    const Reading stated = read(log, "steering_sign = \"left\"", speed_alone);
    EXPECT_TRUE(warns(stated,
                      "yaw_rate is taken as positive in right turns: its correlation with steering_wheel_angle "
                      "is -"));
    EXPECT_NEAR(load_at(stated, 5.0), Truth(5.0).load(true, true), 25.0);
    EXPECT_TRUE(warns(read(log, "", speed_alone),
                      "yaw_rate, positive in left turns, and steering_wheel_angle contradict each other (r = -"));
}

// Bends that come back after 80 s and others that do not; the receiver is 40 s late. Without a shift the turns over ground go
// against the yaw rate (r = -0.5/(0.5 + 0.32) = -0.6), with it they go along: the sign is that of the shifted ones, and is
// not read off.
TEST(CarSignals, ALateHeadingDoesNotDecideASign) {
    const auto rate = [](double t) {
        return 0.1 * (std::sin(2.0 * pi * t / 80.0) + 0.8 * std::sin(0.1 * t + 4e-4 * t * t));
    };
    std::string log = "time [s],V [km/h],yaw_rate [deg/s],GPS Heading [deg]\n";
    double course = 0.0;
    for (double t = 0.0; t < 600.0; t += 0.5) {
        course += 0.5 * rate(t - 40.25);
        log += fmt::format("{:.1f},{:.3f},{:.6f},{:.4f}\n", t, 90.0 + 5.0 * std::sin(0.2 * t), rate(t) * 180.0 / pi,
                           std::fmod(36000.0 - course * 180.0 / pi, 360.0));
    }
    const Reading reading = read(log, "", speed_alone);
    EXPECT_TRUE(warns(reading, "the course by GPS Heading is 40 s late beside yaw_rate")) << render(reading);
    EXPECT_TRUE(warns(reading, "yaw_rate is taken as positive in left turns (yaw_rate_sign)"));
}

}  // namespace tiretherm::input::known_car
