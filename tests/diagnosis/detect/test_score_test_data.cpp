// SPDX-License-Identifier: BSD-3-Clause
// Signatures of candidates, which are taken many at a time.

#include <gtest/gtest.h>

#include "diagnosis/detect/score_test_data.hpp"
#include "diagnosis/practice_bench.hpp"

namespace tiretherm::diagnosis {

// All candidates are switched on at the value at which they do nothing: what one of them would do is the same whatever is
// switched on beside it. The sensitivities are solved to 1e-4 of the largest; a tenth of a percent is allowed.
TEST(ScoreTestData, ASignatureIsTheSameAloneAndAmongAll) {
    const input::Experiment experiment = sample::practice_bench();
    const Observations observations = observe(experiment);
    const std::vector<Candidate> candidates = candidates_of(experiment, experiment.candidates);
    ASSERT_GT(candidates.size(), 24u);  // three parts at least
    const ScoreTestData all = prepare_score_tests(experiment, observations, candidates);
    ASSERT_TRUE(all.status.ok());
    for (const std::size_t k : {std::size_t{1}, candidates.size() / 2, candidates.size() - 1}) {
        const ScoreTestData alone = prepare_score_tests(experiment, observations, {candidates[k]});
        const Eigen::VectorXd among = all.signatures.col(static_cast<Eigen::Index>(k));
        EXPECT_LE((alone.signatures.col(0) - among).norm(), 1e-3 * among.norm()) << candidates[k].effect->id;
    }
}

}  // namespace tiretherm::diagnosis
