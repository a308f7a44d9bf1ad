// SPDX-License-Identifier: BSD-3-Clause
// Infrared sensors that look at the same rubber share its emissivity: one cause for all of them, and not as many as
// there are sensors, nor another one that pulls at all of them.

#include <array>
#include <fstream>
#include <random>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis.hpp"
#include "input/runs/read_experiment.hpp"
#include "input/runs/reader.hpp"
#include "post/scratch.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::diagnosis {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> zones{"outside", "left", "right", "inside"};

/// A coarse section with four infrared sensors side by side on the tread and a probe in the carcass.
std::string coarse_section() {
    std::string text = fmt::format(
        "include = [\"{}/cases/tires/thesis_225_50_R17.toml\"]\n"
        "[tire]\nsidewall_thickness = \"12 mm\"\n[mesh]\nkind = \"section\"\ncrown_cells = 2\nshoulder_cells = "
        "2\nsidewall_cells = 2\n"
        "[[mesh.layer]]\nname = \"tread\"\nthickness = \"8 mm\"\ncells = 5\nratio = 2\nmaterial = \"rubber\"\n"
        "[[mesh.layer]]\nname = \"carcass\"\nthickness = \"4 mm\"\ncells = 2\nmaterial = \"rubber\"\n"
        "[[material]]\nname = \"rubber\"\ndensity = \"1100 kg/m3\"\nheat_capacity = \"1800 J/kgK\"\n"
        "conductivity = \"0.35 W/mK\"\n"
        "[effects.still_air]\npatches = [\"sidewalls\"]\nh = \"30 W/m2K\"\n"
        "[initial]\ntemperature = \"air_temperature\"\n"
        "[[sensor]]\nname = \"bulk\"\nkind = \"point\"\nalong = \"0 mm\"\ndepth = \"10 mm\"\n"
        "standard_deviation = \"0.3 K\"\n",
        TIRETHERM_SOURCE_DIR);
    for (std::size_t i = 0; i < zones.size(); ++i) {
        const double from = -90.0 + 45.0 * static_cast<double>(i);
        text += fmt::format(
            "[[sensor]]\nname = \"{}\"\nkind = \"strip\"\nfrom = \"{} mm\"\nto = \"{} mm\"\n"
            "standard_deviation = \"0.3 K\"\n",
            zones[i], from, from + 45.0);
    }
    return text;
}

constexpr std::string_view truth =
    "[drive]\nair_temperature = \"20 degC\"\nroad_temperature = \"25 degC\"\n"
    "[[drive.schedule]]\ncolumns = [\"time [s]\", \"speed [km/h]\", \"vertical_load [N]\"]\n"
    "rows = [[0, 60, 3000], [600, 60, 3000], [620, 160, 3000], [1500, 160, 6000]]\n"
    "[time]\nend = \"1800 s\"\noutput = \"10 s\"\n"
    "[effects.camera_emissivity]\nemissivity = 0.9\nchannels = [\"outside\", \"left\", \"right\", \"inside\"]\n";

std::string log_of(const fs::path& folder) {
    const input::Reading reading = input::read_case(folder / "truth.toml", coarse_section() + std::string(truth));
    EXPECT_TRUE(reading.problem) << render(reading);
    std::mt19937_64 random(20261122);
    std::normal_distribution<double> noise(0.0, 0.3);
    std::string csv = "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC]";
    for (const solver::Channel& channel : reading.problem->channels) {
        csv += fmt::format(",{} [degC]", channel.name);
    }
    const solver::MarchReport report = solver::run(*reading.problem, [&](const solver::Snapshot& row) {
        const physics::Inputs inputs = reading.problem->input_signals.at(row.time, solver::JumpSide::after);
        csv += fmt::format("\n{},{},{},20,25", row.time, 3.6 * inputs.speed, inputs.vertical_load);
        for (const double kelvin : row.channels) {
            csv += fmt::format(",{}", kelvin - 273.15 + noise(random));
        }
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return csv;
}

}  // namespace

// Made with an emissivity of 0.9 in front of all four sensors, as for rubber behind a camera that is set to 1, and white
// noise of 0.3 K. At 60 degC and air of 20 degC that is some 3.5 K (the law's own: 333^4 - 0.1 (333^4 - 293^4) -> 329.5).
TEST(CommonEmissivity, IsOneCauseOfAllSensorsThatSeeTheSurface) {
    const sample::Scratch scratch;
    const fs::path data = scratch / "log.csv";
    std::ofstream(data) << log_of(scratch.path());
    const fs::path file = scratch / "case.toml";
    std::ofstream(file) << coarse_section() << "[[parameter]]\neffect = \"strain_energy_loss\"\nkey = \"tan_delta_a\"\n"
                        << "expected = 2.14e15\nstandard_deviation = 0.214e15\n";
    const input::ExperimentReading reading = input::read_experiment(file, {data});
    ASSERT_TRUE(reading.experiment) << (reading.errors.empty() ? "" : render(reading.errors.front()));
    const Diagnosis result = diagnose(*reading.experiment, observe(*reading.experiment),
                                      {.measure_gain = false, .finer = nullptr, .only_verdict = true});
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    ASSERT_FALSE(result.hypotheses.empty());
    std::string named;
    for (const Cause& one : result.causes) {
        named += fmt::format("{} of {} {}, {:.1f} standard deviations\n", one.id, one.channel, one.place, one.sigma);
    }
    ASSERT_EQ(result.hypotheses.front().size(), 1U) << named;
    const Cause& cause = result.causes[result.hypotheses.front().front()];
    EXPECT_EQ(cause.id, "camera_emissivity");
    EXPECT_EQ(cause.channel, "all 4 sensors of surfaces");
    // Four sensors, 180 rows, 0.3 K, a slope of 35 K: the interval is some thousandths wide.
    EXPECT_NEAR(cause.numbers.front().value, 0.9, 0.01);
    EXPECT_LT(cause.numbers.front().low, 0.9);
    EXPECT_GT(cause.numbers.front().high, 0.9);
}

}  // namespace tiretherm::diagnosis
