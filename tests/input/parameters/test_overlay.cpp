// SPDX-License-Identifier: BSD-3-Clause
// A fitted case written as TOML and read back gives the fitted problem again, for every kind of parameter.

#include "input/parameters/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "input/text/quantity_specs.hpp"
#include "post/report/file.hpp"
#include "support/written.hpp"

// What was fitted is written as a case; reading it must give the fitted problem again.
namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

constexpr double zero = 273.15;

Experiment read(const fs::path& file, const std::vector<fs::path>& data = {}) {
    ExperimentReading reading = read_experiment(file, data);
    for (const InputError& error : reading.errors) {
        ADD_FAILURE() << render(error);
    }
    return reading.experiment.value_or(Experiment{});
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Moves each number of an experiment to a value of its own, in all runs that it belongs to.
Experiment moved(const Experiment& experiment, const std::vector<double>& values) {
    Experiment fitted = experiment;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const solver::FreeParameter& number = experiment.parameters[i];
        for (std::size_t r = 0; r < fitted.runs.size(); ++r) {
            if (number.belongs_to(r)) {
                solver::Problem& problem = fitted.runs[r].problem;
                solver::move(problem, number, solver::value_of(problem, number), values[i]);
            }
        }
    }
    return fitted;
}

/// Writes the fitted experiment beside nothing, in a folder of its own, and reads it again.
/// @param data whether its files were given beside the case
Experiment written_and_read(const fs::path& original, const Experiment& before, const Experiment& fitted, bool data,
                            const fs::path& file) {
    fs::create_directories(file.parent_path());
    Overlay what{.original = original,
                 .before = &before.runs.front().problem,
                 .fitted = &fitted.runs.front().problem,
                 .parameters = before.parameters,
                 .runs = {}};
    for (const MeasuredRun& run : fitted.runs) {
        what.runs.push_back({.name = run.name, .problem = &run.problem, .file = data ? run.file : ""});
    }
    post::replace_file(file, overlay_text(what, file.parent_path()));
    SCOPED_TRACE(text_of(file));
    return read(file);
}

void expect_same(const physics::Curve& read, const physics::Curve& fitted) {
    EXPECT_EQ(read.is_table(), fitted.is_table());
    for (double T = 250.0; T <= 450.0; T += 12.5) {
        EXPECT_NEAR(read.value(T), fitted.value(T), 1e-12 * std::abs(fitted.value(T))) << T - zero << " degC";
    }
}

void expect_same(const solver::Problem& read, const solver::Problem& fitted) {
    ASSERT_EQ(read.materials.size(), fitted.materials.size());
    for (std::size_t i = 0; i < read.materials.size(); ++i) {
        expect_same(read.materials[i].heat_capacity, fitted.materials[i].heat_capacity);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            expect_same(read.materials[i].conductivity[axis], fitted.materials[i].conductivity[axis]);
        }
    }
    ASSERT_EQ(read.link_laws.size(), fitted.link_laws.size());
    for (std::size_t i = 0; i < read.link_laws.size(); ++i) {
        expect_same(read.link_laws[i], fitted.link_laws[i]);
    }
    ASSERT_EQ(read.effects.size(), fitted.effects.size());
    for (std::size_t e = 0; e < read.effects.size(); ++e) {
        const physics::ActiveEffect& was = fitted.effects[e];
        const physics::ActiveEffect& is = read.effects[e];
        EXPECT_EQ(is.effect, was.effect);
        EXPECT_EQ(is.parameters, was.parameters) << was.effect->id;
        EXPECT_EQ(is.patches, was.patches) << was.effect->id;
        EXPECT_EQ(is.layers, was.layers) << was.effect->id;
        EXPECT_EQ(is.channels, was.channels) << was.effect->id;
        EXPECT_EQ(is.overrides.size(), was.overrides.size()) << was.effect->id;
        for (const physics::ActiveEffect::Override& other : was.overrides) {
            EXPECT_EQ(is.at(other.parameter, other.scope, other.index), other.value) << was.effect->id;
        }
    }
    ASSERT_EQ(read.initial.size(), fitted.initial.size());
    for (std::size_t n = 0; n < read.initial.size(); ++n) {
        EXPECT_NEAR(read.initial[n], fitted.initial[n], 1e-12 * fitted.initial[n]);
    }
}

