// SPDX-License-Identifier: BSD-3-Clause
// Upper limits beside what the score tests say, and what blocks of time make of them.

#include "diagnosis/assess/upper_limits.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

namespace {

DiagnosisState tested_bench(const input::Experiment& experiment, const Observations& observations) {
    DiagnosisState state;
    state.score_data = prepare_score_tests(experiment, observations, candidates_of(experiment, experiment.candidates));
    EXPECT_TRUE(state.score_data.status.ok());
    state.verdict = Verdict::consistent;
    return state;
}

}  // namespace

// One signature beside the free numbers, in unit noise: its size is the score over the length of what is left of it, its 95 % are 1.96
// over that length. A conductance begins at none. An offset may go to either side.
TEST(UpperLimits, AreTheScoresBesideTheFreeNumbers) {
    input::Experiment experiment = sample::practice_bench();
    experiment.candidates = {"sidewall_convection", "sensor_offset"};
    const Observations observations = observe(experiment);
    DiagnosisState state = tested_bench(experiment, observations);
    const std::vector<UpperLimit> limits = upper_limits(state);
    ASSERT_EQ(limits.size(), 3u);  // sidewalls, an offset of either sensor
    const ScoreTestData& data = state.score_data;
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const double middle = data.candidates[k].absent + data.scores.amplitude(i);
        const double half = 1.959964 / data.scores.length[i];
        EXPECT_NEAR(limits[k].high, middle + half, 1e-6 * half);
        EXPECT_NEAR(limits[k].low, std::max(data.candidates[k].low, middle - half), 1e-6 * half);
        EXPECT_EQ(limits[k].absent, 0.0);
    }
    EXPECT_EQ(limits[0].id, "sidewall_convection");
    EXPECT_EQ(limits[0].unit, "W K-1");

    // What the model leaves beside an unnamed error may differ from block to block: no interval gets shorter by that.
    state.something_left = true;
    const std::vector<UpperLimit> doubted = upper_limits(state);
    ASSERT_EQ(doubted.size(), limits.size());
    for (std::size_t k = 0; k < limits.size(); ++k) {
        EXPECT_GE(doubted[k].high - doubted[k].low, (limits[k].high - limits[k].low) * (1.0 - 1e-9));
    }
}

// A diagnosis that is stopped once the free numbers are fitted has no signature yet, so that nothing bounds what was not looked at.
TEST(UpperLimits, AreNoneWhereTheWorkWasStoppedBeforeTheSignatures) {
    input::Experiment experiment = sample::practice_bench();
    experiment.candidates = {"sidewall_convection"};
    const Observations observations = observe(experiment);
    DiagnosisState state = tested_bench(experiment, observations);
    state.score_data.signatures.resize(0, 0);
    EXPECT_TRUE(upper_limits(state).empty());
}

}  // namespace tiretherm::diagnosis
