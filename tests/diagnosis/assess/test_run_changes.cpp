// SPDX-License-Identifier: BSD-3-Clause
// Numbers that one run has for itself, hidden in made-up readings of the practice bench; and that nothing is said where nothing of a run
// was changed.

#include "diagnosis/assess/run_changes.hpp"

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

/// What the three runs of the bench would have read, each with tables of its own in the case, in white noise of the data sheets.
Observations read_with(const input::Experiment& bench, const std::array<std::string, 3>& more, unsigned seed) {
    Observations read = observe(bench);
    std::mt19937_64 engine(seed);
    std::normal_distribution<double> noise;
    std::string last = "none";
    Eigen::VectorXd simulated;
    for (std::size_t run = 0; run < more.size(); ++run) {
        if (more[run] != last) {
            const input::Written written;
            const input::Experiment truth =
                sample::read_bench(written.add("truth.toml", sample::practice_text() + more[run]));
            Simulator simulator(truth, read);
            const ModelPrediction& predicted = simulator.at(simulator.start());
            EXPECT_TRUE(predicted.status.ok()) << predicted.status.message;
            simulated = predicted.simulated;
            last = more[run];
        }
        for (const NoiseBlock& block : read.blocks) {
            const double sigma = read.stated[static_cast<std::size_t>(block.channel)];
            for (Eigen::Index row = block.first; row < block.first + block.rows(); ++row) {
                if (read.rows[static_cast<std::size_t>(row)].run == run) {
                    read.measured[row] = simulated[row] + sigma * noise(engine);
                }
            }
        }
    }
    return read;
}

const std::string more_loss = "\n[effects.strain_energy_loss]\ntan_delta_a = 2.568e15\n";  // 1.2 times the case's
const std::string high_probe = "\n[effects.sensor_offset]\nchannels = [\"bulk_temperature\"]\nkelvin = \"2 K\"\n";
const std::string higher_probe = "\n[effects.sensor_offset]\nchannels = [\"bulk_temperature\"]\nkelvin = \"4 K\"\n";
const std::string open_sidewalls = "\n[effects.sidewall_convection]\nconductance = \"3 W/K\"\n";

std::vector<RunChange> changes_of(const input::Experiment& bench, const Observations& read) {
    const ScoreTestData score_data = prepare_score_tests(bench, read, candidates_of(bench, {}));
    EXPECT_TRUE(score_data.status.ok()) << score_data.status.message;
    return find_run_changes(score_data);
}

}  // namespace

// The loss of run 3 is 1.2 times that of the others: of a bulk that is some 40 K over the air 8 K, in noise of 0.3 K. It is a number of
// run 3 alone, and the case goes on with that of the others, 2.14e15.
TEST(RunChanges, AnotherCompoundInOneRunIsTold) {
    const input::Experiment bench = sample::practice_bench();
    const Observations read = read_with(bench, {"", "", more_loss}, 3);
    const Diagnosis found = diagnose(bench, read, {.only_verdict = true});
    ASSERT_FALSE(found.hypotheses.empty());
    const Cause& cause = found.causes[found.hypotheses.front().front()];
    EXPECT_EQ(cause.id, "strain_energy_loss");
    EXPECT_EQ(cause.run, "run3");
    EXPECT_EQ(cause.numbers.front().key, "tan_delta_a");
    EXPECT_NEAR(cause.numbers.front().value / *cause.instead_of, 1.2, 0.01);
    EXPECT_GT(cause.numbers.front().low / *cause.instead_of, 1.1);
    EXPECT_EQ(found.verdict, Verdict::named);
    EXPECT_TRUE(found.gain.confirmed);
    ASSERT_TRUE(found.extended_model);
    ASSERT_EQ(found.extended_values.size(), static_cast<Eigen::Index>(bench.parameters.size()));
    const auto loss = static_cast<Eigen::Index>(sample::index_of(*found.extended_model, sample::loss));
    EXPECT_NEAR(found.extended_values[loss] / 2.14e15, 1.0, 0.02);
    EXPECT_TRUE(found.extended_model->parameters[static_cast<std::size_t>(loss)].runs.empty());
    EXPECT_EQ(found.values.size(), found.extended_values.size());
}

