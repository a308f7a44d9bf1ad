// SPDX-License-Identifier: BSD-3-Clause
// The truth of the laser's bench: that it converges, that it is the bench of cases/practice/laser_bench.md where nothing is
// hidden, and that a cause changes it as the program's effect changes the program. It shares no source file with it
// (house.hidden_effects_border).
#include <stdexcept>

#include "hidden_effects/section_bench_case.hpp"
#include "laser/laser_logs_truth.hpp"

namespace hidden_effects {

namespace {

/// Ten minutes with steps of the power.
LaserProgramme ten_minutes() {
    LaserProgramme programme = draw_laser_programme(501);
    for (std::vector<double>* signal : {&programme.time, &programme.power, &programme.lamp}) {
        signal->resize(121);
    }
    return programme;
}

/// The bench's logs with readings of no meaning, which a run of the program does not look at.
std::vector<Column> log_of(const LaserProgramme& programme) {
    LaserBenchTrace blank;
    for (std::vector<double>& channel : blank.channel) {
        channel.assign(programme.time.size(), 25.0);
    }
    return laser_columns(programme, blank);
}

/// What the program makes of the bench, degC.
std::vector<std::vector<double>> run_bench(const std::string& added, const LaserProgramme& programme) {
    std::vector<std::vector<double>> found =
        readings_of(practice_problem("laser_bench", added, log_of(programme)), 5.0, 2e-3);
    for (std::vector<double>& channel : found) {
        for (double& T : channel) {
            T -= celsius;
        }
    }
    return found;
}

constexpr const char* four_times_finer = R"(
[mesh]
kind = "axisymmetric"
radius = [
    { to = "5.6419 mm", cells = 48, ratio = 0.1 },
    { to = "15 mm", cells = 48, ratio = 15 },
    { to = "60 mm", cells = 32, ratio = 4 },
]
[[mesh.layer]]
name = "tread"
thickness = "8 mm"
cells = 40
ratio = 8
material = "K1"
[[mesh.layer]]
name = "bulk"
thickness = "4 mm"
cells = 15
material = "K2"
)";

}  // namespace

// Four times the elements, and steps of a hundredth of the local error.
TEST(LaserBenchTruth, IsConvergedToAFiftiethOfAKelvin) {
    LaserProgramme programme = ten_minutes();
    const LaserBenchTrace coarse = drive_laser({}, programme);
    const LaserBenchTrace tight = drive_laser({}, programme, {.refinement = 1, .tolerance = 1e-5});
    const LaserBenchTrace fine = drive_laser({}, programme, {.refinement = 2, .tolerance = 1e-2});
    for (std::size_t c = 0; c < laser_channels.size(); ++c) {
        SCOPED_TRACE(laser_channels[c]);
        EXPECT_LT(largest_difference(coarse.channel[c], tight.channel[c]), 1e-3);
        EXPECT_LT(largest_difference(coarse.channel[c], fine.channel[c]), 0.02);
    }
}

// What the page says is what the program computes. The flux jumps at the edge of the spot, which the case's grid makes 0.3 K
// of at rises of 70 K; four times finer and finer still at the edge it is 0.03 K (the page's table), and the truth is
// good to 0.02 K: 0.05 K, twice that where the power has just been stepped.
TEST(LaserBenchTruth, ThePageIsTheCase) {
    const LaserProgramme programme = ten_minutes();
    const LaserBenchTrace truth = drive_laser({.start = programme.air}, programme);
    const std::vector<std::vector<double>> project = run_bench(four_times_finer, programme);
    ASSERT_EQ(project.size(), laser_channels.size());
    for (std::size_t c = 0; c < project.size(); ++c) {
        SCOPED_TRACE(laser_channels[c]);
        EXPECT_GT(truth.channel[c].back() - programme.air, 2.0);
        EXPECT_LT(largest_difference(project[c], truth.channel[c]), 0.1);
    }
}

// Light that nobody absorbs does nothing.
TEST(LaserBenchTruth, WithoutLightNothingHappens) {
    const LaserProgramme programme = ten_minutes();
    const LaserBenchTrace dark = drive_laser({.absorptivity = 0.0, .start = programme.air}, programme);
    for (const std::vector<double>& channel : dark.channel) {
        EXPECT_LT(largest_difference(channel, std::vector<double>(channel.size(), programme.air)), 1e-9);
    }
}

struct Example {
    Cause cause;
    std::string text;  ///< in the case
};

