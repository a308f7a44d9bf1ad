// SPDX-License-Identifier: BSD-3-Clause
// [[source]] and [[exchange]]: what they follow, in every run from its own file, and how they are written again.
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/effects/user_signals.hpp"
#include "input/parameters/overlay.hpp"
#include "post/report/file.hpp"
#include "solver/time_integration/march.hpp"
#include "tests/input/measurements/measured_bench.hpp"

namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view throttle_heat = R"(
[[source]]
name = "throttle_heat"
follows = "throttle"
at = "surface"
watts = "500 W"
)";

std::string two_runs(std::string_view more) {
    return std::string(bench) + std::string(more) + "[[run]]\nfile = \"one.csv\"\n[[run]]\nfile = \"two.csv\"\n";
}

Experiment read_sound(const fs::path& file, const std::vector<fs::path>& data = {}) {
    ExperimentReading reading = read_experiment(file, data);
    EXPECT_TRUE(reading.errors.empty()) << error_report(reading);
    return reading.experiment.value_or(Experiment{});
}

/// Samples of `own` in a run, against the time since its start.
const physics::Curve& table_of(const solver::Problem& problem, std::string_view user_effect, std::size_t table = 0) {
    return *problem.effects.at(solver::find_user_effect(problem, user_effect)).tables.at(table);
}

double evaluate(const std::string& text, const std::vector<double>& values) {
    Formula::Wrong wrong;
    const std::optional<Formula> formula = Formula::read(text, "follows", wrong);
    EXPECT_TRUE(formula.has_value()) << wrong.error.what;
    FormulaDecisions ignored;
    return formula ? formula->evaluate(values, ignored) : std::nan("");
}

