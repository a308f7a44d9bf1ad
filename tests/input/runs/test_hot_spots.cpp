// SPDX-License-Identifier: BSD-3-Clause
// [[critical]] and [[uncertain]]: what a case says of its hot spots, and the test that goes on after its last step.
#include "input/runs/hot_spots.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "input/runs/continued_schedule.hpp"
#include "support/warming_lump.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

using support::critical;
using support::three_steps;
using support::warming_plate;

HotSpotCase read(const Written& written, const std::string& text) {
    const std::filesystem::path file = written.add("case.toml", text);
    const Reading reading = read_case(file);
    EXPECT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    std::optional<HotSpotCase> found = HotSpotCase::read(file);
    EXPECT_TRUE(found.has_value());
    return found ? std::move(*found) : HotSpotCase{};
}

std::vector<solver::ScheduleStep> steps_of(const solver::Problem& problem) {
    return solver::schedule_steps(problem.input_signals, problem.settings.start, problem.settings.end);
}

ContinuedSchedule go_on(const std::string& text) {
    const Written written;
    const HotSpotCase found = read(written, text);
    const solver::Problem problem = *found.problem_of(found.document());
    return continue_schedule(found, problem.settings, steps_of(problem));
}

/// The plate with other inputs.
std::string driven(const std::string& drive) { return warming_plate + critical("75 degC") + drive; }

std::string with_rows(const std::string& rows, const std::string& end) {
    return driven(
        "[drive]\nair_temperature = \"20 degC\"\n[[drive.schedule]]\ncolumns = [\"time [min]\", \"speed "
        "[m/s]\"]\nrows = " +
        rows + "\n[time]\nend = \"" + end + "\"\n");
}

}  // namespace

TEST(Critical, MeansThePartWhereLayersAndZonesMeet) {
    const Written written;
    const HotSpotCase found =
        read(written, "include = [\"" + (source_folder() / "cases/section/4000N_100kmh.toml").string() + R"("]
[[critical]]
name = "belt edge"
temperature = "383.15 K"
layers = ["belt"]
zones = ["outside_shoulder", "inside_shoulder"]
surface = "surface_temperature"
[[critical]]
name = "tread rubber"
temperature = "120 degC"
materials = ["tread rubber"]
[[critical]]
name = "tire"
temperature = "110 degC"
)");
    ASSERT_EQ(found.critical.size(), 3U);
    const solver::Problem problem = *found.problem_of(found.document());
    const mesh::Mesh& mesh = problem.mesh;
    EXPECT_DOUBLE_EQ(found.critical[0].temperature, 383.15);
    EXPECT_EQ(found.critical[0].part, "belt in outside_shoulder and inside_shoulder");
    // Two shoulders of 10 columns with 5 cells of belt, which reaches no surface.
    EXPECT_EQ(found.critical[0].nodes.size(), 2U * 10U * 5U);
    for (const int node : found.critical[0].nodes) {
        EXPECT_EQ(mesh.layers[static_cast<std::size_t>(mesh.layer[static_cast<std::size_t>(node)])], "belt");
    }
    EXPECT_EQ(problem.channels[static_cast<std::size_t>(found.critical[0].channel)].name, "surface_temperature");
    // The tread's layer and the sidewall's are one material; without a word it is the tire without gas and rim.
    std::set<std::string> layers;
    for (const int node : found.critical[1].nodes) {
        layers.insert(mesh.layers[static_cast<std::size_t>(mesh.layer[static_cast<std::size_t>(node)])]);
    }
    EXPECT_EQ(layers, (std::set<std::string>{"tread", "sidewall"}));
    EXPECT_EQ(found.critical[2].nodes.size(), static_cast<std::size_t>(mesh.n_nodes) - mesh.lumped_nodes.size());
    EXPECT_EQ(found.critical[2].surface_name, "surface");
}

TEST(Critical, IsAskedForByNoOtherCase) {
    EXPECT_FALSE(HotSpotCase::read(source_folder() / "cases/section/4000N_100kmh.toml").has_value());
}

// 35 degC with 2 K: the case one deviation below has 33 degC, all else as it was.
TEST(Uncertain, MovesTheCaseByItsDeviation) {
    const Written written;
    const HotSpotCase found = read(written, warming_plate + critical("75 degC") + three_steps + R"([[uncertain]]
key = "drive.air_temperature"
standard_deviation = "2 K"
[[uncertain]]
key = "material.metal.density"
standard_deviation = "0.05 g/cm3"
)");
    ASSERT_EQ(found.uncertain.size(), 2U);
    EXPECT_DOUBLE_EQ(found.uncertain[0].standard_deviation, 2.0);
    EXPECT_EQ(found.uncertain[0].unit, "degC");
    EXPECT_NEAR(found.uncertain[1].standard_deviation, 50.0, 1e-9);
    const auto cold = found.moved(found.uncertain[0], -1.0);
    ASSERT_TRUE(cold.has_value());
    EXPECT_NEAR(cold->input_signals.at(0.0, solver::JumpSide::after).air_temperature, 273.15 + 18.0, 1e-9);
    const auto dense = found.moved(found.uncertain[1], 1.0);
    ASSERT_TRUE(dense.has_value());
    EXPECT_NEAR(dense->materials[0].density, 1050.0, 1e-9);
    EXPECT_NEAR(dense->input_signals.at(0.0, solver::JumpSide::after).air_temperature, 293.15, 1e-9);
    // A number that the case cannot have: minus nothing is left of the density 30 deviations below.
    EXPECT_FALSE(found.moved(found.uncertain[1], -30.0).has_value());
}

