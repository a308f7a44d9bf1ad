// SPDX-License-Identifier: BSD-3-Clause
// Four tires in one case: what belongs to a corner, what to all, and parameters by axle, side and corner.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "input/drive/corner.hpp"
#include "input/measurements/made_up_log.hpp"
#include "input/measurements/measured_bench.hpp"
#include "input/parameters/overlay.hpp"

namespace tiretherm::input {

namespace {

/// Two laps of a car: a load, a surface and a bulk temperature of each front tire, a surface temperature of the rear left one.
constexpr std::string_view car_log =
    "time [s],speed [km/h],air_temperature [degC],road_temperature [degC],Fz_FL [N],Fz_FR [N],Fz_RL [N],Fz_RR [N],"
    "S_FL [degC],S_FR [degC],S_RL [degC],B_FL [degC]\n"
    "0,36,25,30,4000,3000,2500,2600,30.0,31.0,32.0,27.0\n"
    "2,54,25,30,4100,2900,2500,2600,30.5,31.5,32.5,27.1\n"
    "5,72,25,31,4200,2800,2500,2600,31.0,32.0,33.0,27.2\n";

const std::string corners = R"(
[effects.air_convection]
lambda_h = 0.8
[[corner]]
name = "FL"
columns = { Fz_FL = "vertical_load", S_FL = "surface_temperature", B_FL = "bulk_temperature" }
drive = { camber = "-3 deg" }
[[corner]]
name = "FR"
columns = { Fz_FR = "vertical_load", S_FR = "surface_temperature" }
effects = { air_convection = { lambda_h = 0.9 } }
[[corner]]
name = "RL"
columns = { Fz_RL = "vertical_load", S_RL = "surface_temperature" }
[[run]]
file = "laps.csv"
)";

ExperimentReading read_with_corners(const Written& written, const std::string& tables) {
    written.add("laps.csv", car_log);
    return read_experiment(written.add("case.toml", std::string(bench) + tables));
}

std::string said(const ExperimentReading& reading, const Written& written) {
    return replaced(error_report(reading), written.folder().generic_string() + "/", "");
}

double load_at(const MeasuredRun& run, double time) {
    return run.problem.input_signals.at(time, solver::JumpSide::after).vertical_load;
}

const solver::FreeParameter& parameter(const Experiment& experiment, const std::string& name) {
    for (const solver::FreeParameter& one : experiment.parameters) {
        if (one.name == name) {
            return one;
        }
    }
    throw std::out_of_range(name);
}

}  // namespace

// Each corner is a run of its own with its columns: 4200, 2800 and 2500 N at 5 s. The speed is that of all.
TEST(Corner, HasColumnsInputsAndSensorsOfItsOwn) {
    const Written written;
    const ExperimentReading reading = read_with_corners(written, corners);
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    EXPECT_EQ(said(reading, written), "warning: case.toml:31: no active effect and no sensor uses camber\n");
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_EQ(runs[0].name, "laps_FL");
    EXPECT_EQ(runs[1].corner, "FR");
    EXPECT_EQ(runs[2].recording, "laps");
    EXPECT_NEAR(load_at(runs[0], 5.0), 4200.0, 1e-9);
    EXPECT_NEAR(load_at(runs[1], 5.0), 2800.0, 1e-9);
    EXPECT_NEAR(load_at(runs[2], 5.0), 2500.0, 1e-9);
    for (const MeasuredRun& run : runs) {
        EXPECT_NEAR(run.problem.input_signals.at(2.0, solver::JumpSide::after).speed, 15.0, 1e-12);
    }
    ASSERT_NE(find_series(runs[0], "bulk_temperature"), nullptr);
    EXPECT_EQ(find_series(runs[1], "bulk_temperature"), nullptr);
    EXPECT_NEAR(find_series(runs[1], "surface_temperature")->value[2], 305.15, 1e-9);
    EXPECT_NEAR(runs[0].problem.input_signals.at(1.0, solver::JumpSide::after).camber, -3.0 * std::acos(-1.0) / 180.0,
                1e-12);
    EXPECT_FALSE(runs[1].problem.input_signals.gives(*physics::find_signal("camber")));
}

