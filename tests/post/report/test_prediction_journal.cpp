// SPDX-License-Identifier: BSD-3-Clause
// What an interrupted call keeps of its simulations.
#include <array>

#include <gtest/gtest.h>

#include "post/report/output_folder.hpp"
#include "post/report/prediction_journal.hpp"
#include "tests/post/scratch.hpp"

namespace tiretherm::post {

// A short call without a limit keeps nothing; one with a limit keeps its first simulation, or it would begin anew each time.
TEST(PredictionJournal, ACallWithATimeLimitKeepsItsFirstResult) {
    const sample::Scratch scratch;
    const solver::Digest::Value identity{1, 2};
    const solver::Digest::Value key{3, 4};
    const std::array<double, 2> result{300.0, 301.0};
    constexpr double seconds = 1.0;  // so long for two numbers that they are worth keeping
    for (const bool has_limit : {false, true}) {
        OutputFolder folder(scratch / "o");
        PredictionJournal journal(folder, "diagnose.simulations", identity, true);
        if (has_limit) {
            journal.keep_at_once();
        }
        journal.add(key, result, seconds);
        EXPECT_EQ(journal.size(), has_limit ? 1U : 0U);
        EXPECT_EQ(journal.find(key).has_value(), has_limit);
        if (has_limit) {
            folder.keep_journals();
        }
    }
    OutputFolder folder(scratch / "o");
    const PredictionJournal next(folder, "diagnose.simulations", identity, false);
    EXPECT_EQ(next.found(), 1U);
}

}  // namespace tiretherm::post
