// SPDX-License-Identifier: BSD-3-Clause
// A case from the log of a car: a tire at each corner that has readings, [vehicle] with what is assumed, arrays across the tread.
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "input/new_case/made.hpp"
#include "input/runs/read_experiment.hpp"

namespace tiretherm::input {
namespace {

/// A channel of a made-up logger: heading with its unit, and values over time.
struct Logged {
    std::string heading;
    std::function<double(double)> value;
};

/// Ten seconds at 10 Hz of a car in bends of up to 0.8 g at 108 km/h, positive in left turns.
std::vector<Logged> motion() {
    const auto bend = [](double t) { return 0.8 * std::sin(t); };
    return {{"GPS Speed [km/h]", [](double) { return 108.0; }},
            {"LatAcc [g]", bend},
            {"LonAcc [g]", [](double) { return 0.0; }},
            {"YawRate [deg/s]", [bend](double t) { return bend(t) * 9.80665 / 30.0 * 180.0 / 3.14159265358979; }},
            {"Ambient Temp [C]", [](double) { return 20.0; }},
            {"Engine RPM [rpm]", [](double t) { return 5000.0 + 100.0 * t; }}};
}

Logged warming(const std::string& heading, double from) {
    return {heading, [from](double t) { return from + 0.37 * t + 0.01 * std::sin(7.0 * t + from); }};
}

std::string table(const std::vector<Logged>& channels) {
    std::string text = "Time [s]";
    for (const Logged& channel : channels) {
        text += "," + channel.heading;
    }
    for (int i = 0; i <= 100; ++i) {
        text += fmt::format("\n{:.1f}", 0.1 * i);
        for (const Logged& channel : channels) {
            text += fmt::format(",{:.6g}", channel.value(0.1 * i));
        }
    }
    return text + "\n";
}

std::vector<Logged> operator+(std::vector<Logged> some, const std::vector<Logged>& more) {
    some.insert(some.end(), more.begin(), more.end());
    return some;
}

/// Readings of an infrared sensor at each corner; the front left tire starts at 31 degC.
std::vector<Logged> four_tires() {
    return {warming("Tire Temp FL [C]", 31.0), warming("Tire Temp FR [C]", 33.0), warming("Tire Temp RL [C]", 35.0),
            warming("Tire Temp RR [C]", 37.0)};
}

bool assumes(const NewCase& made, std::string_view key) {
    return std::ranges::find(made.assumed, key, &AssumedValue::key) != made.assumed.end();
}

// At rest 1350 kg load each tire with 1350 * 9.80665/4 = 3310 N; in the log's first sample nothing turns the car.
TEST(NewCaseCar, HasATireAtEachCornerAndAVehicle) {
    const Written written;
    written.add("laps.csv", table(motion() + four_tires()));
    const NewCase made = make(written, "225/50 R17", "", "laps.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.mesh_name, "two_node");
    EXPECT_TRUE(made.log->is_car);
    EXPECT_EQ(column_of(made, "Tire Temp RL").full_name(), "surface_temperature of RL");
    EXPECT_TRUE(column_of(made, "Engine RPM").is_foreign);
    for (const char* key :
         {"vehicle.mass", "vehicle.friction", "vehicle.rear_cornering_stiffness", "initial.temperature"}) {
        EXPECT_TRUE(assumes(made, key)) << key;
    }
    EXPECT_FALSE(assumes(made, "drive.vertical_load"));

    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    ASSERT_EQ(runs.size(), 4U);
    const std::array<std::string, 4> corners{"FL", "FR", "RL", "RR"};
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(runs[i].corner, corners.at(i));
        EXPECT_EQ(runs[i].series.size(), 1U);
        EXPECT_NEAR(runs[i].problem.input_signals.at(0.0, solver::JumpSide::after).vertical_load, 3310.0, 5.0);
        // The mean of the first second's readings: 0.5 s of warming above the first, and the wave's share of 0.01 K.
        const double first = 31.0 + 2.0 * static_cast<double>(i) + 0.37 * 0.5;
        EXPECT_NEAR(runs[i].problem.initial.front() - 273.15, first, 0.01) << corners.at(i);
    }
}

// The peak of 0.8 g, and a tenth more, is below 1.1: a dry road. At 1.2 g it is 1.32.
TEST(NewCaseCar, FrictionIsAboveWhatTheLogShows) {
    const Written written;
    written.add("slow.csv", table(motion() + four_tires()));
    EXPECT_NE(make(written, "225/50 R17", "", "slow.csv").text.find("\nfriction = 1.10 "), std::string::npos);
    std::vector<Logged> fast = motion() + four_tires();
    fast[1].value = [](double t) { return t < 9.0 ? 1.2 : 0.0; };
    fast[3].value = [](double t) { return t < 9.0 ? 1.2 * 9.80665 / 30.0 * 57.29578 : 0.0; };
    written.add("fast.csv", table(fast));
    EXPECT_NE(make(written, "225/50 R17", "", "fast.csv").text.find("\nfriction = 1.32 "), std::string::npos);
}

TEST(NewCaseCar, ReadingsSideBySideTakeACrossSection) {
    const Written written;
    written.add("zones.csv", table(motion() + std::vector<Logged>{warming("Tyre Temp FL Inner [C]", 34.0),
                                                                  warming("Tyre Temp FL Centre [C]", 32.0),
                                                                  warming("Tyre Temp FL Outer [C]", 30.0)}));
    const NewCase made = make(written, "225/50 R17", "", "zones.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.mesh_name, "section");
    EXPECT_EQ(column_of(made, "Tyre Temp FL Outer").name, "outside_shoulder_surface_temperature");
    const NewCase lumped = make(written, "225/50 R17", "two_node", "zones.csv");
    EXPECT_EQ(column_of(lumped, "Tyre Temp FL Outer").reason,
              "the mesh two_node cannot represent outside_shoulder_surface_temperature, --mesh section can");
}

TEST(NewCaseCar, NoTireLosesItsOnlyReadingToTheMesh) {
    const Written written;
    written.add("tpms.csv", table(motion() + std::vector<Logged>{warming("TPMS Temp FL [C]", 34.0),
                                                                 warming("TPMS Temp RR [C]", 36.0)}));
    const NewCase gas = make(written, "225/50 R17", "", "tpms.csv");
    EXPECT_EQ(gas.mesh_name, "section");
    EXPECT_EQ(gas.log->use, LogUse::run);
    written.add("crown.csv", table(motion() + std::vector<Logged>{warming("Tyre Temp FL Centre [C]", 34.0)}));
    EXPECT_EQ(make(written, "225/50 R17", "", "crown.csv").mesh_name, "section");
    written.add("mixed.csv", table(motion() + std::vector<Logged>{warming("Tire Temp FL [C]", 34.0),
                                                                  warming("TPMS Temp RR [C]", 36.0)}));
    EXPECT_EQ(make(written, "225/50 R17", "", "mixed.csv").mesh_name, "section");
    written.add("gas.csv", table(motion() + std::vector<Logged>{warming("gas_temperature [C]", 36.0)}));
    EXPECT_EQ(make(written, "225/50 R17", "", "gas.csv").mesh_name, "section");
    written.add("both.csv", table(motion() + four_tires() + std::vector<Logged>{warming("TPMS Temp FL [C]", 34.0)}));
    EXPECT_EQ(make(written, "225/50 R17", "", "both.csv").mesh_name, "two_node");
}

// Four readings across 225 mm of tread: the first lies from -112.5 to -56.25 mm.
TEST(NewCaseCar, NumberedReadingsAreAnArrayAcrossTheTread) {
    std::vector<Logged> channels = motion();
    for (const char* corner : {"FL", "RR"}) {
        for (int i = 1; i <= 4; ++i) {
            channels.push_back(warming(fmt::format("Tire Temp {} {:02d} [C]", corner, i), 30.0 + 1.7 * i));
        }
    }
    const Written written;
    written.add("array.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "array.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.log->infrared_zones, 4);
    EXPECT_TRUE(assumes(made, "infrared_1"));
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    ASSERT_EQ(reading.experiment->runs.size(), 2U);
    const MeasuredRun& run = reading.experiment->runs[1];
    EXPECT_EQ(run.corner, "RR");
    ASSERT_EQ(run.series.size(), 4U);
    EXPECT_EQ(run.problem.channels[run.series[0].channel].meaning,
              "outer surface, mean from -112.5 to -56.25 mm along the meridian");
    // All four in the first second: 30 + 1.7 * 2.5 + 0.37 * 0.5.
    EXPECT_NEAR(run.problem.initial.front() - 273.15, 34.435, 0.01);
}

TEST(NewCaseCar, ANumberInTheNameOfTheOnlySensorIsNoArray) {
    const Written written;
    written.add("one.csv",
                table(motion() + std::vector<Logged>{warming("IR 2 FL [C]", 30.0), warming("IR 3 FR [C]", 32.0)}));
    const NewCase made = make(written, "225/50 R17", "", "one.csv");
    EXPECT_EQ(made.log->infrared_zones, 0);
    EXPECT_EQ(column_of(made, "IR 2 FL").full_name(), "surface_temperature of FL");
    EXPECT_EQ(column_of(made, "IR 3 FR").full_name(), "surface_temperature of FR");
}

TEST(NewCaseCar, WhatIsUnclearIsAsked) {
    const Written written;
    written.add("gap.csv", table(motion() + four_tires() +
                                 std::vector<Logged>{warming("IR FL 1 [C]", 30.0),
                                                     warming("IR FL 3 [C]", 32.0),
                                                     {"Camber FL [deg]", [](double t) { return -2.0 + 0.1 * t; }},
                                                     {"Brake Pressure", [](double t) { return t; }}}));
    const NewCase made = make(written, "225/50 R17", "section", "gap.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(column_of(made, "IR FL 3").reason, "which place across the tread?");
    EXPECT_EQ(column_of(made, "Camber FL").full_suggestion(), "camber of FL");
    EXPECT_EQ(column_of(made, "Brake Pressure").reason, "it has no unit");
    EXPECT_NE(made.text.find("# \"Camber FL\" = \"camber\""), std::string::npos) << made.text;
}

TEST(NewCaseCar, WithoutUnitsSaysWhereToWriteThem) {
    std::vector<Logged> channels = motion() + four_tires();
    for (Logged& channel : channels) {
        channel.heading.resize(channel.heading.find(" ["));
    }
    const Written written;
    written.add("bare.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "bare.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    ASSERT_EQ(made.missing.size(), 1U);
    EXPECT_EQ(made.missing[0].what, "9 columns have no unit, such as GPS Speed");
    EXPECT_EQ(
        made.missing[0].remedy,
        "say them, as in --unit \"GPS Speed=km/h\" or, of several, --unit \"*temp*=degC\", and call `tiretherm new` "
        "again with --force");
    const NewCase told =
        make(written, "225/50 R17", "", "bare.csv",
             {{"GPS Speed", "km/h"}, {"*Acc", "g"}, {"Yaw*", "deg/s"}, {"*Temp*", "degC"}, {"Time", "s"}});
    ASSERT_TRUE(told.errors.empty()) << errors_of(told, written);
    ASSERT_TRUE(told.log.has_value());
    EXPECT_EQ(told.log->corners_measured().size(), 4U);
    EXPECT_NE(told.text.find("\"GPS Speed\" = \"km/h\""), std::string::npos) << told.text;
    const ExperimentReading reading = read_experiment(written.add("case.toml", told.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    EXPECT_EQ(reading.experiment->runs.size(), 4U);
    const NewCase other = make(written, "225/50 R17", "", "bare.csv", {{"GPS Speed", "degC"}});
    ASSERT_EQ(other.errors.size(), 1U);
    EXPECT_EQ(other.errors[0].what, "GPS Speed looks like speed, and the unit given to it is degC");
    const NewCase wrong = make(written, "225/50 R17", "", "bare.csv", {{"GPS Sped", "km/h"}, {"Time", "sx"}});
    EXPECT_EQ(errors_of(wrong, written),
              "bare.csv: no column is called GPS Sped, which is given a unit\n"
              "    remedy: did you mean `GPS Speed`?\n"
              "bare.csv: \"sx\", the unit given to Time, is no unit\n"
              "    remedy: give one such as km/h, degC, bar, g or deg/s\n");
}

// Rows of 50 in whole numbers are no seconds of a car. On a bench, where samples may be minutes apart, they are.
TEST(NewCaseCar, RowsOfFiftyAreMilliseconds) {
    std::vector<Logged> channels = motion() + four_tires();
    std::string text = table(channels);
    const Written written;
    std::string counted;
    int row = 0;
    for (const std::string& line : lines_of(text)) {
        const std::size_t comma = line.find(',');
        counted += (counted.empty() ? "timestamp" : std::to_string(50 * row++)) + line.substr(comma) + "\n";
    }
    written.add("counted.csv", counted);
    const NewCase made = make(written, "225/50 R17", "", "counted.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_DOUBLE_EQ(made.log->time.back(), 5.0);
    EXPECT_EQ(column_of(made, "timestamp").unit, "ms");
    const ExperimentReading reading = read_experiment(written.add("case.toml", made.text));
    ASSERT_TRUE(reading.experiment.has_value()) << render(reading.errors.front());
    EXPECT_DOUBLE_EQ(reading.experiment->runs.front().time.back(), 5.0);
}

// Brakes without speed's slope or accelerations say nothing that a case could use.
TEST(NewCaseCar, BrakesWithoutAMotionAreLeftOut) {
    std::vector<Logged> channels = four_tires();
    channels.push_back({"GPS Speed [km/h]", [](double) { return 108.0; }});
    channels.push_back({"Brake Pressure [bar]", [](double t) { return 10.0 * t; }});
    const Written written;
    written.add("brakes.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "brakes.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_TRUE(column_of(made, "Brake Pressure").is_dropped);
    EXPECT_EQ(made.log->corners_measured().size(), 4U);
}

TEST(NewCaseCar, WithoutReadingsOfTiresDrivesOne) {
    const Written written;
    written.add("drive.csv", table(motion()));
    const NewCase made = make(written, "225/50 R17", "", "drive.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.log->use, LogUse::drive);
    EXPECT_TRUE(assumes(made, "vehicle.corner"));
}

TEST(NewCaseCar, LogOfOneTireIsNone) {
    const Written written;
    std::vector<Logged> channels = motion();
    channels.push_back({"vertical_load [N]", [](double) { return 4000.0; }});
    channels.push_back(warming("surface_temperature [degC]", 30.0));
    written.add("rig.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "rig.csv");
    ASSERT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(made.mesh_name, "section");
    EXPECT_FALSE(made.log->is_car);
    EXPECT_EQ(made.text.find("[vehicle]"), std::string::npos);
}

}  // namespace
// An accelerometer that is not connected is passed over for the one that is, wherever it stands.
TEST(NewCaseCar, TakesTheLiveOneOfTwoAccelerations) {
    const Written written;
    const std::vector<Logged> channels{
        {"GPS Speed [km/h]", [](double t) { return 108.0 + 30.0 * std::sin(0.5 * t); }},
        {"latacc [g]", [](double) { return 0.0; }},
        {"longacc [g]", [](double) { return 0.0; }},
        {"latacc-calc [g]", [](double t) { return 0.8 * std::sin(t); }},
        {"Tire Temp FL [C]", [](double t) { return 40.0 + 0.37 * t + 0.01 * std::sin(7.0 * t); }}};
    written.add("log.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "log.csv");
    EXPECT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_EQ(column_of(made, "latacc-calc").name, "lateral_acceleration");
    EXPECT_EQ(column_of(made, "latacc").name, "");
    EXPECT_EQ(column_of(made, "latacc").reason, "stands at 0 in all its samples while the car moves");
    EXPECT_EQ(column_of(made, "longacc").name, "");
}

namespace {

/// A car of 108 km/h -+ 9 m/s in 10 s, whose logger has these accelerations.
NewCase with_axes(const std::string& first, const std::string& second, double swing, const Written& written) {
    const std::vector<Logged> channels{
        {"GPS Speed [km/h]", [=](double t) { return 108.0 + 3.6 * swing * std::sin(t); }},
        {first + " [g]", [=](double t) { return swing * std::cos(t) / 9.80665 + 0.01 * std::sin(31.0 * t); }},
        {second + " [g]", [](double t) { return 0.8 * std::sin(0.7 * t) + 0.01 * std::sin(37.0 * t); }},
        {"YawRate [deg/s]",
         [](double t) { return 0.8 * std::sin(0.7 * t) * 9.80665 / 30.0 * 180.0 / 3.14159265358979; }},
        {"Tire Temp FL [C]", [](double t) { return 40.0 + 0.37 * t + 0.01 * std::sin(7.0 * t); }}};
    written.add("log.csv", table(channels));
    return make(written, "225/50 R17", "", "log.csv");
}

}  // namespace

// X lies along the car and Y across it, unless the logger lies across the car: the slope of speed tells. At a steady speed nothing does.
TEST(NewCaseCar, AccelerationsByAxisAreTakenAsTheyFollowTheSpeed) {
    using Pair = std::pair<const char*, const char*>;
    for (const auto& [x, y] :
         {Pair{"AccX", "AccY"}, Pair{"Accel X", "Accel Y"}, Pair{"x_acc", "y_acc"}, Pair{"accx", "accy"}}) {
        const Written written;
        const NewCase along = with_axes(x, y, 9.0, written);
        EXPECT_TRUE(along.errors.empty()) << errors_of(along, written);
        EXPECT_EQ(column_of(along, x).name, "longitudinal_acceleration") << x;
        EXPECT_EQ(column_of(along, y).name, "lateral_acceleration") << y;
        const NewCase across = with_axes(y, x, 9.0, written);
        EXPECT_EQ(column_of(across, y).name, "longitudinal_acceleration") << y;
        EXPECT_EQ(column_of(across, x).name, "lateral_acceleration") << x;
    }
    const Written written;
    const NewCase steady = with_axes("AccX", "AccY", 0.0, written);
    EXPECT_EQ(column_of(steady, "AccX").name, "");
    EXPECT_EQ(column_of(steady, "AccY").reason,
              "it does not follow the slope of speed, nor does another axis: how the logger lies is not known");
}

// An axis that reads gravity points up or down; what a device calls Z may lie across the car as well.
TEST(NewCaseCar, AnUprightAxisIsKnownByGravity) {
    const Written written;
    EXPECT_EQ(column_of(with_axes("AccX", "AccZ", 9.0, written), "AccZ").reason,
              "its mean is not that of gravity: whether it points upwards is not known");
    for (const double gravity : {1.0, -1.0}) {
        const std::vector<Logged> channels{
            {"GPS Speed [km/h]", [](double t) { return 108.0 + 32.4 * std::sin(t); }},
            {"AccZ [g]", [=](double t) { return gravity + 0.1 * std::sin(31.0 * t); }},
            {"YawRate [deg/s]", [](double t) { return 15.0 * std::sin(0.7 * t); }},
            {"Tire Temp FL [C]", [](double t) { return 40.0 + 0.37 * t + 0.01 * std::sin(7.0 * t); }}};
        written.add("log.csv", table(channels));
        const NewCase made = make(written, "225/50 R17", "", "log.csv");
        EXPECT_TRUE(made.errors.empty()) << errors_of(made, written);
        EXPECT_EQ(column_of(made, "AccZ").name, "vertical_acceleration");
    }
}

// Neither acceleration nor yaw rate nor steering: the heading tells the turns, and the case has a [vehicle]. Its template has both
// signs. The tire's sensor says nothing for a second; the tire starts at what it says then.
TEST(NewCaseCar, AHeadingMakesAVehicle) {
    const Written written;
    const std::vector<Logged> channels{
        {"GPS Speed [km/h]", [](double t) { return 108.0 + 30.0 * std::sin(0.5 * t); }},
        {"GPS Heading [deg]", [](double t) { return 100.0 - 14.0 * std::sin(t); }},
        {"Tire Temp FL [C]", [](double t) { return t < 0.95 ? 80.0 : 40.0 + 0.37 * t + 0.01 * std::sin(70.0 * t); }}};
    written.add("log.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "log.csv");
    EXPECT_TRUE(made.errors.empty()) << errors_of(made, written);
    EXPECT_NE(made.text.find("[vehicle]"), std::string::npos);
    EXPECT_EQ(column_of(made, "GPS Heading").other_use, "course");
    EXPECT_NE(made.text.find("# yaw_rate_sign = \"right\""), std::string::npos) << made.text;
    EXPECT_NE(made.text.find("# lateral_acceleration_sign = \"right\""), std::string::npos);
    EXPECT_EQ(made.text.find("80 degC"), std::string::npos) << made.text;
}

// 20 m/s on a circle of 100 m: positions alone tell the turns, and that is what they are used for.
TEST(NewCaseCar, PositionsTellTheTurns) {
    const Written written;
    const auto degrees = [](double metres) { return metres / 111195.0; };
    const std::vector<Logged> channels{
        {"GPS Speed [km/h]", [](double) { return 72.0; }},
        {"Latitude [deg]", [&](double t) { return degrees(100.0 * std::sin(0.2 * t)); }},
        {"Longitude [deg]", [&](double t) { return degrees(100.0 * std::cos(0.2 * t)); }},
        {"Tire Temp FL [C]", [](double t) { return 40.0 + 0.37 * t + 0.01 * std::sin(70.0 * t); }}};
    written.add("log.csv", table(channels));
    const NewCase made = make(written, "225/50 R17", "", "log.csv");
    EXPECT_EQ(column_of(made, "Latitude").other_use, "course") << errors_of(made, written);
    EXPECT_EQ(column_of(made, "Longitude").other_use, "course");
    EXPECT_FALSE(column_of(made, "Latitude").is_foreign);
}

}  // namespace tiretherm::input