constexpr std::string_view section = R"(
[effects.still_air]
patches = ["inside", "beads"]
h_by_patch = { inside = "12 W/m2K", beads = "40 W/m2K" }
[effects.inner_gas]
[effects.sensor_offset]
channels = ["bulk_temperature"]
[[mesh.layer]]
name = "tread"
zones = ["crown", "shoulders"]
thickness = "8 mm"
cells = 2
material = "K1"
[[mesh.layer]]
name = "carcass"
thickness = "4 mm"
cells = 2
material = "cord 2"
[[material]]
name = "K1"
density = "1100 kg/m3"
heat_capacity = { at = "20 degC", value = "1800 J/kgK", slope = "5 J/kgK/K" }
conductivity = { at = "20 degC", value = "0.29 W/mK", slope = "0.003 W/mK/K", curvature = "1e-5 W/mK/K2" }
conductivity_meridian = { at = "20 degC", value = "0.29 W/mK", slope = "0.003 W/mK/K", curvature = "1e-5 W/mK/K2" }
[[material]]
name = "cord 2"
density = "1100 kg/m3"
heat_capacity = { columns = ["temperature [degC]", "c [J/kgK]"], rows = [[0, 1800], [60, 1900], [200, 2500]] }
conductivity = "0.4 W/mK"
conductivity_meridian = "1.5 W/mK"
)";

constexpr std::string_view runs = R"(
[[run]]
name = "warm-up"
measured = [{ channel = "bulk_temperature", value = "40 degC", uncertainty = "1 K" }]
[run.initial]
tread = "31 degC"
[[run]]
name = "coast-down"
measured = [{ channel = "bulk_temperature", value = "40 degC", uncertainty = "1 K" }]
)";

std::string including(std::string_view name) {
    return "include = [\"" + (source_folder() / "tests/bad_cases/good" / name).string() + "\"]\n";
}

}  // namespace

TEST(Overlay, ReadsBackAsItWasFitted) {
    const Written written;
    const fs::path file =
        written.add("cases/mine/tire.toml", including("section.toml") + std::string(section) + std::string(runs) + R"(
[[parameter]]
effect = "air_convection"
key = "lambda_h"
[[parameter]]
effect = "air_convection"
key = "floor"
[[parameter]]
effect = "still_air"
key = "h"
patch = "beads"
[[parameter]]
effect = "sensor_offset"
key = "kelvin"
channel = "bulk_temperature"
[[parameter]]
effect = "strain_energy_loss"
key = "strain_energy_share"
zone = "crown"
[[parameter]]
material = "K1"
law = "conductivity"
at = ["40 degC", "90 degC", "140 degC"]
[[parameter]]
material = "K1"
law = "heat_capacity"
at = ["40 degC", "90 degC"]
[[parameter]]
material = "cord 2"
law = "heat_capacity"
at = ["70.3 degC"]
[[parameter]]
material = "cord 2"
law = "conductivity"
at = ["60 degC"]
[[parameter]]
initial = ["tread", "gas"]
)");
    const Experiment before = read(file);
    ASSERT_EQ(before.parameters.size(), 5U + 3U + 2U + 1U + 1U + 4U);
    const Experiment fitted = moved(before, {1.0 / 3.0, 1e2 / 3.0, 41.7, -0.123456789012345, 1.3, 0.31, 0.47, 0.71,
                                             1850.0, 2111.1, 1711.0, 1.0 / 7.0, 2.5, -0.7, 1.0 / 3.0, 4.0});
    const Experiment again = written_and_read(file, before, fitted, false, written.folder() / "out/fit 1/fitted.toml");
    ASSERT_EQ(again.runs.size(), 2U);
    for (std::size_t r = 0; r < 2; ++r) {
        EXPECT_EQ(again.runs[r].name, before.runs[r].name);
        expect_same(again.runs[r].problem, fitted.runs[r].problem);
    }
    // The first run started at 31 degC in the tread, the second at 23 degC; 2.5 and -0.7 K are added.
    const int tread = before.parameters[12].nodes.front();
    EXPECT_NEAR(again.runs[0].problem.initial[static_cast<std::size_t>(tread)], zero + 33.5, 1e-9);
    EXPECT_NEAR(again.runs[1].problem.initial[static_cast<std::size_t>(tread)], zero + 22.3, 1e-9);
    const std::string text = text_of(written.folder() / "out/fit 1/fitted.toml");
    EXPECT_TRUE(
        text.starts_with("# sound section: values fitted to warm-up and coast-down\n"
                         "include = [\"../../cases/mine/tire.toml\"]\n"))
        << text;
    EXPECT_NE(text.find("conductivity = { through = [[\"40 degC\", \"0.31 W/mK\"], [\"90 degC\", \"0.47 W/mK\"]"),
              std::string::npos)
        << text;
}

