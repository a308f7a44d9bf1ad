// SPDX-License-Identifier: BSD-3-Clause
// What loggers of cars call their channels: names as the exports of several makes have them.
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "input/loggers/car_columns.hpp"

namespace tiretherm::input {
namespace {

/// The surest thing, "surface_temperature of FL"; empty: none.
std::string meant_by(std::string_view heading) {
    const std::vector<CarColumn> found = car_columns(heading);
    if (found.empty()) {
        return {};
    }
    return found.front().corner.empty() ? found.front().name : found.front().name + " of " + found.front().corner;
}

TEST(CarColumns, AreFoundByTheNamesThatLoggersGive) {
    for (const auto& [heading, expected] : {
             std::pair{"GPS Speed", "speed"},
             std::pair{"Ground Speed", "speed"},
             std::pair{"velocity", "speed"},
             std::pair{"G Force Lat", "lateral_acceleration"},
             std::pair{"GPS LatAcc", "lateral_acceleration"},
             std::pair{"LateralAcc", "lateral_acceleration"},
             std::pair{"Lateral acceleration", "lateral_acceleration"},
             std::pair{"latacc", "lateral_acceleration"},
             std::pair{"G_LAT", "lateral_acceleration"},
             std::pair{"G Force Long", "longitudinal_acceleration"},
             std::pair{"InlineAcc", "longitudinal_acceleration"},
             std::pair{"LongAccel", "longitudinal_acceleration"},
             std::pair{"G Force Vert", "vertical_acceleration"},
             std::pair{"VertAcc", "vertical_acceleration"},
             std::pair{"Vertical Acceleration", "vertical_acceleration"},
             std::pair{"AccZ", "vertical_acceleration"},
             std::pair{"accz", "vertical_acceleration"},
             std::pair{"Acceleration Z", "vertical_acceleration"},
             std::pair{"Gyro Yaw Velocity", "yaw_rate"},
             std::pair{"YawRate", "yaw_rate"},
             std::pair{"ROTY", "yaw_rate"},
             std::pair{"Steered Angle", "steering_wheel_angle"},
             std::pair{"SteeringWheelAngle", "steering_wheel_angle"},
             std::pair{"STEERANGLE", "steering_wheel_angle"},
             std::pair{"Brake Pres Front", "brake_pressure"},
             std::pair{"BRAKE", "brake_pressure"},
             std::pair{"Ambient Temp", "air_temperature"},
             std::pair{"AirTemp", "air_temperature"},
             std::pair{"TrackTemp", "road_temperature"},
             std::pair{"ROAD_TEMP", "road_temperature"},
             std::pair{"Tire Temp FL", "surface_temperature of FL"},
             std::pair{"TyreTemp_LF", "surface_temperature of FL"},
             std::pair{"Tyre Temp Front Right Centre", "crown_surface_temperature of FR"},
             std::pair{"Tyre Surface Temp RL Outer", "outside_shoulder_surface_temperature of RL"},
             std::pair{"IR Temp RR inner", "inside_shoulder_surface_temperature of RR"},
             std::pair{"Tire Temp Core RR", "bulk_temperature of RR"},
             std::pair{"TYRE_TAIR_LF", "gas_temperature of FL"},
             std::pair{"TPMS Temp FR", "gas_temperature of FR"},
             std::pair{"TPMS Press RL", "inflation_pressure of RL"},
             std::pair{"TYRE_PRESS_RR", "inflation_pressure of RR"},
             std::pair{"Brake Temp FL", "brake_temperature of FL"},
             std::pair{"Brake Disc Temp RR", "brake_temperature of RR"},
             std::pair{"Wheel Load FL", "vertical_load of FL"},
             std::pair{"LFtempCM", "bulk_temperature of FL"},
             std::pair{"RRpressure", "inflation_pressure of RR"},
             std::pair{"BRK", "brake_pressure"},
             std::pair{"FL Tire Temp In", "inside_shoulder_surface_temperature of FL"},
         }) {
        EXPECT_EQ(meant_by(heading), expected) << heading;
    }
}

TEST(CarColumns, WhatOnlySoundsAlikeIsLeftAlone) {
    for (const char* heading :
         {"Wheel Speed FL",   "Engine Speed",   "Speed Std Dev",   "Slip Speed",           "GPS Speed Accuracy",
          "Yaw Acceleration", "Wheel Acc Vert", "Steering Torque", "Steering Wheel Speed", "Brake Caliper Temp FL",
          "Brake Bias",       "Air Temp Inlet", "Intake Air Temp", "Tyre Target Temp FL",  "Rim Temp FL",
          "Damper Pos FL",    "Throttle",       "Engine RPM",      "Fuel Pressure",        "Tire Temp",
          "Oil Temp",         "Latitude",       "Longitude"}) {
        EXPECT_EQ(meant_by(heading), "") << heading;
    }
}

TEST(CarColumns, OfAnArrayHaveTheirNumber) {
    for (const auto& [heading, number] :
         {std::pair{"Tyre Temp FL 01", 1}, std::pair{"IR_RR_16", 16}, std::pair{"TireTempFR8", 8}}) {
        const std::vector<CarColumn> found = car_columns(heading);
        ASSERT_EQ(found.size(), 1U) << heading;
        EXPECT_EQ(found.front().place, number) << heading;
    }
    EXPECT_FALSE(car_columns("Tire Temp FL").front().place.has_value());
}

// A name that says where alone is what its unit measures; a pressure is not a temperature, a percentage is neither.
TEST(CarColumns, AreWhatTheirUnitMeasuresWhereTheNameLeavesItOut) {
    const auto only = [](const char* name, const char* unit) {
        const std::vector<CarColumn> found = car_columns(Heading{.name = name, .unit = unit});
        return found.empty() ? std::string() : found.front().name + " " + found.front().corner;
    };
    EXPECT_EQ(only("Tyre FL", "degC"), "surface_temperature FL");
    EXPECT_EQ(only("Tyre FL", "degF"), "surface_temperature FL");
    EXPECT_EQ(only("Tyre FL", "psi"), "inflation_pressure FL");
    EXPECT_EQ(only("Tyre FL", "%"), "");
    EXPECT_EQ(only("Ambient", "degC"), "air_temperature ");
    EXPECT_EQ(only("Ambient", "bar"), "");
    EXPECT_EQ(only("Brake RR", "degC"), "brake_temperature RR");
    EXPECT_TRUE(car_columns(Heading{.name = "Tyre FL", .unit = {}}).empty());
    EXPECT_GT(car_columns(Heading{.name = "Tyre FL", .unit = "degC"}).front().rank,
              car_columns(Heading{.name = "Tread FL IR", .unit = "degC"}).front().rank);
}

TEST(CarColumns, WithASignThatDiffersAreAsked) {
    for (const char* heading : {"Camber FL", "Slip Angle RL", "Slip Ratio RR"}) {
        ASSERT_EQ(car_columns(heading).size(), 1U) << heading;
        EXPECT_FALSE(car_columns(heading).front().question.empty()) << heading;
    }
}

}  // namespace
}  // namespace tiretherm::input