// A value that moves does not make the log be read again: it may be gone. 20 m/s hold from 0 to 600 s, 30 m/s at the end.
TEST(Uncertain, FilesOfTheCaseAreReadOnce) {
    const Written written;
    const std::filesystem::path log = written.add("log.csv", "time [s],speed [m/s]\n0,20\n600,20\n1200,30\n");
    const HotSpotCase found = read(written, driven(R"(
[drive]
air_temperature = "20 degC"
[[drive.file]]
path = "log.csv"
[time]
end = "20 min"
[[uncertain]]
key = "drive.air_temperature"
standard_deviation = "2 K"
)"));
    std::filesystem::remove(log);
    const auto warm = found.moved(found.uncertain.at(0), 1.0);
    ASSERT_TRUE(warm.has_value());
    EXPECT_NEAR(warm->input_signals.at(900.0, solver::JumpSide::after).air_temperature, 273.15 + 22.0, 1e-9);
    EXPECT_NEAR(warm->input_signals.at(900.0, solver::JumpSide::after).speed, 25.0, 1e-12);
    EXPECT_FALSE(HotSpotCase::read(written.folder() / "case.toml")->moved(found.uncertain[0], 1.0).has_value());
}

// 75 degC lies above 2 * 24 + 20 = 68 degC, where the last step settles; the closed form goes on by 2 m/s every 10 min and
// passes at 32 m/s, which settles at 84 degC: 9 mK/s. A source's formula is right to 1e-4 of its largest value, here of
// the 164 K at 82 m/s: 16 mK or 1.8 s.
TEST(ContinuedSchedule, PassesWhenTheClosedFormDoes) {
    const Written written;
    const HotSpotCase found = read(written, driven(three_steps));
    const solver::Problem problem = *found.problem_of(found.document());
    const ContinuedSchedule further = continue_schedule(found, problem.settings, steps_of(problem));
    ASSERT_TRUE(further.problem.has_value()) << further.refusal;
    EXPECT_NEAR(further.rise, 2.0, 1e-12);
    EXPECT_NEAR(further.duration, 600.0, 1e-9);
    EXPECT_EQ(further.steps, 29);  // 24 + 2 * 29 = 82 m/s, the next is above 83.3 m/s
    solver::HotSpotHistory history(further.problem->mesh, found.critical[0]);
    const solver::MarchReport report = solver::run(*further.problem, [&](const solver::Snapshot& now) {
        history.take(now);
        return now.time < 7200.0;
    });
    const double expected = support::WarmingLump{}.passing(75.0, 30);
    EXPECT_GT(expected, 1800.0);
    EXPECT_NEAR(solver::passing_time(history.time(), history.temperature(), history.critical().temperature), expected,
                1.8);
}

// The last step of a regulation is often prolonged: further ones are as long as the last but one.
TEST(ContinuedSchedule, TakesTheLengthOfTheLastStepButOne) {
    const ContinuedSchedule further =
        go_on(with_rows("[[0, 0], [10, 20], [10, 20], [20, 20], [20, 25], [45, 25]]", "45 min"));
    ASSERT_TRUE(further.problem.has_value()) << further.refusal;
    EXPECT_NEAR(further.duration, 600.0, 1e-9);
    EXPECT_NEAR(further.rise, 5.0, 1e-12);
    const std::vector<solver::ScheduleStep> steps = steps_of(*further.problem);
    EXPECT_TRUE(steps[0].ramp);
    EXPECT_DOUBLE_EQ(steps[2].to, 2700.0);
    EXPECT_DOUBLE_EQ(steps[3].to, 3300.0);
    EXPECT_DOUBLE_EQ(steps[3].speed, 30.0);
    EXPECT_DOUBLE_EQ(further.problem->settings.end, 2700.0 + 600.0 * further.steps);
}

TEST(ContinuedSchedule, SaysWhyItCannotGoOn) {
    const auto refusal = [](const std::string& text) {
        const ContinuedSchedule further = go_on(text);
        EXPECT_FALSE(further.problem.has_value());
        return further.refusal;
    };
    EXPECT_EQ(refusal(driven("[drive]\nair_temperature = \"20 degC\"\nspeed = \"20 m/s\"\n[time]\nend = \"30 min\"\n")),
              "the test has no steps of speed that could go on");
    EXPECT_EQ(refusal(with_rows("[[0, 25], [10, 25], [10, 20], [20, 20]]", "20 min")),
              "the speed does not rise from the last step but one to the last");
    EXPECT_EQ(refusal(with_rows("[[0, 20], [10, 20], [10, 25], [20, 25], [30, 35]]", "30 min")),
              "the test has no steps of speed that could go on");
    EXPECT_EQ(refusal(with_rows("[[0, 20], [10, 20], [10, 25], [30, 25]]", "20 min")),
              "the run does not end where its schedule does");
    EXPECT_EQ(refusal(with_rows("[[0, 20], [10, 20], [10, 80], [20, 80]]", "20 min")),
              "a further step would be faster than 300 km/h");
}

}  // namespace tiretherm::input