// What differs in one run alone: the front right tire starts at 40 degC, the others at 23.
TEST(Corner, MayStartElsewhereInOneRun) {
    const Written written;
    const ExperimentReading reading =
        read_with_corners(written, corners + "corner = { FR = { initial = { temperature = \"40 degC\" } } }\n");
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    EXPECT_NEAR(reading.experiment->runs[0].problem.initial.front(), 296.15, 1e-9);
    EXPECT_NEAR(reading.experiment->runs[1].problem.initial.front(), 313.15, 1e-9);
}

// Three corners: two on the front axle, two on the left. A parameter of an axle belongs to its runs alone and starts at the
// value of its first corner; a shared one belongs to all.
TEST(Corner, ParametersAreOfAllOfAnAxleOfASideOrOwn) {
    const auto with = [&](const std::string& each) {
        const Written written;
        const ExperimentReading reading = read_with_corners(
            written, corners + "[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\n" + each);
        EXPECT_TRUE(reading.experiment) << said(reading, written);
        return reading.experiment.value_or(Experiment{});
    };
    using Runs = std::vector<std::size_t>;
    const std::string name = "air_convection.lambda_h";
    EXPECT_EQ(parameter(with(""), name).runs, Runs{});
    const Experiment by_axle = with("each = \"axle\"\n");
    EXPECT_EQ(parameter(by_axle, name + ", front").runs, (Runs{0, 1}));
    EXPECT_EQ(parameter(by_axle, name + ", rear").runs, Runs{2});
    const Experiment by_side = with("each = \"side\"\n");
    EXPECT_EQ(parameter(by_side, name + ", left").runs, (Runs{0, 2}));
    EXPECT_EQ(parameter(by_side, name + ", right").runs, Runs{1});
    const Experiment by_corner = with("each = \"corner\"\n");
    ASSERT_EQ(by_corner.parameters.size(), 3U);
    EXPECT_NEAR(parameter(by_corner, name + ", FL").prior, 0.8, 1e-15);
    EXPECT_NEAR(parameter(by_corner, name + ", FR").prior, 0.9, 1e-15);
}

// Fitted values of corners go to their tables, starts of corners to their run: read again they give the fitted problems.
TEST(Corner, FittedValuesAreReadAgain) {
    const Written written;
    const ExperimentReading reading = read_with_corners(
        written, corners +
                     "[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\neach = \"axle\"\n"
                     "[[parameter]]\ninitial = \"temperature\"\n");
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    const Experiment& experiment = *reading.experiment;
    ASSERT_EQ(experiment.parameters.size(), 5U);
    std::vector<solver::Problem> fitted;
    std::vector<OverlaidRun> runs;
    fitted.reserve(3);
    for (std::size_t r = 0; r < 3; ++r) {
        solver::Problem& problem = fitted.emplace_back(experiment.runs[r].problem);
        for (std::size_t j = 0; j < experiment.parameters.size(); ++j) {
            const solver::FreeParameter& one = experiment.parameters[j];
            if (one.belongs_to(r)) {
                const bool is_start = one.kind == solver::FreeParameter::Kind::initial;
                const double from = is_start ? 0.0 : experiment.parameters[j].prior;
                solver::move(problem, one, from,
                             is_start ? 1.0 + static_cast<double>(j) : 0.5 + 0.1 * static_cast<double>(j));
            }
        }
        runs.push_back({.name = experiment.runs[r].name,
                        .problem = &fitted[r],
                        .recording = experiment.runs[r].recording,
                        .corner = experiment.runs[r].corner});
    }
    const std::string text = overlay_text({.original = written.folder() / "case.toml",
                                           .before = &experiment.runs.front().problem,
                                           .fitted = &fitted.front(),
                                           .parameters = experiment.parameters,
                                           .runs = runs},
                                          written.folder());
    const ExperimentReading again = read_experiment(written.add("fitted.toml", text));
    ASSERT_TRUE(again.experiment) << said(again, written) << text;
    for (std::size_t r = 0; r < 3; ++r) {
        const solver::Problem& now = again.experiment->runs[r].problem;
        EXPECT_NEAR(now.initial.front(), fitted[r].initial.front(), 1e-9) << text;
        for (std::size_t e = 0; e < now.effects.size(); ++e) {
            EXPECT_EQ(now.effects[e].parameters, fitted[r].effects[e].parameters) << text;
        }
    }
}

