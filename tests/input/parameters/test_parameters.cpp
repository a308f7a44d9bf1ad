// SPDX-License-Identifier: BSD-3-Clause
// [[parameter]] tables: bounds, priors, units and places of free parameters, and what [identify] and [diagnose] accept.

#include "input/parameters/parameters.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "support/written.hpp"

// What a case says may be fitted, and what becomes of it. Errors are in tests/bad_cases/parameter_*.toml.
namespace tiretherm::input {

namespace {

using solver::FreeParameter;
using Kind = FreeParameter::Kind;

constexpr double celsius_zero = 273.15;
constexpr double infinite = std::numeric_limits<double>::infinity();

/// A number that makes the case an experiment; its runs, where it has some, bring their own.
constexpr std::string_view measured =
    "[[measured]]\nchannel = \"bulk_temperature\"\nvalue = \"40 degC\"\nuncertainty = \"1 K\"\n";

Experiment read(std::string text) {
    const Written written;
    text += text.find("[[run]]") == std::string::npos ? measured : "";
    ExperimentReading reading = read_experiment(written.add("case.toml", text));
    if (!reading.experiment) {
        for (const InputError& error : reading.errors) {
            ADD_FAILURE() << render(error);
        }
        return {};
    }
    return *reading.experiment;
}

std::string including(const std::string& name, const std::string& more) {
    return "include = [\"" + (source_folder() / "tests/bad_cases/good" / name).string() + "\"]\n" + more;
}

}  // namespace

// Where nothing is said: the case's value, no prior width, the parameter's own bounds (0 to 10).
TEST(Parameter, OfAnEffectHasTheEffectsBounds) {
    const Experiment read_one = read(including("tire.toml", R"(
[effects.air_convection]
lambda_h = 0.8
[[parameter]]
effect = "air_convection"
key = "lambda_h"
)"));
    ASSERT_EQ(read_one.parameters.size(), 1U);
    const FreeParameter& number = read_one.parameters.front();
    EXPECT_EQ(number.name, "air_convection.lambda_h");
    EXPECT_EQ(number.unit, "1");
    EXPECT_TRUE(number.everywhere);
    EXPECT_EQ(number.prior, 0.8);
    EXPECT_EQ(number.standard_deviation, infinite);
    EXPECT_EQ(number.low, 0.0);
    EXPECT_EQ(number.high, 10.0);
    EXPECT_EQ(solver::value_of(read_one.runs.front().problem, number), 0.8);
}

// 0.6 kW/m2K are 600 W/m2K; a standard deviation in degC is one in K, without the offset of the scale.
TEST(Parameter, ValuesAreReadInItsUnit) {
    const Experiment experiment = read(including("section.toml", R"(
[effects.sensor_offset]
channels = ["bulk_temperature"]
[[parameter]]
effect = "road_contact"
key = "Hc"
expected = "0.6 kW/m2K"
standard_deviation = "50 W/m2K"
low = "0.1 kW/m2K"
high = "1 kW/m2K"
[[parameter]]
effect = "sensor_offset"
key = "kelvin"
channel = "bulk_temperature"
standard_deviation = "0.5 degC"
low = "-3 degC"
)"));
    ASSERT_EQ(experiment.parameters.size(), 2U);
    const FreeParameter& Hc = experiment.parameters[0];
    EXPECT_NEAR(Hc.prior, 600.0, 1e-10);
    EXPECT_EQ(Hc.standard_deviation, 50.0);
    EXPECT_NEAR(Hc.low, 100.0, 1e-10);
    EXPECT_NEAR(Hc.high, 1000.0, 1e-10);
    EXPECT_EQ(Hc.unit, "W m-2 K-1");
    const FreeParameter& offset = experiment.parameters[1];
    EXPECT_EQ(offset.name, "sensor_offset.kelvin at bulk_temperature");
    EXPECT_FALSE(offset.everywhere);
    EXPECT_EQ(offset.scope, physics::Scope::channel);
    EXPECT_EQ(offset.place, 0);
    EXPECT_EQ(offset.standard_deviation, 0.5);
    EXPECT_EQ(offset.low, -3.0);
    EXPECT_EQ(offset.high, 100.0);
}

TEST(Parameter, MayBeFreeAtAPatchALayerOrAZone) {
    const Experiment experiment = read(including("section.toml", R"(
[effects.still_air]
patches = ["inside", "beads"]
h_by_patch = { beads = "40 W/m2K" }
[[parameter]]
effect = "still_air"
key = "h"
[[parameter]]
effect = "still_air"
key = "h"
patch = "beads"
[[parameter]]
effect = "strain_energy_loss"
key = "strain_energy_share"
layer = "carcass"
[[parameter]]
effect = "strain_energy_loss"
key = "strain_energy_share"
zone = "inside_shoulder"
)"));
    ASSERT_EQ(experiment.parameters.size(), 4U);
    const mesh::Mesh& mesh = experiment.runs.front().problem.mesh;
    EXPECT_EQ(experiment.parameters[0].prior, 10.0);
    EXPECT_EQ(experiment.parameters[1].prior, 40.0);
    EXPECT_EQ(experiment.parameters[1].place, mesh.find_patch("beads"));
    EXPECT_EQ(experiment.parameters[1].name, "still_air.h at beads");
    EXPECT_EQ(experiment.parameters[2].scope, physics::Scope::layer);
    EXPECT_EQ(experiment.parameters[2].place, 1);
    EXPECT_EQ(experiment.parameters[3].place, mesh.find_zone("inside_shoulder"));
}

// k = 0.5 W/mK at all temperatures: a hundredth and a hundred times of it are the bounds, unless the case has others.
TEST(Parameter, ALawIsFreeAtItsTemperatures) {
    const Experiment experiment = read(including("section.toml", R"(
[[parameter]]
material = "rubber"
law = "conductivity"
at = ["40 degC", "90 degC", "413.15 K"]
standard_deviation = "0.1 W/mK"
low = "0.01 W/mK"
[[parameter]]
material = "rubber"
law = "heat_capacity"
at = "60 degC"
expected = "2 kJ/kgK"
)"));
    ASSERT_EQ(experiment.parameters.size(), 4U);
    for (std::size_t k = 0; k < 3; ++k) {
        const FreeParameter& number = experiment.parameters[k];
        EXPECT_EQ(number.kind, Kind::conductivity);
        EXPECT_EQ(number.layers, (std::vector<int>{0, 1}));  // tread and carcass are of one rubber
        EXPECT_EQ(number.knots, (std::vector<double>{celsius_zero + 40.0, celsius_zero + 90.0, 413.15}));
        EXPECT_EQ(number.knot, k);
        EXPECT_NEAR(number.prior, 0.5, 1e-15);
        EXPECT_EQ(number.standard_deviation, 0.1);
        EXPECT_EQ(number.low, 0.01);
        EXPECT_NEAR(number.high, 50.0, 1e-12);
    }
    EXPECT_EQ(experiment.parameters[1].name, "rubber.conductivity at 90 degC");
    EXPECT_EQ(experiment.parameters[2].name, "rubber.conductivity at 413.15 K");
    EXPECT_EQ(experiment.parameters[3].kind, Kind::heat_capacity);
    EXPECT_EQ(experiment.parameters[3].prior, 2000.0);
}

TEST(Parameter, ALinkIsFreeOnTwoNodes) {
    const Experiment experiment = read(including("tire.toml", R"(
[[parameter]]
link = "conductivity"
at = ["60 degC", "100 degC"]
expected = ["0.4 W/mK", "0.7 W/mK"]
)"));
    ASSERT_EQ(experiment.parameters.size(), 2U);
    EXPECT_EQ(experiment.parameters[1].name, "link.conductivity at 100 degC");
    EXPECT_EQ(experiment.parameters[1].kind, Kind::link_conductivity);
    EXPECT_EQ(experiment.parameters[0].prior, 0.4);
    EXPECT_EQ(experiment.parameters[1].prior, 0.7);
}

// One number for each run and word, in the order of the words; a layer takes its surface nodes along.
TEST(Parameter, InitialTemperaturesAreThoseOfEachRun) {
    const Experiment experiment = read(including("section.toml", R"(
[effects.inner_gas]
[[run]]
name = "warm-up"
measured = [{ channel = "bulk_temperature", value = "40 degC", uncertainty = "1 K" }]
[[run]]
name = "coast-down"
measured = [{ channel = "bulk_temperature", value = "40 degC", uncertainty = "1 K" }]
[[parameter]]
initial = ["tread", "gas"]
standard_deviation = "3 K"
)"));
    ASSERT_EQ(experiment.parameters.size(), 4U);
    EXPECT_EQ(experiment.parameters[0].name, "initial tread, run warm-up");
    EXPECT_EQ(experiment.parameters[1].name, "initial tread, run coast-down");
    EXPECT_EQ(experiment.parameters[2].name, "initial gas, run warm-up");
    EXPECT_EQ(experiment.parameters[1].runs, std::vector<std::size_t>{1});
    EXPECT_EQ(experiment.parameters[0].standard_deviation, 3.0);
    EXPECT_EQ(experiment.parameters[0].prior, 0.0);
    const mesh::Mesh& mesh = experiment.runs.front().problem.mesh;
    // Crown and shoulders, 4 + 2 * 2 columns, have 2 cells of tread and an outer surface each.
    EXPECT_EQ(experiment.parameters[0].nodes.size(), 8U * 3U);
    EXPECT_EQ(experiment.parameters[2].nodes, std::vector<int>{mesh.find_lumped_node("gas")});
}

TEST(Parameter, WithoutRunsThereIsOneInitialTemperature) {
    const Experiment experiment = read(including("tire.toml", "[[parameter]]\ninitial = \"temperature\"\n"));
    ASSERT_EQ(experiment.parameters.size(), 1U);
    EXPECT_TRUE(experiment.parameters[0].runs.empty());
    EXPECT_EQ(experiment.parameters[0].name, "initial temperature");
    EXPECT_EQ(experiment.parameters[0].nodes.size(), experiment.runs.front().problem.initial.size());
}

TEST(Identify, SaysHowTheNoiseIsModelled) {
    const Experiment standard = read(including("tire.toml", ""));
    EXPECT_EQ(standard.noise, "automatic");
    EXPECT_FALSE(standard.robust);
    const Experiment stated = read(including("tire.toml", "[identify]\nnoise = \"white\"\nrobust = true\n"));
    EXPECT_EQ(stated.noise, "white");
    EXPECT_TRUE(stated.robust);
}

// A number of an effect that is on may be doubted even where it has no value at which the effect is absent; of one that is
// off there is nothing to doubt.
TEST(Diagnose, MayDoubtANumberOfAnEffectThatIsOn) {
    const std::string on = including("tire.toml", "[effects.inner_gas]\nliner = \"8 W/K\"\n");
    const std::string doubt = "[diagnose]\ncandidates = [\"radiation\", \"inner_gas.capacity\"]\n";
    EXPECT_EQ(read(on + doubt).candidates, (std::vector<std::string>{"radiation", "inner_gas.capacity"}));
    const Written written;
    for (const char* wrong : {"inner_gas.nonsense", "inner_gas.capacity"}) {
        const std::string text = including("tire.toml", fmt::format("[diagnose]\ncandidates = [\"{}\"]\n", wrong));
        const ExperimentReading reading = read_experiment(written.add("case.toml", text + std::string(measured)));
        EXPECT_FALSE(reading.experiment) << wrong;
        ASSERT_EQ(reading.errors.size(), 1U) << wrong;
        EXPECT_NE(render(reading.errors.front()).find("that may be missing or have a wrong number"), std::string::npos)
            << render(reading.errors.front());
    }
}

}  // namespace tiretherm::input
