// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis answers when its time ends before the score tests.

#include <limits>

#include <gtest/gtest.h>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/practice_bench.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

/// A diagnosis of the practice runs whose time ends when a piece of work begins.
Diagnosis stopped_at_diagnosis_of(const input::Experiment& experiment, const Observations& observations, Work at) {
    DiagnosisOptions choice;
    choice.progress = [at](const Activity& now, long /*simulations*/) {
        if (now.doing == at) {
            solver::stop_after(0.0);
        }
    };
    Diagnosis result = diagnose(experiment, observations, choice);
    solver::stop_after(std::numeric_limits<double>::infinity());
    return result;
}

}  // namespace

// The runs were made with lambda_h = 1.05, which three runs know to 0.3 %; the case begins at 1. The time ends when the
// fit is there and no candidate has been looked at: the answer is the fitted case, with no cause and no verdict.
TEST(StoppedDiagnosis, AnswersWithTheFittedCaseBeforeAnyCandidateWasTried) {
    const input::Experiment experiment = sample::practice_bench();
    const Observations observations = observe(experiment);
    const Diagnosis result = stopped_at_diagnosis_of(experiment, observations, Work::signatures);
    ASSERT_TRUE(result.status.ok()) << result.status.message;
    EXPECT_EQ(result.verdict, Verdict::cannot_tell);
    EXPECT_EQ(result.stopped, Part::score_tests);
    EXPECT_TRUE(result.hypotheses.empty());
    EXPECT_NEAR(result.values[0], 1.05, 0.02);
    EXPECT_EQ(result.base.size(), observations.measured.size());
    EXPECT_EQ(result.noise.size(), observations.channels.size());
}

// Before the first simulation has ended there is nothing to answer with.
TEST(StoppedDiagnosis, HasNoAnswerWithoutASimulation) {
    const input::Experiment experiment = sample::practice_bench();
    const Observations observations = observe(experiment);
    const Diagnosis result = stopped_at_diagnosis_of(experiment, observations, Work::fitting_case);
    EXPECT_EQ(result.status.outcome, solver::Outcome::stopped);
}

}  // namespace tiretherm::diagnosis