// The rear right tire has a load and no sensor. It is left out with a warning; a run in which no corner has one is an error.
TEST(Corner, IsLeftOutWhereNothingIsMeasured) {
    const std::string rear_right = "[[corner]]\nname = \"RR\"\ncolumns = { Fz_RR = \"vertical_load\" }\n";
    const Written written;
    const ExperimentReading reading = read_with_corners(written, rear_right + corners);
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    EXPECT_EQ(reading.experiment->runs.size(), 3U);
    EXPECT_NE(said(reading, written).find("the run laps measures nothing at RR: left out"), std::string::npos)
        << said(reading, written);
    const ExperimentReading nothing = read_with_corners(written, rear_right + "[[run]]\nfile = \"laps.csv\"\n");
    EXPECT_FALSE(nothing.experiment);
    EXPECT_NE(said(nothing, written).find("no corner of the run laps measures anything"), std::string::npos)
        << said(nothing, written);
}

// In the first second of the run S_FL reads 30.0 and S_FR 31.0 degC; from 2 s on 30.5 and 31.5 degC.
TEST(Corner, StartsWhereItsSensorDoes) {
    const std::string start = "[initial]\ntemperature = \"surface_temperature\"\n";
    std::string text(bench);
    const std::size_t at = text.find("[initial]");
    text.replace(at, text.find("[[sensor]]", at) - at, start);
    const Written written;
    written.add("laps.csv", car_log);
    const ExperimentReading reading = read_experiment(
        written.add("case.toml", text + corners + "[[run]]\nfile = \"laps.csv\"\nname = \"late\"\nfrom = \"1 s\"\n"));
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    EXPECT_NEAR(runs[0].problem.initial.front(), 303.15, 1e-9);
    EXPECT_NEAR(runs[1].problem.initial.front(), 304.15, 1e-9);
    EXPECT_NEAR(runs[3].problem.initial.front(), 303.65, 1e-9);
    EXPECT_NEAR(runs[4].problem.initial.front(), 304.65, 1e-9);
}

TEST(Corner, WithoutTheSensorOfItsStartSaysSo) {
    std::string text(bench);
    const std::size_t at = text.find("[initial]");
    text.replace(at, text.find("[[sensor]]", at) - at, "[initial]\ntemperature = \"bulk_temperature\"\n");
    const Written written;
    written.add("laps.csv", car_log);
    const ExperimentReading reading = read_experiment(written.add("case.toml", text + corners));
    EXPECT_NE(said(reading, written)
                  .find("temperature is set to what bulk_temperature reads, and the run laps_FR has no such reading"),
              std::string::npos)
        << said(reading, written);
}

// The corner is a value beside the sentence: of two corners, FL and FR are all, and of four they are named once.
TEST(Corner, WhatIsSaidOfAllStandsOnce) {
    using Sentences = std::vector<std::string>;
    const InputWarning left{.file = "case.toml", .line = 4, .corner = "FL", .what = "the load is computed"};
    const InputWarning smoothed{.file = "case.toml", .line = 4, .what = "smoothed"};
    InputWarning right = left;
    right.corner = "FR";
    const std::vector<InputWarning> said{
        left, smoothed, right, smoothed, {.file = "laps.csv", .corner = "FR", .what = "S is stuck"}};
    EXPECT_EQ(render(said, 2),
              (Sentences{"case.toml:4: the load is computed", "case.toml:4: smoothed", "laps.csv: at FR: S is stuck"}));
    EXPECT_EQ(render(said, 4).front(), "case.toml:4: at FL and FR: the load is computed");
    EXPECT_EQ(render({left}, 1), Sentences{"case.toml:4: at FL: the load is computed"});
}

