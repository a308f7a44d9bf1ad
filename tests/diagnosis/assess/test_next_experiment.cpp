// SPDX-License-Identifier: BSD-3-Clause
// Which manoeuvre is proposed: always one of those that are possible, also where nothing was found.

#include <algorithm>

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

input::Experiment bench_with(const std::vector<std::string>& candidates) {
    input::Experiment experiment = sample::practice_bench();
    experiment.candidates = candidates;
    return experiment;
}

/// Speed and load at some times, s.
input::Manoeuvre manoeuvre(const std::string& name, const std::vector<double>& time, const std::vector<double>& speed,
                           double load) {
    input::Manoeuvre one{.name = name, .inputs = {}, .start = time.front(), .end = time.back()};
    one.inputs.add(solver::Series{.signal = physics::find_signal("speed"), .time = time, .value = speed});
    one.inputs.add(*physics::find_signal("vertical_load"), load);
    return one;
}

Diagnosis next_of_bench(const input::Experiment& experiment) {
    const Observations observations = observe(experiment);
    DiagnosisState state;
    state.score_data = prepare_score_tests(experiment, observations, candidates_of(experiment, experiment.candidates));
    Diagnosis result;
    plan_next(state, result);
    return result;
}

}  // namespace

// Of a tire that stands cold and one that is driven warm the latter tells a sensor's gain from a loss that falls with the temperature:
// both grow with the temperature that it has over the air. More data never bring two explanations closer together.
TEST(NextExperiment, IsTheManoeuvreThatTellsTheLargestCausesApartWhereNothingWasFound) {
    input::Experiment experiment = bench_with({"sensor_gain", "loss_tangent_slope"});
    experiment.possible = {manoeuvre("stands", {0.0, 1200.0}, {0.0, 0.0}, 0.0),
                           manoeuvre("drives", {0.0, 600.0, 605.0, 1200.0}, {40.0, 40.0, 10.0, 10.0}, 6000.0)};
    const Diagnosis result = next_of_bench(experiment);
    ASSERT_EQ(result.next.size(), 2u);
    EXPECT_EQ(result.next.front().name, "drives");
    EXPECT_GT(result.next.front().then, result.next.back().then);
    for (const NextExperiment& next : result.next) {
        EXPECT_GE(next.then, next.now * (1.0 - 1e-9)) << next.name;
    }
    ASSERT_EQ(result.told_apart.size(), 2u);
    EXPECT_NE(result.told_apart.front(), result.told_apart.back());
}

// With one cause alone there is nothing to tell apart.
TEST(NextExperiment, NeedsTwoExplanations) {
    const Diagnosis result = next_of_bench(bench_with({"sidewall_convection"}));
    EXPECT_TRUE(result.next.empty());
    EXPECT_TRUE(result.told_apart.empty());
}

// Half of the largest load of the runs, as a share and in newtons: the same manoeuvre.
TEST(NextExperiment, AShareIsThatOfTheLargestOfTheRuns) {
    input::Experiment experiment = bench_with({"sensor_gain", "loss_tangent_slope"});
    double most = 0.0;
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const double t : run.time) {
            most = std::max(most, run.problem.input_signals.at(t, solver::JumpSide::after).vertical_load);
        }
    }
    const std::vector<double> time{0.0, 600.0};
    experiment.possible = {manoeuvre("in newtons", time, {30.0, 30.0}, 0.5 * most),
                           manoeuvre("in shares", time, {30.0, 30.0}, 0.5)};
    experiment.possible.back().of_largest = {"vertical_load"};
    const Diagnosis result = next_of_bench(experiment);
    ASSERT_EQ(result.next.size(), 2u);
    EXPECT_DOUBLE_EQ(result.next.front().then, result.next.back().then);
}

}  // namespace tiretherm::diagnosis