std::vector<Example> laser_examples() {
    return {
        {{"laser_absorptivity", {{"factor", 0.9}}}, "[effects.laser_absorptivity]\nfactor = 0.9\n"},
        {{"laser_absorptivity", {{"fall", 1.0}}}, "[effects.laser_absorptivity]\nfactor = 1\nfall = \"1 1/h\"\n"},
        {{"laser_spot_size", {{"scale", 1.15}}}, "[effects.laser_spot_size]\nscale = 1.15\n"},
        {{"layer_conductivity", {{"scale", 1.5}}, "bulk"}, "[effects.layer_conductivity]\nscale = 1.5\n"},
        {{"layer_conductivity", {{"slope", 0.04}}, "bulk"}, "[effects.layer_conductivity]\nslope = \"0.04 1/K\"\n"},
        {{"layer_conductivity", {{"scale", 1.1}}, "tread"},
         "[effects.layer_conductivity]\nscale = 1.1\nlayers = [\"tread\"]\n"},
        {{"layer_conductivity", {{"slope", 0.005}}, "tread"},
         "[effects.layer_conductivity]\nslope = \"0.005 1/K\"\nlayers = [\"tread\"]\n"},
        {{"layer_heat_capacity", {{"scale", 1.5}}, "bulk"}, "[effects.layer_heat_capacity]\nscale = 1.5\n"},
        {{"layer_heat_capacity", {{"scale", 1.2}}, "tread"},
         "[effects.layer_heat_capacity]\nscale = 1.2\nlayers = [\"tread\"]\n"},
        {{"radiation", {{"emissivity", 0.95}}}, "[effects.radiation]\nemissivity = 0.95\n"},
        {{"natural_convection", {{"scale", 1.0}}}, "[effects.natural_convection]\nscale = 1\n"},
        {{"camera_emissivity", {{"emissivity", 0.9}}, "spot_mean_temperature"},
         "[effects.camera_emissivity]\nemissivity = 0.9\nchannels = [\"spot_mean_temperature\"]\n"},
        {{"sensor_lag", {{"tau", 10.0}}, "spot_mean_temperature"},
         "[effects.sensor_lag]\ntau = \"10 s\"\nchannels = [\"spot_mean_temperature\"]\n"},
        {{"sensor_offset", {{"kelvin", 2.0}}, "spot_centre_temperature"},
         "[effects.sensor_offset]\nkelvin = \"2 K\"\nchannels = [\"spot_centre_temperature\"]\n"},
        {{"sensor_gain", {{"excess", 0.1}}, "spot_mean_temperature"},
         "[effects.sensor_gain]\nexcess = 0.1\nchannels = [\"spot_mean_temperature\"]\n"},
    };
}

// What a cause changes is the same in both on the case's own grid, to 2 % of its largest change and 0.02 K, the truth's own
// error: another place, sign or factor would be off by tens of per cent, the grid by the 0.4 % that it is off at all.
// The spot's edge is one of the grid's only where the radius is the stated one: 4 % for laser_spot_size.
TEST(LaserBenchTruth, ACauseChangesBothAlike) {
    const LaserProgramme programme = ten_minutes();
    const LaserBench plain{.start = programme.air};
    const LaserBenchTrace truth = drive_laser(plain, programme);
    const std::vector<std::vector<double>> project = run_bench("", programme);
    for (const Example& example : laser_examples()) {
        SCOPED_TRACE(example.text);
        LaserBench bench = plain;
        bench.causes = {example.cause};
        const LaserBenchTrace caused = drive_laser(bench, programme);
        const std::vector<std::vector<double>> effect = run_bench(example.text, programme);
        double size = 0.0;
        double apart = 0.0;
        for (std::size_t c = 0; c < laser_channels.size(); ++c) {
            size = std::max(size, largest_difference(caused.channel[c], truth.channel[c]));
            for (std::size_t i = 0; i < programme.time.size(); ++i) {
                const double by_truth = caused.channel[c][i] - truth.channel[c][i];
                apart = std::max(apart, std::abs(effect[c][i] - project[c][i] - by_truth));
            }
        }
        EXPECT_GT(size, 0.5);
        EXPECT_LT(apart, (example.cause.id == "laser_spot_size" ? 0.04 : 0.02) * size + 0.02) << "of " << size;
    }
}

// A lamp on the inner face warms the probe there, and the spot by less.
TEST(LaserBenchTruth, WhatIsInNoCatalogueShowsWhereItIs) {
    const LaserProgramme programme = ten_minutes();
    const LaserBenchTrace truth = drive_laser({.start = programme.air}, programme);
    for (const char* id : {"unknown_lamp", "unknown_hours"}) {
        const LaserBenchTrace heated =
            drive_laser({.start = programme.air, .causes = {{id, {{"watts", 2.0}}}}}, programme);
        EXPECT_GT(heated.channel[2].back() - truth.channel[2].back(), 0.3);
        EXPECT_LT(heated.channel[0].back() - truth.channel[0].back(),
                  0.8 * (heated.channel[2].back() - truth.channel[2].back()));
    }
    EXPECT_THROW((void)drive_laser({.causes = {{"laser_absorptivity", {{"depth", 1.0}}}}}, programme),
                 std::invalid_argument);
}

}  // namespace hidden_effects