// Whatever the sentence is, with another place or with a corner in its words: of one corner and of the whole case are two.
TEST(Corner, TheWordsOfAWarningDoNotSayWhereItIs) {
    using Sentences = std::vector<std::string>;
    const std::string what = "log: at FR: the sensor is stuck";
    EXPECT_EQ(
        render({{.file = "a.csv", .corner = "FL", .what = what}, {.file = "a.csv", .corner = "RL", .what = what}}, 4),
        Sentences{"a.csv: at FL and RL: log: at FR: the sensor is stuck"});
    EXPECT_EQ(render({{.what = what}, {.what = "log: the sensor is stuck"}}, 1),
              (Sentences{what, "log: the sensor is stuck"}));
}

TEST(Corner, MistakesAreNamed) {
    const Written written;
    const ExperimentReading reading = read_with_corners(written, R"([[corner]]
name = "front_left"
[[corner]]
name = "FL"
[[corner]]
name = "FL"
columns = { Fz_FL = "vertical_load", S_FL = "surface_temperature" }
[[run]]
file = "laps.csv"
corner = { RX = { initial = { temperature = "40 degC" } } }
[[parameter]]
initial = "temperature"
each = "corner"
)");
    const std::string text = said(reading, written);
    for (const char* part : {"name cannot be \"front_left\"", "a second [[corner]] is called \"FL\"",
                             "\"RX\" is not a corner", "cannot differ from one corner to the other"}) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    }
    const ExperimentReading without = read_with_corners(
        written,
        "[[run]]\nfile = \"laps.csv\"\ncolumns = { Fz_FL = \"vertical_load\", S_FL = \"surface_temperature\" }\n"
        "[effects.air_convection]\n[[parameter]]\neffect = \"air_convection\"\nkey = \"lambda_h\"\neach = \"axle\"\n");
    EXPECT_NE(said(without, written).find("the case has no [[corner]]"), std::string::npos) << said(without, written);
}

// Three readings of the front left tire at a stop 4 s into the log: two lumps have one sensor for them, which takes the mean,
// (40 + 41 + 45)/3 = 42 degC; two sensors take one each. The rear left tire was not measured.
TEST(Pyrometer, GivesNumbersToItsRunAndCorner) {
    const Written written;
    const std::string stop =
        "[[pyrometer]]\nuncertainty = \"2 K\"\ntime = \"4 s\"\nFL = [\"40 degC\", \"41 degC\", \"45 "
        "degC\"]\nFR = \"38 degC\"\nsensors = ";
    const ExperimentReading reading = read_with_corners(written, corners + stop + "[\"bulk_temperature\"]\n");
    ASSERT_TRUE(reading.experiment) << said(reading, written);
    const std::vector<MeasuredRun>& runs = reading.experiment->runs;
    ASSERT_EQ(runs[0].numbers.size(), 1U);
    EXPECT_NEAR(runs[0].numbers[0].value, 273.15 + 42.0, 1e-9);
    EXPECT_EQ(runs[0].numbers[0].time, 4.0);
    EXPECT_EQ(runs[0].numbers[0].standard_deviation, 2.0);
    EXPECT_EQ(runs[0].numbers[0].source, "pyrometer");
    EXPECT_EQ(runs[0].problem.channels[runs[0].numbers[0].channel].name, "bulk_temperature");
    ASSERT_EQ(runs[1].numbers.size(), 1U);
    EXPECT_NEAR(runs[1].numbers[0].value, 273.15 + 38.0, 1e-9);
    EXPECT_TRUE(runs[2].numbers.empty());
    const ExperimentReading two = read_with_corners(
        written, corners + replaced(stop, ", \"45 degC\"", "") + "[\"surface_temperature\", \"bulk_temperature\"]\n");
    EXPECT_TRUE(said(two, written)
                    .starts_with("case.toml:45:6: FR has 1 value for 2 sensors\n    FR = \"38 degC\"\n         "
                                 "^~~~~~~~~\n    remedy: give one for each "
                                 "sensor, in their order; several of a single sensor are averaged\n"));
}