// The link of two lumps is the material's law until it is fitted; a case without runs starts where it was fitted.
TEST(Overlay, OfTwoNodesHasItsLinkAndItsStart) {
    const Written written;
    const fs::path file = written.add("tire.toml", including("tire.toml") + R"(
[[measured]]
channel = "bulk_temperature"
value = "40 degC"
uncertainty = "1 K"
[[parameter]]
link = "conductivity"
at = ["60 degC", "100 degC"]
[[parameter]]
material = "rubber"
law = "heat_capacity"
at = ["60 degC"]
[[parameter]]
initial = ["surface", "bulk"]
)");
    const Experiment before = read(file);
    ASSERT_EQ(before.parameters.size(), 5U);
    const Experiment fitted = moved(before, {0.6321, 0.87654, 1712.25, 1.0 / 3.0, -2.0});
    const Experiment again = written_and_read(file, before, fitted, false, written.folder() / "fitted.toml");
    expect_same(again.runs.at(0).problem, fitted.runs.at(0).problem);
    EXPECT_NEAR(again.runs.at(0).problem.initial.at(1), zero + 21.0, 1e-9);
    EXPECT_NEAR(again.runs.at(0).problem.materials.at(0).conductivity[2].value(300.0), 0.5, 1e-15);
}

// Files given beside the case take the place of its runs, in what is written too; paths lead from where it stands.
TEST(Overlay, NamesTheFilesThatWereGivenBesideTheCase) {
    const Written written;
    const std::string log = "time [s],bulk_temperature [degC]\n0,23\n30,25\n60,26\n";
    const fs::path one = written.add("logs/one.csv", log);
    const fs::path two = written.add("logs/two.csv", log);
    written.add("cases/old.csv", log);
    const fs::path file = written.add("cases/tire.toml", including("tire.toml") + R"(
[[run]]
file = "old.csv"
[[parameter]]
initial = "temperature"
[[parameter]]
effect = "road_contact"
key = "Hc"
)");
    const Experiment before = read(file, {one, two});
    ASSERT_EQ(before.parameters.size(), 3U);
    const Experiment fitted = moved(before, {1.0, 2.0, 432.1});
    const Experiment again = written_and_read(file, before, fitted, true, written.folder() / "out/fitted.toml");
    ASSERT_EQ(again.runs.size(), 2U);
    EXPECT_EQ(again.runs[1].name, "two");
    EXPECT_EQ(fs::weakly_canonical(again.runs[1].file), fs::weakly_canonical(two));
    expect_same(again.runs[0].problem, fitted.runs[0].problem);
    expect_same(again.runs[1].problem, fitted.runs[1].problem);
    EXPECT_NE(text_of(written.folder() / "out/fitted.toml").find("file = \"../logs/two.csv\""), std::string::npos);
}

// What [data] says of the columns of such files is then said of each run.
TEST(Overlay, SaysOfEachFileHowItsColumnsAreRead) {
    const Written written;
    const fs::path log = written.add("logs/one.csv", "t [min],T bulk,junk [1]\n0,23,1\n1,25,2\n2,26,3\n");
    const fs::path file = written.add("cases/tire.toml", including("tire.toml") + R"(
[data]
columns = { t = "time", "T bulk" = "bulk_temperature" }
units = { "T bulk" = "degC" }
ignore = ["junk"]
from = "30 s"
[[parameter]]
effect = "road_contact"
key = "Hc"
)");
    const Experiment before = read(file, {log});
    ASSERT_EQ(before.runs.size(), 1U);
    const Experiment fitted = moved(before, {432.1});
    const Experiment again = written_and_read(file, before, fitted, true, written.folder() / "out/fitted.toml");
    ASSERT_EQ(again.runs.size(), 1U);
    EXPECT_EQ(again.runs[0].time, before.runs[0].time);
    ASSERT_EQ(again.runs[0].series.size(), 1U);
    EXPECT_EQ(again.runs[0].series[0].value, before.runs[0].series[0].value);
    expect_same(again.runs[0].problem, fitted.runs[0].problem);
}

