// SPDX-License-Identifier: BSD-3-Clause
// Numbers of the car that a fit moves, and tires that differ from axle to axle.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/vehicle/known_car.hpp"

namespace tiretherm::input::known_car {

// The rear tires are twice as stiff as the front ones: for the forces of the turn, far below the grip, they need half of the slip angle,
// within 5 % for the curvature. The front tires do not know of it.
TEST(VehicleNumbers, RearTiresMayHaveAFileOfTheirOwn) {
    const std::string tir = (source_folder() / "tests/input/data/made_up.tir").string();
    std::ifstream in(tir);
    std::string text(std::istreambuf_iterator<char>(in), {});
    const std::size_t key = text.find("PKY1");
    ASSERT_NE(key, std::string::npos);
    const std::size_t number = text.find_first_of("-0123456789", text.find('=', key));
    const std::size_t end = text.find_first_not_of("-+.eE0123456789", number);
    text.replace(number, end - number, fmt::format("{}", 2.0 * std::stod(text.substr(number, end - number))));
    const Written written;
    const std::string stiff = written.add("stiff.tir", text);
    const std::string unset =
        R"("vehicle.friction", "vehicle.front_cornering_stiffness", "vehicle.rear_cornering_stiffness",
"vehicle.front_slip_stiffness", "vehicle.rear_slip_stiffness")";
    const auto slip_angle = [&](const std::string& corner, const std::string& rear) {
        const solver::Problem problem = problem_of(
            read(plain_log(), "corner = \"" + corner + "\"\nproperty_file = \"" + tir + "\"\n" + rear, columns, unset));
        return problem.input_signals.at(5.0, solver::JumpSide::after).slip_angle;
    };
    const std::string other = "rear_property_file = \"" + stiff + "\"\n";
    EXPECT_EQ(slip_angle("FR", other), slip_angle("FR", ""));
    const double alike = slip_angle("RR", "");
    EXPECT_GT(std::abs(alike), 1e-3);
    EXPECT_NEAR(slip_angle("RR", other) / alike, 0.5, 0.025);
}

// A fit moves a number of the car; what the tire then gets is what a case with that number would give it.
TEST(VehicleNumbers, MovedNumberIsThatOfACaseWithIt) {
    const std::string tir = (source_folder() / "tests/input/data/made_up.tir").string();
    struct Move {
        std::string_view key;
        std::string before;
        double value;
        std::string text;
        bool of_file = false;
        std::string beside{};  ///< what else it needs
        std::string unset{};
    };
    const std::vector<Move> moves{
        {"mass", "\"1200 kg\"", 1400.0, "\"1400 kg\""},
        {"wheelbase", "\"2.5 m\"", 2.7, "\"2.7 m\""},
        {"front_track", "\"1.5 m\"", 1.6, "\"1.6 m\""},
        {"rear_track", "\"1.5 m\"", 1.7, "\"1.7 m\""},
        {"centre_of_gravity_height", "\"0.5 m\"", 0.6, "\"60 cm\""},
        {"front_weight_share", "0.44", 0.5, "0.5"},
        {"yaw_inertia", "\"1848 kg m2\"", 2000.0, "\"2000 kg m2\""},
        {"front_roll_centre_height", "\"0 m\"", 0.1, "\"10 cm\""},
        {"rear_roll_centre_height", "\"0 m\"", 0.1, "\"10 cm\""},
        {"front_roll_stiffness_share", "0.6", 0.5, "0.5"},
        {"front_toe_in", "\"0 rad\"", 0.002, "\"0.002 rad\""},
        {"rear_toe_in", "\"0 rad\"", 0.002, "\"0.002 rad\""},
        {"drag_area", "\"0 m2\"", 0.8, "\"0.8 m2\""},
        {"air_density", "\"1.2 kg/m3\"", 1.0, "\"1 kg/m3\"", false, "drag_area = \"0.8 m2\"\n"},
        {"downforce_area", "\"0.5 m2\"", 1.5, "\"1.5 m2\"", false, "front_downforce_share = 0.4\n"},
        {"front_downforce_share", "0.4", 0.6, "0.6", false, "downforce_area = \"1.5 m2\"\n"},
        {"front_drive_share", "0.3", 0.5, "0.5", false, "driven_axle = \"all\"\n"},
        {"centre_of_gravity_behind_front_axle", "\"1.4 m\"", 1.2, "\"1.2 m\"", false, "",
         ", \"vehicle.front_weight_share\""},
        {"front_brake_share", "0.65", 0.7, "0.7"},
        {"front_cornering_stiffness", "\"90 kN/rad\"", 110e3, "\"110 kN/rad\""},
        {"rear_cornering_stiffness", "\"100 kN/rad\"", 110e3, "\"110 kN/rad\""},
        {"front_slip_stiffness", "\"90 kN\"", 110e3, "\"110 kN\""},
        {"rear_slip_stiffness", "\"100 kN\"", 110e3, "\"110 kN\""},
        {"friction", "1.1", 1.3, "1.3"},
        {"friction_scale", "1", 1.2, "1.2", true},
        {"stiffness_scale", "1", 1.2, "1.2", true},
        {"brake_heat_capacity", "\"5 kJ/K\"", 8000.0, "\"8 kJ/K\""},
        {"brake_cooling", "\"40 W/K\"", 70.0, "\"70 W/K\""}};
    for (const physics::Corner corner : {physics::Corner::front_left, physics::Corner::rear_right}) {
        const std::string at =
            fmt::format("corner = \"{}\"\n", physics::corner_names[static_cast<std::size_t>(corner)]);
        for (const Move& move : moves) {
            constexpr std::string_view stiffnesses = R"(, "vehicle.front_cornering_stiffness",
"vehicle.rear_cornering_stiffness", "vehicle.front_slip_stiffness", "vehicle.rear_slip_stiffness")";
            const std::string unset =
                fmt::format("\"vehicle.friction\"{}{}", move.of_file ? stiffnesses : std::string_view(), move.unset);
            const std::string tires = move.of_file             ? "property_file = \"" + tir + "\"\n"
                                      : move.key == "friction" ? ""
                                                               : "friction = 1.1\n";
            const auto car_with = [&](const std::string& text) {
                return problem_of(read(plain_log(), at + tires + move.beside + fmt::format("{} = {}\n", move.key, text),
                                       columns, unset));
            };
            const solver::Problem other = car_with(move.text);
            solver::Problem moved = car_with(move.before);
            const auto spec = std::ranges::find(vehicle_numbers(), move.key, &VehicleNumberSpec::key);
            ASSERT_NE(spec, vehicle_numbers().end()) << move.key;
            const solver::FreeParameter number{.name = std::string(move.key),
                                               .unit = {},
                                               .kind = solver::FreeParameter::Kind::input,
                                               .parameter = static_cast<std::size_t>(spec - vehicle_numbers().begin()),
                                               .layers = {},
                                               .knots = {},
                                               .nodes = {},
                                               .runs = {}};
            const solver::Problem before = moved;
            solver::move(moved, number, solver::value_of(moved, number), move.value);
            double change = 0.0;
            for (std::size_t i = 0; i < n_samples; ++i) {
                const double t = step * static_cast<double>(i);
                const physics::Inputs ours = moved.input_signals.at(t, solver::JumpSide::after);
                const physics::Inputs theirs = other.input_signals.at(t, solver::JumpSide::after);
                const physics::Inputs old = before.input_signals.at(t, solver::JumpSide::after);
                ASSERT_NEAR(ours.vertical_load, theirs.vertical_load, 1e-8) << move.key;
                ASSERT_NEAR(ours.slip_angle, theirs.slip_angle, 1e-9) << move.key;
                ASSERT_NEAR(ours.slip_ratio, theirs.slip_ratio, 1e-9) << move.key;
                ASSERT_NEAR(ours.lateral_force, theirs.lateral_force, 1e-8) << move.key;
                ASSERT_NEAR(ours.longitudinal_force, theirs.longitudinal_force, 1e-8) << move.key;
                ASSERT_NEAR(ours.speed, theirs.speed, 1e-9) << move.key;
                ASSERT_NEAR(ours.brake_temperature, theirs.brake_temperature, 1e-8) << move.key;
                change = std::max(
                    {change, std::abs(ours.vertical_load - old.vertical_load),
                     1e4 * std::abs(ours.slip_angle - old.slip_angle), 1e4 * std::abs(ours.slip_ratio - old.slip_ratio),
                     std::abs(ours.lateral_force - old.lateral_force), 1e2 * std::abs(ours.speed - old.speed),
                     std::abs(ours.brake_temperature - old.brake_temperature)});
            }
            const bool is_of_front = move.key == "front_toe_in" || move.key == "front_cornering_stiffness" ||
                                     move.key == "front_slip_stiffness";
            const bool is_of_rear = move.key.starts_with("rear_");
            const bool counts_here = corner == physics::Corner::front_left ? !is_of_rear : !is_of_front;
            EXPECT_TRUE(change > 0.1 || !counts_here) << move.key << " changes nothing";
        }
    }
}

