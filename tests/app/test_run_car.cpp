// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm run` of a car: all tires in one call, laps, friction power; and of one of its tires.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/input/measurements/measured_bench.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

/// Two tires of a car at 72 km/h over three laps of 20 s. FL slides with 1000 N at 2 degrees, FR without a lateral force; nobody
/// measures the tires.
struct Car {
    input::Written written;
    std::string file;

    Car() {
        std::string log = "time [s],lap,speed [km/h],air_temperature [degC],road_temperature [degC]\n";
        for (int t = 0; t <= 60; t += 2) {
            log += fmt::format("{},{},72,20,25\n", t, 1 + std::min(t / 20, 2));
        }
        written.add("lap.csv", log);
        file = written
                   .add("car.toml", std::string(input::bench) + R"([[corner]]
name = "FL"
drive = { vertical_load = "3000 N", slip_angle = "2 deg", lateral_force = "1000 N" }
[[corner]]
name = "FR"
drive = { vertical_load = "5000 N", slip_angle = "2 deg", lateral_force = "0 N" }
[[run]]
file = "lap.csv"
)")
                   .string();
    }
    [[nodiscard]] Call run(const std::string& arguments) const {
        return call("run " + file + " --no-vtk --out out " + arguments, written.folder());
    }
    [[nodiscard]] std::filesystem::path out(const std::string& name) const { return written.folder() / "out" / name; }
};

/// Power of sliding of FL: 1000 N, 20 m/s, tan(2 deg). W
const double sliding = 1000.0 * 20.0 * std::tan(2.0 * std::numbers::pi / 180.0);

TEST(RunOfACar, HasAllTiresOnOnePageAndAFolderForEach) {
    const Car car;
    const Call run = car.run("");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("2 tires"), std::string::npos) << run.out;
    EXPECT_NE(run.out.find("hottest of the tires: "), std::string::npos) << run.out;
    EXPECT_TRUE(post::read_text(car.out("channels.csv"))
                    .starts_with("time [s],surface_temperature FL [degC],bulk_temperature FL [degC],"
                                 "surface_temperature FR [degC],bulk_temperature FR [degC]\n"));
    for (const char* name : {"report.html", "page.txt", "laps.csv", "heat.csv", "lap_FL/report.html",
                             "lap_FL/channels.csv", "lap_FR/results.h5", "lap_FR/laps.csv"}) {
        EXPECT_TRUE(std::filesystem::exists(car.out(name))) << name;
    }
}

// FR carries 5000 N and slides without a force, FL 3000 N: the page's first sentence is that of the hotter tire,
// whichever comes first in the case.
TEST(RunOfACar, TheHottestTireComesFirst) {
    const Car car;
    const Call run = car.run("");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json json = Json::parse(car.run("--json").out);
    const auto hottest = [&](std::size_t i) { return json["corners"][i]["hottest"]["temperature"].get<double>(); };
    const std::string first = hottest(0) > hottest(1) ? "FL" : "FR";
    const std::string second = hottest(0) > hottest(1) ? "FR" : "FL";
    EXPECT_LT(run.out.find("\n" + first + ", hottest of the tires: "), run.out.find("\n" + second + ": ")) << run.out;
}

TEST(RunOfACar, FrictionPowerAndHeatStandByCornerAndLap) {
    const Car car;
    const Json json = Json::parse(car.run("--json").out);
    ASSERT_EQ(json["corners"].size(), 2u);
    EXPECT_EQ(json["corners"][1]["corner"], "FR");
    ASSERT_EQ(json["heat"].size(), 2u);
    const Json& front_left = json["heat"][0];
    EXPECT_NEAR(front_left["friction_watts"], sliding, 1e-3 * sliding);
    EXPECT_EQ(json["heat"][1]["friction_watts"], 0.0);
    ASSERT_EQ(front_left["laps"].size(), 3u);
    EXPECT_EQ(front_left["laps"][1]["lap"], "2");
    EXPECT_NEAR(front_left["laps"][1]["seconds"], 20.0, 1e-9);
    for (const Json& part : front_left["laps"][1]["parts"]) {
        if (part["what"] == "sliding_friction") {  // the tire's share is 0.6
            EXPECT_NEAR(part["watts"], 0.6 * sliding, 1e-3 * sliding);
        }
    }
    // The whole run of the bulk ends where the tire's own page says.
    const Json& bulk = json["run_values"][1];
    EXPECT_EQ(bulk["channel"], "bulk_temperature");
    EXPECT_NEAR(bulk["simulated"]["end"], json["corners"][0]["channels"][1]["final"].get<double>(), 1e-6);
}

TEST(RunOfACar, OneTireIsRunByItsName) {
    const Car car;
    const Json all = Json::parse(car.run("--json").out);
    const Json one = Json::parse(car.run("--run lap_FR --json").out);
    EXPECT_EQ(one["run"], "lap_FR");
    EXPECT_EQ(one["channels"], all["corners"][1]["channels"]);
    const Call wrong = car.run("--run lap_RR");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.err.find("the case has no run \"lap_RR\""), std::string::npos) << wrong.err;
    EXPECT_EQ(Json::parse(car.run("--run lap --json").out)["corners"].size(), 2u);
}