// A run that the case names by its file and laps alone is the same run in what lies over it.
TEST(Overlay, FindsARunThatOnlyItsFileNames) {
    const Written written;
    written.add(
        "drum.csv",
        "time [s],lap,bulk_temperature [degC]\n0,1,23\n30,1,24\n60,1,25\n90,2,25\n120,2,26\n150,2,26\n180,3,26\n");
    const fs::path file = written.add("tire.toml", including("tire.toml") + R"(
[[run]]
file = "drum.csv"
laps = "1-2"
[[parameter]]
initial = "bulk"
)");
    const Experiment before = read(file);
    ASSERT_EQ(before.parameters.size(), 1U);
    const Experiment fitted = moved(before, {1.25});
    const Experiment again = written_and_read(file, before, fitted, false, written.folder() / "out/fitted.toml");
    ASSERT_EQ(again.runs.size(), 1U);
    EXPECT_EQ(fs::weakly_canonical(again.runs[0].file), fs::weakly_canonical(written.folder() / "drum.csv"));
    expect_same(again.runs[0].problem, fitted.runs[0].problem);
    EXPECT_NEAR(again.runs[0].problem.initial.at(1), zero + 24.25, 1e-9);
}

// A cause that the case does not have is switched on with all its numbers, also where the case had switched it off.
TEST(Overlay, SwitchesOnWhatWasOff) {
    const Written written;
    const fs::path file = written.add("tire.toml", including("section.toml") + R"(
[effects.sidewall_convection]
on = false
[[measured]]
channel = "bulk_temperature"
value = "40 degC"
uncertainty = "1 K"
)");
    const Experiment before = read(file);
    ASSERT_FALSE(before.runs.empty());
    Experiment fitted = before;
    solver::Problem& problem = fitted.runs.front().problem;
    const mesh::Mesh& mesh = problem.mesh;
    for (const std::string_view id : {"sidewall_convection", "sensor_offset", "layer_conductivity"}) {
        physics::ActiveEffect active = physics::activate(*physics::find_effect(id), mesh);
        active.parameters[0] = 1.75;
        if (active.effect->sensor_model() != nullptr) {
            active.channels = {0};
        }
        if (active.effect->on_layers) {
            active.layers = {0};
        }
        solver::switch_on(problem, std::move(active), 300.0);
    }
    const Experiment again = written_and_read(file, before, fitted, false, written.folder() / "extended.toml");
    for (const std::size_t e : {problem.effects.size() - 3, problem.effects.size() - 2, problem.effects.size() - 1}) {
        const physics::ActiveEffect& was = problem.effects[e];
        const auto& is = again.runs.at(0).problem.effects;
        const auto found = std::find_if(is.begin(), is.end(), [&](const auto& a) { return a.effect == was.effect; });
        ASSERT_NE(found, is.end()) << was.effect->id;
        EXPECT_EQ(found->parameters, was.parameters) << was.effect->id;
        EXPECT_EQ(found->channels, was.channels) << was.effect->id;
        EXPECT_EQ(found->layers, was.layers) << was.effect->id;
        EXPECT_EQ(found->patches, was.patches) << was.effect->id;
    }
}

