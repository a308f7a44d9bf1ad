// SPDX-License-Identifier: BSD-3-Clause
// A run resumed from a checkpoint ends with the same digits; a checkpoint of another problem is refused.

#include "solver/time_integration/checkpoint.hpp"

#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

namespace {

struct Row {
    double time;
    std::vector<double> temperature;
    std::vector<double> joules;
    double stored;

    friend bool operator==(const Row&, const Row&) = default;
};

Observer keep_rows(std::vector<Row>& rows, std::size_t most = 1000000) {
    return [&rows, most](const Snapshot& s) {
        rows.push_back(
            {s.time, {s.temperature.begin(), s.temperature.end()}, {s.joules.begin(), s.joules.end()}, s.stored});
        return rows.size() < most;
    };
}

/// A jump of the speed, nonlinear laws, a tolerance that makes some 200 steps.
Problem eventful() {
    Problem problem = two_node_tire();
    problem.input_signals = {};
    problem.input_signals.add({.signal = physics::find_signal("speed"),
                               .time = {0.0, 200.0, 200.0, 600.0},
                               .value = {28.0, 28.0, 40.0, 10.0}});
    hold(problem, "vertical_load", 4000.0);
    hold(problem, "air_temperature", 296.15);
    hold(problem, "road_temperature", 310.0);
    problem.settings.tolerance = 1e-5;
    problem.settings.output_interval = 3.0;
    return problem;
}

}  // namespace

TEST(Checkpoint, AResumedRunEndsWithTheSameDigits) {
    const Problem problem = eventful();
    std::vector<Row> whole;
    std::vector<Checkpoint> kept;
    std::vector<std::size_t> rows_then;
    const MarchReport report =
        run(problem, keep_rows(whole), {.from = nullptr, .every = 20, .keep = [&](const Checkpoint& c) {
                                            kept.push_back(c);
                                            rows_then.push_back(whole.size());
                                        }});
    ASSERT_TRUE(report.status.ok());
    ASSERT_GE(kept.size(), 3U);
    for (std::size_t i = 0; i < kept.size(); ++i) {
        std::vector<Row> rest;
        const MarchReport resumed =
            run(problem, keep_rows(rest), {.from = &kept[i], .every = 20, .keep = [](const Checkpoint&) {}});
        ASSERT_TRUE(resumed.status.ok()) << resumed.status.message;
        EXPECT_EQ(resumed.steps, report.steps);
        EXPECT_EQ(resumed.channel_max, report.channel_max);
        EXPECT_EQ(resumed.hottest.time, report.hottest.time);
        EXPECT_EQ(resumed.joules, report.joules);
        const std::vector<Row> expected(whole.begin() + static_cast<std::ptrdiff_t>(rows_then[i]), whole.end());
        EXPECT_EQ(rest, expected) << "checkpoint " << i;  // bit for bit
    }
}

// A checkpoint holds the factor that the next steps iterate on and whatever else they depend on: a run leaves them when the
// clock says so, and nobody can see it in its results. Exact and incomplete factors, laws, a log, a lagging sensor.
TEST(Checkpoint, LeavingOrTakingOneChangesNoDigit) {
    for (const LinearSolver solver : {LinearSolver::cholesky, LinearSolver::conjugate_gradient}) {
        for (const long every : {1L, 7L, 50L}) {
            Problem problem = eventful();
            problem.settings.linear_solver = solver;
            std::vector<Row> plain;
            const MarchReport report = run(problem, keep_rows(plain));
            ASSERT_TRUE(report.status.ok());
            std::vector<Row> whole;
            std::vector<Checkpoint> kept;
            std::vector<std::size_t> rows_then;
            const auto keep = [&](const Checkpoint& checkpoint) {
                kept.push_back(checkpoint);
                rows_then.push_back(whole.size());
            };
            (void)run(problem, keep_rows(whole), {.from = nullptr, .every = every, .keep = keep});
            EXPECT_EQ(whole, plain);  // bit for bit
            ASSERT_FALSE(kept.empty());
            for (std::size_t i = 0; i < kept.size(); i += std::max<std::size_t>(1, kept.size() / 20)) {
                std::vector<Row> rest;
                const MarchReport resumed = run(problem, keep_rows(rest), {.from = &kept[i], .every = 0, .keep = {}});
                ASSERT_TRUE(resumed.status.ok()) << resumed.status.message;
                const std::vector<Row> expected(plain.begin() + static_cast<std::ptrdiff_t>(rows_then[i]), plain.end());
                EXPECT_EQ(rest, expected) << "checkpoint " << i;
                EXPECT_EQ(resumed.steps, report.steps);
                EXPECT_EQ(resumed.newton_iterations, report.newton_iterations);
                EXPECT_EQ(resumed.linear_iterations, report.linear_iterations);
                EXPECT_EQ(resumed.factorisations, report.factorisations);
                EXPECT_EQ(resumed.energy_closure, report.energy_closure);
            }
        }
    }
}