// A probe that reads 2 K more in run 1: a loss would raise run 1 as well, but tread and bulk together, and more the hotter the tire is.
TEST(RunChanges, AProbeOfOneRunIsTold) {
    const input::Experiment bench = sample::practice_bench();
    const std::vector<RunChange> found = changes_of(bench, read_with(bench, {high_probe, "", ""}, 4));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().name(bench), "sensor_offset of bulk_temperature");
    EXPECT_EQ(found.front().runs, std::vector<std::size_t>{0});
    EXPECT_FALSE(found.front().is_trend);
}

// A probe that reads 2 K more in each run than in the one before is named, and not confirmed: no two runs share what it reads, so that none
// says what the next one has.
TEST(RunChanges, WhatNoTwoRunsShareIsNotConfirmed) {
    const input::Experiment bench = sample::practice_bench();
    const Diagnosis found =
        diagnose(bench, read_with(bench, {"", high_probe, higher_probe}, 6), {.only_verdict = true});
    ASSERT_FALSE(found.hypotheses.empty());
    EXPECT_EQ(found.causes[found.hypotheses.front().front()].id, "sensor_offset");
    EXPECT_EQ(found.verdict, Verdict::named);
    EXPECT_GT(found.gain.removed_low, 0.5);
    EXPECT_FALSE(found.gain.confirmed);
}

// Nothing is hidden: of 20 drawn sets none may show a change, at two in a thousand.
TEST(RunChanges, NothingIsToldWhereNothingIsHidden) {
    const input::Experiment bench = sample::practice_bench();
    Observations read = read_with(bench, {"", "", ""}, 10);
    const ScoreTestData first = prepare_score_tests(bench, read, candidates_of(bench, {}));
    ASSERT_TRUE(first.status.ok());
    std::mt19937_64 engine(11);
    std::normal_distribution<double> noise;
    for (int draw = 0; draw < 20; ++draw) {
        for (const NoiseBlock& block : read.blocks) {
            for (Eigen::Index row = block.first; row < block.first + block.rows(); ++row) {
                read.measured[row] =
                    first.base.simulated[row] + read.stated[static_cast<std::size_t>(block.channel)] * noise(engine);
            }
        }
        ScoreTestData again = first;
        again.observations = &read;
        EXPECT_TRUE(find_run_changes(again).empty()) << draw;
    }
}

// 3 W/K through the sidewalls are missing in all runs, which are driven differently: each run asks for another loss, and it is a cause
// that all runs have.
TEST(RunChanges, WhatAllRunsLackIsNoChangeOfARun) {
    const input::Experiment bench = sample::practice_bench();
    EXPECT_TRUE(changes_of(bench, read_with(bench, {open_sidewalls, open_sidewalls, open_sidewalls}, 5)).empty());
}

// sqrt(2 ln(60 / 0.002)) = 4.541: the chance of one normal number beyond z is less than exp(-z^2 / 2).
TEST(RunChanges, TheLimitGrowsWithWhatIsLookedAt) {
    EXPECT_NEAR(least_of_run_changes(60), 4.541, 0.001);
    EXPECT_LT(least_of_run_changes(1), least_of_run_changes(60));
}

// Numbers of single runs come after all others and go again: the case is what it was.
TEST(RunChanges, TheCaseIsTheSameWithoutThem) {
    const input::Experiment bench = sample::practice_bench();
    const std::size_t loss = sample::index_of(bench, sample::loss);
    std::vector<RunChange> changes{{.number = loss, .runs = {1}}};
    for (const Candidate& candidate : candidates_of(bench, {"sensor_offset"})) {
        changes.push_back({.candidate = candidate, .runs = {0, 1}, .is_trend = true});
    }
    ASSERT_EQ(changes.size(), 3U);  // of two sensors
    const input::Experiment changed = with_run_changes(bench, changes);
    ASSERT_EQ(changed.parameters.size(), bench.parameters.size() + 5U);
    EXPECT_EQ(changed.parameters[loss].runs, (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(changed.parameters[bench.parameters.size()].name, "strain_energy_loss.tan_delta_a of run2");
    Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(changed.parameters.size()), 0.0, 1.0);
    const Eigen::VectorXd kept = values.head(static_cast<Eigen::Index>(bench.parameters.size()));
    const input::Experiment again = without_run_changes(changed, bench, changes, values);
    EXPECT_EQ(values, kept);
    ASSERT_EQ(again.parameters.size(), bench.parameters.size());
    EXPECT_TRUE(again.parameters[loss].runs.empty());
    EXPECT_EQ(again.runs.front().problem.effects.size(), bench.runs.front().problem.effects.size());
}

}  // namespace tiretherm::diagnosis
