// SPDX-License-Identifier: BSD-3-Clause
// The cases that the made-up logs belong to describe the benches that the logs come from: with the truth's numbers they
// give the truth's readings.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "hidden_effects/case_rows.hpp"
#include "input/runs/read_experiment.hpp"
#include "solver/time_integration/march.hpp"
#include "two_node/shipped_truth.hpp"

namespace hidden_effects {

namespace {

namespace input = tiretherm::input;
namespace solver = tiretherm::solver;

/// A case as it is read, or a failure.
input::Experiment experiment(const std::string& name) {
    const input::ExperimentReading reading =
        input::read_experiment(std::string(TIRETHERM_SOURCE_DIR) + "/cases/" + name + ".toml");
    for (const input::InputError& error : reading.errors) {
        ADD_FAILURE() << input::render(error);
    }
    EXPECT_TRUE(reading.warnings.empty()) << reading.warnings.front();
    EXPECT_TRUE(reading.data_warnings.empty()) << reading.data_warnings.front();
    return reading.experiment ? *reading.experiment : input::Experiment{};
}

/// Gives the parameter of this name, which must be one of the free ones, another value in the problem of a run.
void set(const input::Experiment& from, solver::Problem& problem, const std::string& name, double value) {
    const auto found = std::find_if(from.parameters.begin(), from.parameters.end(),
                                    [&](const solver::FreeParameter& number) { return number.name == name; });
    ASSERT_NE(found, from.parameters.end()) << name;
    solver::move(problem, *found, solver::value_of(problem, *found), value);
}

/// What the channels of a problem read at every sample, degC.
std::vector<std::vector<double>> readings(solver::Problem problem, double interval) {
    problem.settings.output_interval = interval;
    std::vector<std::vector<double>> channels(problem.channels.size());
    const solver::MarchReport report = solver::run(problem, [&](const solver::Snapshot& now) {
        for (std::size_t c = 0; c < channels.size(); ++c) {
            channels[c].push_back(now.channels[c] - celsius);
        }
        return true;
    });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    return channels;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b, double shift) {
    double largest = a.size() == b.size() ? 0.0 : HUGE_VAL;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i] - shift));
    }
    return largest;
}

}  // namespace

// Rest, coasting, ramps and slip: with a local error of 1e-3, 1e-4 and 1e-5 K a step the two are 7, 1.3 and 0.28 mK
// apart at most, so that only the steps tell them apart.
TEST(ShippedCases, TheBenchOfTwoNodesIsThatOfItsRuns) {
    const input::Experiment bench = experiment("practice/two_node_bench");
    ASSERT_EQ(bench.runs.size(), 3U);
    ASSERT_EQ(bench.parameters.size(), 2U + 6U);
    for (std::uint64_t run = 0; run < 3; ++run) {
        SCOPED_TRACE(run);
        solver::Problem problem = bench.runs[run].problem;
        problem.settings.tolerance = 1e-5;
        set(bench, problem, "air_convection.lambda_h", 1.1);
        set(bench, problem, "strain_energy_loss.tan_delta_a", 0.9 * 2.14e15);
        const std::vector<std::vector<double>> project = readings(problem, 4.0);
        ASSERT_EQ(project.size(), 2U);

        const Programme programme = draw_programme(101 + run, 4.0);
        const double air = programme.air_temperature.front();
        const BenchTrace truth =
            drive_bench({.lambda_h = 1.1, .lambda_sel = 0.9, .surface_start = air, .bulk_start = air}, programme);
        EXPECT_LT(largest_difference(truth.surface, project[0], celsius), 1e-3);
        EXPECT_LT(largest_difference(truth.bulk, project[1], celsius), 1e-3);
    }
}

// What the head of the case says of its grid: 0.17 and 0.10 K at 3 W; the truth adds 0.02 K.
TEST(ShippedCases, TheLasersGridIsAsGoodAsItsCaseSays) {
    const input::Experiment laser = experiment("laser/identify");
    ASSERT_EQ(laser.runs.size(), 3U);
    LaserSpecimen specimen = shipped_specimen();
    specimen.power = 3.0;
    solver::Problem problem = laser.runs[2].problem;
    const char* at[] = {"40 degC", "90 degC", "140 degC"};
    for (std::size_t i = 0; i < 3; ++i) {
        set(laser, problem, std::string("K1.conductivity at ") + at[i], specimen.K1[i]);
        set(laser, problem, std::string("K2.conductivity at ") + at[i], specimen.K2[i]);
    }
    set(laser, problem, "laser.absorptivity", specimen.absorptivity);
    set(laser, problem, "laser.radius", specimen.spot);
    set(laser, problem, "still_air.h at top", specimen.h_top);
    set(laser, problem, "still_air.h at bottom", specimen.h_bottom);
    const std::vector<std::vector<double>> project = readings(problem, 5.0);
    ASSERT_EQ(project.size(), 2U);

    const LaserTrace truth = heat_with_laser(specimen, laser.runs[2].time);
    EXPECT_LT(largest_difference(project[0], truth.spot_mean, 0.0), 0.17 + 0.02);
    EXPECT_LT(largest_difference(project[1], truth.inner_centre, 0.0), 0.10 + 0.02);
}

}  // namespace hidden_effects