// An effect that is on several times, at places or for inputs of its own, becomes one table that says the same.
TEST(Overlay, PutsOneEffectAtSeveralPlacesIntoOneTable) {
    const Written written;
    const fs::path file = written.add("tire.toml", including("section.toml") + R"(
[[sensor]]
name = "bulk_temperature"
kind = "layer"
layer = "carcass"
[[sensor]]
name = "outside"
kind = "patch"
patch = "outside"
[[measured]]
channel = "bulk_temperature"
value = "40 degC"
uncertainty = "1 K"
)");
    const Experiment before = read(file);
    ASSERT_FALSE(before.runs.empty());
    Experiment fitted = before;
    solver::Problem& problem = fitted.runs.front().problem;
    ASSERT_GT(problem.channels.size(), 1U);
    ASSERT_GT(problem.mesh.layers.size(), 1U);
    const auto add = [&](std::string_view id, int place, std::string_view key, double value) {
        physics::ActiveEffect active = physics::activate(*physics::find_effect(id), problem.mesh);
        active.parameters[static_cast<std::size_t>(physics::find_parameter(*active.effect, key))] = value;
        if (active.effect->sensor_model() != nullptr) {
            active.channels = {place};
        } else if (active.effect->on_layers) {
            active.layers = {place};
        }
        solver::switch_on(problem, std::move(active), 300.0);
    };
    add("sensor_offset", 0, "kelvin", 1.75);
    add("sensor_offset", 1, "kelvin", -0.5);
    add("layer_conductivity", 0, "scale", 1.2);
    add("layer_conductivity", 1, "scale", 0.9);
    add("input_delay", 0, "speed", 0.3);
    add("input_delay", 0, "vertical_load", -0.2);
    const Experiment again = written_and_read(file, before, fitted, false, written.folder() / "extended.toml");
    const auto read_back = [&](std::string_view id) -> const physics::ActiveEffect& {
        const auto& all = again.runs.at(0).problem.effects;
        const auto found = std::ranges::find_if(all, [&](const auto& active) { return active.effect->id == id; });
        EXPECT_NE(found, all.end()) << id;
        return *found;
    };
    const physics::ActiveEffect& offset = read_back("sensor_offset");
    EXPECT_EQ(offset.channels, (std::vector<int>{0, 1}));
    EXPECT_EQ(offset.at(0, physics::Scope::channel, 0), 1.75);
    EXPECT_EQ(offset.at(0, physics::Scope::channel, 1), -0.5);
    const physics::ActiveEffect& conductivity = read_back("layer_conductivity");
    EXPECT_EQ(conductivity.at(0, physics::Scope::layer, 0), 1.2);
    EXPECT_EQ(conductivity.at(0, physics::Scope::layer, 1), 0.9);
    const physics::ActiveEffect& delay = read_back("input_delay");
    EXPECT_EQ(delay[static_cast<std::size_t>(physics::find_parameter(*delay.effect, "speed"))], 0.3);
    EXPECT_EQ(delay[static_cast<std::size_t>(physics::find_parameter(*delay.effect, "vertical_load"))], -0.2);
}

// Every parameter of the catalogue is written in its own unit and read back to the last digit.
TEST(Overlay, UnitsOfAllParametersAreRead) {
    for (const physics::Effect* effect : physics::catalogue()) {
        for (const physics::ParameterSpec& parameter : effect->parameters) {
            const double third = parameter.standard / 3.0 + (parameter.standard == 0.0 ? 1.0 / 3.0 : 0.0);
            const double value = std::clamp(third, parameter.low, parameter.high);
            const ParsedQuantity parsed = parse_quantity(fmt::format("{} {}", value, parameter.unit),
                                                         quantity_specs::of(parameter), parameter.key);
            EXPECT_FALSE(parsed.error.has_value()) << effect->id << '.' << parameter.key;
            EXPECT_EQ(parsed.value, value) << effect->id << '.' << parameter.key;
        }
    }
}

TEST(Overlay, SaysWhyItCannotBeWritten) {
    const Written written;
    const fs::path file = written.add("tire.toml", including("tire.toml"));
    const Reading reading = read_case(file);
    ASSERT_TRUE(reading.problem.has_value());
    const Overlay what{
        .original = file, .before = &*reading.problem, .fitted = &*reading.problem, .parameters = {}, .runs = {}};
    try {
        const fs::path target = written.folder() / "no/such/folder/fitted.toml";
        post::replace_file(target, overlay_text(what, target.parent_path()));
        FAIL() << "written";
    } catch (const post::FileError& error) {
        EXPECT_NE(std::string(error.what()).find("no/such/folder/fitted.toml"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("No such file or directory"), std::string::npos) << error.what();
    }
}

}  // namespace tiretherm::input