// The turn that the steering tells, and its limit of ten times that of a car without slip beyond the critical speed, which only a fit
// can pass: L + K V^2 = 2.5 - 4.26667e-4 x 25^2 = 2.233 m with 90 kN/rad in front, 0.25 m where it would be less.
TEST(VehicleNumbers, MovedSteeringTellsAnotherTurn) {
    const std::string log = log_of_the_truth("speed [m/s],steering_wheel_angle [deg]",
                                             [](const Truth&, double) { return std::string("25,3"); });
    const auto number = [](VehicleNumber of) {
        return solver::FreeParameter{.name = {},
                                     .unit = {},
                                     .kind = solver::FreeParameter::Kind::input,
                                     .parameter = static_cast<std::size_t>(of),
                                     .layers = {},
                                     .knots = {},
                                     .nodes = {},
                                     .runs = {}};
    };
    const auto load = [](const solver::Problem& problem) {
        return problem.input_signals.at(20.0, solver::JumpSide::after).vertical_load;
    };
    solver::Problem moved = problem_of(read(log, "steering_ratio = 15", ""));
    solver::move(moved, number(VehicleNumber::steering_ratio), 15.0, 12.0);
    EXPECT_NEAR(load(moved), load(problem_of(read(log, "steering_ratio = 12", ""))), 1e-8);
    // K = 528/18e6 - 672/200e3 = -3.33067e-3: L + K V^2 = 0.418 m with 9 MN/rad in front; 40 kN/rad behind make it 528/18e6 -
    // 672/80e3 = -8.37067e-3 and L + K V^2 < 0, so that r = V delta/0.25 m with delta = 3 deg/15: a_y = 25^2 0.00349066/0.25 =
    // 8.72665 m/s2, and FL carries 2588.9556 - 0.6 1200 8.72665 0.5/1.5 = 494.56 N.
    solver::Problem oversteering = problem_of(read(log, "steering_ratio = 15", ""));
    solver::move(oversteering, number(VehicleNumber::front_cornering_stiffness), 90e3, 9e6);
    solver::move(oversteering, number(VehicleNumber::rear_cornering_stiffness), 100e3, 40e3);
    EXPECT_NEAR(load(oversteering), 494.56, 0.01);
}

}  // namespace tiretherm::input::known_car