TEST(RunOfACar, WhatIfHasARowForEachTire) {
    const Car car;
    const Json json = Json::parse(car.run("--json --change 'drive.road_temperature=+5 K'").out);
    const Json& changes = json["what_if"]["changes"];
    ASSERT_EQ(changes.size(), 2u);
    EXPECT_EQ(changes[0]["corner"], "FL");
    EXPECT_EQ(changes[1]["corner"], "FR");
    EXPECT_GT(changes[1]["channels"][0]["end"], 0.0);
    EXPECT_LT(changes[1]["channels"][0]["end"], 5.0);
}

/// The case that `new` writes of the log of a car: straight on for 20 s at 100 km/h, then 100 s in a bend of 7 m/s2 to one side,
/// with three readings across each tread, and the contact pressure across it.
std::string bend_case(input::Written& written, double to_left, const std::string& pressure) {
    std::string log = "time [s],speed [km/h],LatAcc [g],YawRate [deg/s],Ambient Temp [degC]";
    std::string readings;
    for (const char* tire : {"FL", "FR", "RL", "RR"}) {
        for (const char* place : {"Inner", "Middle", "Outer"}) {
            log += fmt::format(",Tire Temp {} {} [degC]", tire, place);
            readings += ",30";
        }
    }
    log += '\n';
    for (int t = 0; t <= 120; ++t) {
        const double across = t < 20 ? 0.0 : to_left * 7.0;
        log += fmt::format("{},100,{:.4f},{:.4f},23{}\n", t, across / 9.80665,
                           across / (100.0 / 3.6) * 180.0 / std::numbers::pi, readings);
    }
    written.add("bend.csv", log);
    const Call made = call("new bend.csv --out bend.toml --force", written.folder());
    EXPECT_EQ(made.exit_code, 0) << made.err;
    std::string text = post::read_text(written.folder() / "bend.toml");
    text.insert(text.find('\n', text.find("\n[drive]") + 1) + 1, "inflation_pressure = \"" + pressure + "\"\n");
    return written.add("bend.toml", text + "\n[effects.pressure_across_tread]\n").string();
}

/// Outside, in the middle and inside of a tire at the end. degC
std::array<double, 3> across_tread(const Json& corner) {
    std::array<double, 3> temperatures{};
    for (const Json& channel : corner["channels"]) {
        const std::string name = channel["name"];
        temperatures[0] =
            name == "outside_shoulder_surface_temperature" ? channel["final"].get<double>() : temperatures[0];
        temperatures[1] = name == "crown_surface_temperature" ? channel["final"].get<double>() : temperatures[1];
        temperatures[2] =
            name == "inside_shoulder_surface_temperature" ? channel["final"].get<double>() : temperatures[2];
    }
    return temperatures;
}

// A car of 1350 kg in a bend of 7 m/s2: the road pulls all tires towards its centre, the outer ones towards the middle of the
// car and the inner ones away from it. So the outer two are hottest outside, then in the middle, then inside, by kelvins; the
// inner two are hotter inside than outside. In a bend to the right the sides change places.
TEST(RunOfACar, TheOutsideShoulderOfAnOuterTireIsTheHottestInABend) {
    for (const double to_left : {1.0, -1.0}) {
        input::Written written;
        const std::string file = bend_case(written, to_left, "220 kPa");
        const Call run = call("run " + file + " --no-vtk --no-report --json --out out", written.folder());
        ASSERT_EQ(run.exit_code, 0) << run.err;
        const Json corners = Json::parse(run.out)["corners"];
        ASSERT_EQ(corners.size(), 4U);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto [outside, middle, inside] = across_tread(corners[i]);
            const bool is_outer = (i % 2 == 1) == (to_left > 0.0);
            SCOPED_TRACE(fmt::format("{} of {}: {} {} {}", i, to_left, outside, middle, inside));
            if (is_outer) {
                EXPECT_GT(outside, middle + 2.0);
                EXPECT_GT(middle, inside + 1.0);
            } else {
                EXPECT_GT(inside, outside + 2.0);
            }
        }
    }
}

// A quarter of a bar less lets a tire sink further in and press with its shoulders: the middle of the outer front tire loses more
// than either of them.
TEST(RunOfACar, AQuarterOfABarLessCoolsTheMiddleMoreThanTheShoulders) {
    std::array<std::array<double, 3>, 2> at{};
    for (std::size_t i = 0; i < 2; ++i) {
        input::Written written;
        const std::string file = bend_case(written, 1.0, i == 0 ? "220 kPa" : "195 kPa");
        const Call run = call("run " + file + " --no-vtk --no-report --json --out out", written.folder());
        ASSERT_EQ(run.exit_code, 0) << run.err;
        at[i] = across_tread(Json::parse(run.out)["corners"][1]);
    }
    const auto change = [&](std::size_t place) { return at[1][place] - at[0][place]; };
    EXPECT_LT(change(1), change(0) - 0.5);
    EXPECT_LT(change(1), change(2) - 0.5);
}

}  // namespace
}  // namespace tiretherm::app_test