TEST(Checkpoint, IsLeftWhenItIsDue) {
    int asked = 0;
    int left = 0;
    const MarchReport report = run(eventful(), nullptr,
                                   {.from = nullptr,
                                    .every = 1,
                                    .keep = [&](const Checkpoint&) { ++left; },
                                    .due = [&] { return ++asked % 10 == 0; }});
    EXPECT_EQ(asked, report.steps);
    EXPECT_EQ(left, report.steps / 10);
}

TEST(Checkpoint, OfAnotherProblemIsRefused) {
    Checkpoint kept;
    (void)run(eventful(), nullptr, {.from = nullptr, .every = 20, .keep = [&](const Checkpoint& c) { kept = c; }});
    const MarchReport report = run(heated_strip(7), nullptr, {.from = &kept, .every = 0, .keep = {}});
    EXPECT_EQ(report.status.outcome, Outcome::foreign_checkpoint);
    EXPECT_NE(report.status.message.find("another case"), std::string::npos);
}

/// A state of every kind of member.
struct Kinds {
    double number = 0.0;
    int whole = 0;
    bool truth = false;
    std::array<double, 2> point{};
    std::vector<double> list;
    std::vector<std::vector<double>> lists;

    friend bool operator==(const Kinds&, const Kinds&) = default;
};

Kinds some_state() {
    return {
        .number = 0.1, .whole = -7, .truth = true, .point = {1.0, 2.0}, .list = {3.0}, .lists = {{4.0}, {5.0, 6.0}}};
}

// 3 + 2 numbers of the members that are no lists, and 1, 1 and 2 of the lists.
TEST(Archive, TakesAllMembersOfAStruct) {
    Kinds state = some_state();
    std::vector<double> numbers;
    Archive writing = Archive::writing(numbers);
    writing(state);
    EXPECT_EQ(numbers.size(), 9U);
    Archive counting = Archive::counting();
    counting(state);
    EXPECT_EQ(counting.count(), 9U);
    EXPECT_EQ(state, some_state());
    Kinds read{.list = {0.0}, .lists = {{0.0}, {0.0, 0.0}}};
    Archive reading = Archive::reading(numbers);
    reading(read);
    EXPECT_TRUE(reading.complete());
    EXPECT_EQ(read, some_state());
}

// The lengths of the list, of the list of lists and of its two lists come beside the nine numbers.
TEST(Archive, OfAStateThatGrowsTheLengthsArePart) {
    Kinds state = some_state();
    std::vector<double> numbers;
    Archive writing = Archive::writing(numbers);
    writing.grown(state);
    EXPECT_EQ(numbers.size(), 13U);
    Kinds read;
    Archive reading = Archive::reading(numbers);
    reading.grown(read);
    EXPECT_TRUE(reading.complete());
    EXPECT_EQ(read, some_state());
}

// A length of 1e15 that nothing follows makes no list of that length.
TEST(Archive, OfADamagedStateIsShort) {
    const std::vector<double> numbers{1e15, 2.0};
    std::vector<double> list;
    Archive reading = Archive::reading(numbers);
    reading.grown(list);
    EXPECT_LE(list.size(), 1U);
    Archive further = Archive::reading(std::span(numbers).first(1));
    Kinds state = some_state();
    further(state);
    EXPECT_FALSE(further.complete());
}

}  // namespace tiretherm::solver