std::string error_of(const std::string& text) {
    Formula::Wrong wrong;
    return Formula::read(text, "follows", wrong) ? "" : wrong.error.what;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

double joules(const solver::Problem& problem, std::string_view user_effect) {
    const solver::MarchReport report = solver::run(problem, [](const solver::Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_LT(report.energy_closure, 1e-10);
    return report.joules.at(solver::find_user_effect(problem, user_effect));
}

}  // namespace

// Signals come in the order of the alphabet.
TEST(Formula, KnowsArithmeticFunctionsAndCases) {
    EXPECT_DOUBLE_EQ(evaluate("speed * abs(lateral_force)", {-3.0, 2.0}), 6.0);
    EXPECT_DOUBLE_EQ(evaluate("max(0, brake - 0.1)", {0.05}), 0.0);
    EXPECT_DOUBLE_EQ(evaluate("b > 2 ? b^2 : -1", {3.0}), 9.0);
    EXPECT_DOUBLE_EQ(evaluate("1.5e3", {}), 1500.0);
}

TEST(Formula, SaysWhatIsNone) {
    EXPECT_EQ(error_of(" "), "follows is empty");
    EXPECT_EQ(error_of("a = 3"), "follows assigns a value");
    EXPECT_EQ(error_of("a <= 3 && a != 2"), "");
    EXPECT_EQ(error_of("0,5"), "follows has 2 values, separated by commas");
    EXPECT_TRUE(error_of("speed * ").starts_with("follows is no formula: ")) << error_of("speed * ");
    EXPECT_TRUE(error_of("abs(speed").starts_with("follows is no formula: ")) << error_of("abs(speed");
}

// Per cent of a pedal are hundredths, each run has its own; the column stays one that the model does not use otherwise.
TEST(OwnSource, FollowsAColumnOfEveryRun) {
    const Written written;
    written.add("one.csv", log_of_five);
    written.add("two.csv",
                replaced(replaced(std::string(log_of_five), "throttle [-]", "throttle [%]"), ",0.40,", ",40,"));
    const Experiment experiment = read_sound(written.add("tire.toml", two_runs(throttle_heat)));
    ASSERT_EQ(experiment.runs.size(), 2U);
    const solver::Problem& one = experiment.runs[0].problem;
    const solver::Problem& two = experiment.runs[1].problem;
    EXPECT_EQ(solver::find_user_effect(one, "throttle_heat"), solver::find_user_effect(two, "throttle_heat"));
    EXPECT_EQ(table_of(one, "throttle_heat"), physics::Curve::table({0, 2, 5, 6, 10}, {0.10, 0.20, 0.35, 0.40, 0.15}));
    EXPECT_NEAR(table_of(two, "throttle_heat").value(0.0), 0.0010, 1e-15);
    EXPECT_NEAR(table_of(two, "throttle_heat").value(6.0), 0.40, 1e-15);
    ASSERT_EQ(experiment.runs[0].unused.size(), 1U);
    EXPECT_EQ(experiment.runs[0].unused[0].name, "throttle");
    // 500 W times the area under the straight lines: (0.3 + 0.825 + 0.375 + 1.1) s.
    EXPECT_NEAR(joules(one, "throttle_heat"), 500.0 * 2.6, 1e-8);
}

// A column is called what the case calls it, and its numbers are in base units: 20 degC is 293.15 K.
TEST(OwnExchange, MeetsATemperatureOfTheFile) {
    const Written written;
    const fs::path file = written.add("tire.toml", std::string(bench) + R"(
[[exchange]]
name = "disc"
follows = "0.1 + throttle"
at = ["bulk", "surface"]
conductance = "5 W/K"
temperature = "disc_temperature"
[data]
columns = { "T disc" = "disc_temperature", pedal = "throttle" }
)");
    const fs::path log =
        written.add("log.csv", replaced(replaced(std::string(log_of_five), "throttle [-]", "pedal [-]"),
                                        "surface_temperature [degC],", "T disc [degC],"));
    const Experiment experiment = read_sound(file, {log});
    ASSERT_EQ(experiment.runs.size(), 1U);
    const solver::Problem& problem = experiment.runs[0].problem;
    EXPECT_NEAR(table_of(problem, "disc").value(5.0), 0.45, 1e-15);
    EXPECT_NEAR(table_of(problem, "disc", 1).value(2.0), 273.15 + 25.5, 1e-10);
    const physics::ActiveEffect& active = problem.effects.at(solver::find_user_effect(problem, "disc"));
    EXPECT_EQ(active.nodes, (std::vector<int>{1, 0}));
    EXPECT_DOUBLE_EQ(active[0], 5.0);
    EXPECT_EQ(active.title(), "disc");
}

// A logger's names are what they are: one that is no word, or reads as a difference, is a column all the same.
TEST(OwnSource, FollowsAColumnOfAnyName) {
    for (const std::string name : {"T brake", "wheel-speed", "a/b (raw)"}) {
        const Written written;
        const std::string log = replaced(std::string(log_of_five), "throttle [-]", name + " [%]");
        written.add("one.csv", log);
        written.add("two.csv", log);
        const std::string more =
            replaced(std::string(throttle_heat), "follows = \"throttle\"", fmt::format("follows = \"{}\"", name));
        const Experiment experiment = read_sound(written.add("tire.toml", two_runs(more)));
        ASSERT_EQ(experiment.runs.size(), 2U) << name;
        EXPECT_NEAR(table_of(experiment.runs[1].problem, "throttle_heat").value(6.0), 0.0040, 1e-15);
        EXPECT_NEAR(signal_history_of(name, experiment.runs[1]).value.at(3), 0.0040, 1e-15);
    }
}

// Without any log: the speed rises from 0 to 36 km/h in 60 s and the heat as its square; 10 W at 10 m/s make 10 W 60 s/3.
// The straight lines are within 1e-4 of the largest value, on the upper side.
TEST(OwnSource, FollowsASchedule) {
    const Written written;
    const Reading reading = read_case(written.add("tire.toml", std::string(bench) + R"(
[drive]
vertical_load = "4000 N"
air_temperature = "23 degC"
road_temperature = "23 degC"
[[drive.schedule]]
columns = ["time [s]", "speed [km/h]"]
rows = [[0, 0], [60, 36]]
[time]
end = "60 s"
[[source]]
name = "drag"
follows = "speed^2 / 100"
at = "bulk"
watts = "10 W"
[[source]]
name = "lamp"
follows = "time < 30"
at = "surface"
watts = "-2 W"
[[exchange]]
name = "box"
at = "bulk"
conductance = "1 W/K"
temperature = "23 degC"
)"));
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    EXPECT_NEAR(joules(*reading.problem, "drag"), 200.0, 0.06);
    EXPECT_NEAR(joules(*reading.problem, "lamp"), -60.0, 0.06);
    EXPECT_NEAR(table_of(*reading.problem, "box", 1).value(3.0), 296.15, 1e-12);
}

// At a jump of the speed the source jumps too.
TEST(OwnSource, JumpsWithItsSchedule) {
    const Written written;
    const Reading reading = read_case(written.add("tire.toml", std::string(bench) + R"(
[drive]
vertical_load = "4000 N"
air_temperature = "23 degC"
road_temperature = "23 degC"
[[drive.schedule]]
columns = ["time [s]", "speed [m/s]"]
rows = [[0, 10], [20, 10], [20, 30], [60, 30]]
[time]
end = "60 s"
[[source]]
name = "drag"
follows = "speed"
at = "bulk"
watts = "1 W"
)"));
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    // 200 J before and 1200 J after; the jump by 20 takes a millisecond.
    EXPECT_NEAR(joules(*reading.problem, "drag"), 1400.0 - 20.0 * 0.5e-3, 1e-7);
}

// A log of [drive] has columns that are no inputs.
TEST(OwnSource, FollowsAColumnOfALogOfTheDrive) {
    const Written written;
    written.add("log.csv", log_of_five);
    const Reading reading = read_case(written.add("tire.toml", std::string(bench) + std::string(throttle_heat) + R"(
[[drive.file]]
path = "log.csv"
)"));
    ASSERT_TRUE(reading.problem.has_value()) << render(reading);
    EXPECT_EQ(table_of(*reading.problem, "throttle_heat"),
              physics::Curve::table({0, 2, 5, 6, 10}, {0.10, 0.20, 0.35, 0.40, 0.15}));
}

TEST(UserEffects, HaveANumberThatIsFree) {
    const Written written;
    written.add("one.csv", log_of_five);
    written.add("two.csv", log_of_five);
    const Experiment experiment = read_sound(written.add("tire.toml", two_runs(std::string(throttle_heat) + R"(
[[exchange]]
name = "wall"
at = "bulk"
conductance = "3 W/K"
[[parameter]]
source = "throttle_heat"
key = "watts"
expected = "450 W"
standard_deviation = "50 W"
[[parameter]]
effect = "wall"
)")));
    ASSERT_EQ(experiment.parameters.size(), 2U);
    const solver::FreeParameter& heat = experiment.parameters[0];
    const solver::FreeParameter& wall = experiment.parameters[1];
    EXPECT_EQ(heat.name, "throttle_heat.watts");
    EXPECT_EQ(heat.prior, 450.0);
    EXPECT_EQ(wall.name, "wall.conductance");
    EXPECT_EQ(wall.low, 0.0);
    for (const MeasuredRun& run : experiment.runs) {
        EXPECT_EQ(solver::value_of(run.problem, heat), 500.0);
        EXPECT_EQ(solver::value_of(run.problem, wall), 3.0);
    }
}

// What a diagnosis adds to a run's problem is what reading the same table gives, to the last digit.
TEST(OwnSource, IsTheSameWhetherReadOrAdded) {
    const Written written;
    std::string log =
        "time [s],speed [km/h],vertical_load [N],air_temperature [degC],road_temperature [degC],throttle [%],"
        "bulk_temperature [degC]\n";
    for (int i = 0; i <= 20; ++i) {  // a sample of the pedal is missing
        log += fmt::format("{},{},4000,25,30,{},{}\n", 100 + 2 * i, 80 + i % 7,
                           i == 9 ? "" : fmt::format("{}", 7 * i % 40), 25.0 + 0.1 * i);
    }
    written.add("one.csv", log);
    written.add("two.csv", log_of_five);
    const std::string more = R"toml(
[[source]]
name = "heat"
follows = "throttle * speed / max(bulk_temperature, 1)"
at = "bulk"
watts = "8 W"
)toml";
    const Experiment read = read_sound(written.add("with.toml", two_runs(more)));
    Experiment added = read_sound(written.add("without.toml", two_runs("")));
    ASSERT_EQ(added.runs.size(), 2U);
    for (std::size_t r = 0; r < 2; ++r) {
        solver::Problem& problem = added.runs[r].problem;
        const std::string follows = "throttle * speed / max(bulk_temperature, 1)";
        solver::add_user_effect(problem, {.name = "heat",
                                          .follows = follows,
                                          .places = {"bulk"},
                                          .signal = signal_history_of(follows, added.runs[r]),
                                          .amount = 8.0});
        EXPECT_EQ(table_of(problem, "heat"), table_of(read.runs[r].problem, "heat"));
        EXPECT_EQ(problem.effects.back().nodes, read.runs[r].problem.effects.back().nodes);
        EXPECT_EQ(problem.input_signals.samples(), read.runs[r].problem.input_signals.samples());
    }
    EXPECT_THROW(static_cast<void>(signal_history_of("throttel", added.runs[0])), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(signal_history_of("throttle *", added.runs[0])), std::invalid_argument);
}

// A fit moved one that the case has; another two were added to its runs. What is written reads as the same problem.
TEST(UserEffects, AreWrittenAndReadAgain) {
    const Written written;
    written.add("mine/one.csv", log_of_five);
    written.add("mine/two.csv", replaced(std::string(log_of_five), "0.40", "0.75"));
    const fs::path file = written.add("mine/tire.toml", two_runs(std::string(throttle_heat) + R"(
[[parameter]]
source = "throttle_heat"
)"));
    const Experiment before = read_sound(file);
    ASSERT_EQ(before.runs.size(), 2U);
    Experiment fitted = before;
    Overlay what{.original = file,
                 .before = &before.runs.front().problem,
                 .fitted = &fitted.runs.front().problem,
                 .parameters = before.parameters,
                 .runs = {}};
    for (MeasuredRun& run : fitted.runs) {
        solver::Problem& problem = run.problem;
        solver::move(problem, before.parameters[0], 500.0, 1000.0 / 3.0);
        solver::UserEffect found{.name = "speed heat",
                                 .follows = "throttle * speed",
                                 .places = {"surface", "bulk"},
                                 .signal = signal_history_of("throttle * speed", run),
                                 .amount = 1.0};
        solver::UserEffect wall{.name = "wall",
                                .follows = "1",
                                .places = {"bulk"},
                                .exchange = true,
                                .signal = signal_history_of("1", run),
                                .amount = 0.0,
                                .temperature = "road_temperature",
                                .surroundings = signal_history_of("road_temperature", run)};
        problem.effects[solver::add_user_effect(problem, found)].parameters.front() = -1.0 / 7.0;
        problem.effects[solver::add_user_effect(problem, wall)].parameters.front() = 2.0 / 3.0;
        if (what.user_effects.empty()) {
            what.user_effects = {found, wall};
        }
        what.runs.push_back({.name = run.name, .problem = &problem});
    }
    fs::create_directories(written.folder() / "out");
    const fs::path extended = written.folder() / "out/extended.toml";
    post::replace_file(extended, overlay_text(what, extended.parent_path()));
    SCOPED_TRACE(text_of(extended));
    const Experiment again = read_sound(extended);
    ASSERT_EQ(again.runs.size(), 2U);
    for (std::size_t r = 0; r < 2; ++r) {
        const solver::Problem& is = again.runs[r].problem;
        const solver::Problem& was = fitted.runs[r].problem;
        ASSERT_EQ(is.effects.size(), was.effects.size());
        for (std::size_t e = 0; e < is.effects.size(); ++e) {
            EXPECT_EQ(is.effects[e].name, was.effects[e].name);
            EXPECT_EQ(is.effects[e].effect, was.effects[e].effect);
            EXPECT_EQ(is.effects[e].parameters, was.effects[e].parameters) << was.effects[e].title();
            EXPECT_EQ(is.effects[e].nodes, was.effects[e].nodes) << was.effects[e].title();
            EXPECT_EQ(is.effects[e].tables, was.effects[e].tables) << was.effects[e].title();
        }
        EXPECT_EQ(is.input_signals.samples(), was.input_signals.samples());
    }
    // And once more: a fit of the extended case moves what now stands in it.
    Experiment later = again;
    solver::Problem& problem = later.runs.front().problem;
    solver::FreeParameter wall{.name = "wall.conductance",
                               .unit = "W K-1",
                               .effect = solver::find_user_effect(problem, "wall"),
                               .layers = {},
                               .knots = {},
                               .nodes = {},
                               .runs = {}};
    solver::move(problem, wall, 2.0 / 3.0, 4.5);
    const std::vector<solver::FreeParameter> moved{wall};
    const fs::path twice = written.folder() / "out/twice.toml";
    post::replace_file(twice, overlay_text({.original = extended,
                                            .before = &again.runs.front().problem,
                                            .fitted = &problem,
                                            .parameters = moved,
                                            .runs = {}},
                                           twice.parent_path()));
    EXPECT_NE(text_of(twice).find("[[exchange]]\nname = \"wall\"\nconductance = \"4.5 W K-1\"\n"), std::string::npos)
        << text_of(twice);
    const Experiment last = read_sound(twice);
    ASSERT_EQ(last.runs.size(), 2U);
    EXPECT_EQ(last.runs[1].problem.effects.back().parameters, std::vector{4.5});
    EXPECT_EQ(last.runs[1].problem.effects.back().tables, again.runs[1].problem.effects.back().tables);
}

TEST(UserEffects, CannotBeWrittenWhenNobodySaysWhatTheyFollow) {
    const Written written;
    written.add("one.csv", log_of_five);
    written.add("two.csv", log_of_five);
    const fs::path file = written.add("tire.toml", two_runs(""));
    const Experiment before = read_sound(file);
    solver::Problem problem = before.runs.front().problem;
    solver::add_user_effect(
        problem, {.name = "heat", .follows = "1", .places = {"bulk"}, .signal = {{0.0}, {1.0}}, .amount = 1.0});
    const Overlay what{
        .original = file, .before = &before.runs.front().problem, .fitted = &problem, .parameters = {}, .runs = {}};
    EXPECT_THROW(static_cast<void>(overlay_text(what, written.folder())), std::invalid_argument);
}

}  // namespace tiretherm::input