// A sensor looks at one tire: its column at two corners is one of them mistaken for the other.
TEST(Corner, TwoCornersOnOneColumnAreTold) {
    const Written written;
    const std::string said_of_two =
        said(read_with_corners(written, replaced(corners, "S_FR = \"", "S_FL = \"")), written);
    EXPECT_NE(said_of_two.find("the column S_FL is surface_temperature of FL and FR: it belongs to one tire"),
              std::string::npos)
        << said_of_two;
    const std::string said_of_misspelt =
        said(read_with_corners(written, replaced(corners, "S_FR = \"", "S_FX = \"")), written);
    EXPECT_NE(said_of_misspelt.find("no file of a [[run]] has the column \"S_FX\""), std::string::npos)
        << said_of_misspelt;
}

namespace {

std::string shipped(const std::string& file) { return (source_folder() / "cases/car" / file).string(); }

/// The case with more over it. @param unset quoted keys
ExperimentReading read_corners(const Written& written, const std::string& more, const std::string& unset = "") {
    return read_experiment(
        written.add("case.toml", "include = [\"" + shipped("session.toml") + "\"]\nunset = [" + unset + "]\n" + more));
}

/// What is said of left and right; empty: nothing.
std::string sides_of(const ExperimentReading& reading) {
    EXPECT_TRUE(reading.experiment) << error_report(reading);
    const auto found = std::ranges::find_if(reading.data_warnings, [](const std::string& sentence) {
        return sentence.find("exchanged") != std::string::npos;
    });
    return found == reading.data_warnings.end() ? "" : *found;
}

bool has(const std::string& text, std::string_view words) { return text.find(words) != std::string::npos; }

/// Columns of the tires of an axle, each of the other side where they are exchanged.
std::string corner(const std::string& name, const std::string& of) {
    return "[[corner]]\nname = \"" + name + "\"\ncolumns = { \"Tire Temp " + of + "\" = \"surface_temperature\" }\n";
}

}  // namespace

// The car has both positive in left turns (README.md beside it); its other logs have measured loads and slips.
TEST(ExchangedSides, NothingIsSaidOfTheShippedCars) {
    EXPECT_EQ(sides_of(read_experiment(shipped("session.toml"))), "");
    EXPECT_EQ(sides_of(read_experiment(shipped("wheels.toml"))), "");
}

// Yaw rate and lateral acceleration read as positive in right turns load the wrong tires. The temperatures say so, and so
// do the positions of the log.
TEST(ExchangedSides, WrongSignsOfBothAreTold) {
    const std::string signs =
        "[vehicle]\nyaw_rate_sign = \"right\"\nlateral_acceleration_sign = \"left\"\nsteering_sign = \"right\"\n";
    const Written written;
    const ExperimentReading reading = read_corners(written, signs);
    const std::string said = sides_of(reading);
    EXPECT_TRUE(
        has(said,
            "left and right are probably exchanged: the measured differences of left and right tires go against "
            "what their loads and slips make (r = -0."))
        << said;
    EXPECT_TRUE(has(said,
                    "and over ground the car turns the other way. Both signs decide: turn yaw_rate_sign and "
                    "lateral_acceleration_sign of [vehicle] round"))
        << said;
    EXPECT_TRUE(has(error_report(reading), "beside the course by the positions it is positive in left ones"));
}

// The columns of the front tires alone are exchanged: the rear ones are right, and so are the signs. All four exchanged while
// the car turns as over ground: it is the columns again.
TEST(ExchangedSides, ExchangedColumnsAreTold) {
    const Written written;
    const std::string front = sides_of(read_corners(
        written, corner("FL", "FR") + corner("FR", "FL") + corner("RL", "RL") + corner("RR", "RR"), "\"corner\""));
    EXPECT_TRUE(has(front, "FL and FR are probably exchanged")) << front;
    EXPECT_TRUE(has(front, "exchange their columns")) << front;
    const std::string all = sides_of(read_corners(
        written, corner("FL", "FR") + corner("FR", "FL") + corner("RL", "RR") + corner("RR", "RL"), "\"corner\""));
    EXPECT_TRUE(
        has(all, "though the car's turns are those over ground: are the columns of left and right tires exchanged?"))
        << all;
}

namespace {

/// What is said of a car that goes left and right in turn, as on a skidpad, with 2 or 4 kN on each front tire at 36 km/h. A reading
/// follows 20 K/kN with a time constant of 6 s, and has noise of 0.5 K.
/// @param turn s, of both sides  @param delay s, of the readings  @param right the column of the right tire's readings
std::string sides_on_a_skidpad(double turn, double delay, const std::string& left, const std::string& right) {
    std::string log =
        "time [s],speed [km/h],air_temperature [degC],road_temperature [degC],Fz_FL [N],Fz_FR [N],A [degC],B [degC]";
    Noise noise(0.5);
    const auto load = [&](double t) { return std::fmod(t + turn, turn) < 0.5 * turn ? 2000.0 : 4000.0; };
    double a = 80.0;
    double b = 80.0;
    for (int i = 0; i <= 640; ++i) {
        const double t = 0.5 * i;
        a += 0.5 / 6.0 * (20.0 + 0.02 * load(t - delay) - a);
        b += 0.5 / 6.0 * (20.0 + 0.02 * (6000.0 - load(t - delay)) - b);
        log += fmt::format("\n{},36,25,30,{},{},{:.2f},{:.2f}", t, load(t), 6000.0 - load(t), a + noise(), b + noise());
    }
    const Written written;
    written.add("laps.csv", log + "\n");
    const auto tire = [](const std::string& name, const std::string& reading) {
        return fmt::format(
            "[[corner]]\nname = \"{0}\"\ncolumns = {{ Fz_{0} = \"vertical_load\", {1} = \"surface_temperature\" }}\n",
            name, reading);
    };
    return sides_of(read_experiment(written.add(
        "case.toml", std::string(bench) + tire("FL", left) + tire("FR", right) + "[[run]]\nfile = \"laps.csv\"\n")));
}

}  // namespace

// Turns that are all alike count for few samples, however many they are; but each of eight says the same.
TEST(ExchangedSides, AreToldOfTurnsThatAreAllAlike) {
    const std::string said = sides_on_a_skidpad(40.0, 0.0, "B", "A");
    EXPECT_TRUE(has(said, "left and right are probably exchanged")) << said;
    EXPECT_EQ(sides_on_a_skidpad(40.0, 0.0, "A", "B"), "");
}

// In a slalom of 8 s readings that come 4 s late go against the loads as well, and of exchanged columns nothing else is known.
TEST(ExchangedSides, AreNotToldWhereReadingsMayBeLate) {
    EXPECT_EQ(sides_on_a_skidpad(8.0, 4.0, "A", "B"), "");
    EXPECT_EQ(sides_on_a_skidpad(8.0, 0.0, "B", "A"), "");
}

// The columns that no tire uses are the same for all of a recording, and are kept once.
TEST(Corner, SharesTheColumnsThatNoTireUses) {
    const Written written;
    written.add("laps.csv",
                "time [s],speed [km/h],air_temperature [degC],road_temperature [degC],Fz_FL [N],Fz_FR [N],S_FL [degC],"
                "S_FR [degC],oil [bar]\n0,36,25,30,4000,3000,30,31,2\n2,54,25,30,4100,2900,30,31,3\n");
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml",
        std::string(bench) +
            "[[corner]]\nname = \"FL\"\ncolumns = { Fz_FL = \"vertical_load\", S_FL = \"surface_temperature\" }\n"
            "[[corner]]\nname = \"FR\"\ncolumns = { Fz_FR = \"vertical_load\", S_FR = \"surface_temperature\" }\n"
            "[[run]]\nfile = \"laps.csv\"\n"));
    ASSERT_TRUE(reading.experiment) << error_report(reading);
    const auto oil = [&](std::size_t run) {
        return *std::ranges::find(reading.experiment->runs[run].unused, "oil", &UnusedSignal::name);
    };
    EXPECT_EQ(oil(1).value, (std::vector<double>{2.0, 3.0}));
    EXPECT_EQ(oil(0).value.data(), oil(1).value.data());
}

}  // namespace tiretherm::input
