// SPDX-License-Identifier: BSD-3-Clause
// What a diagnosis has ahead of it becomes less with what is done.

#include "diagnosis/detect/work_ahead.hpp"

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {
namespace {

constexpr Course three_runs{.runs = 3, .recordings = 3, .channels = 2, .alone = 4, .together = 13};

// Of four signatures two are done: two of three runs are ahead, and the noise takes at least three predictions, 2 x 3 + 9 = 15
// simulations. Nothing more is certain.
TEST(WorkAhead, AtLeastWhatHasToBeDone) {
    EXPECT_EQ(work_ahead(three_runs, {.doing = Work::signature, .number = 3, .count = 4}).least, 15);
    EXPECT_EQ(work_ahead(three_runs, {.doing = Work::candidate, .number = 1, .count = 5}).least, 0);
}

// A step of the search fits timing of two sensors and of the inputs, five more, and one anew: nine fits of 3 x 3 simulations. It tests
// three and that one on three recordings that are left out, of which each takes two predictions of all runs: 4 x 18. Together 153.
TEST(WorkAhead, AtMostAsManyStepsAsAreLeftOfTheSearch) {
    Course one = three_runs;
    one.additions = 1;
    const Activity now{.doing = Work::candidate, .number = 1, .count = 5};
    EXPECT_EQ(work_ahead(three_runs, now).most - work_ahead(one, now).most, 153);
}

TEST(WorkAhead, AnotherMeshIsAheadUntilItIsSearchedOn) {
    Course with_layers = three_runs;
    with_layers.richer = 1;
    const Activity now{.doing = Work::looking_back};
    EXPECT_GT(work_ahead(with_layers, now).least, work_ahead(three_runs, now).least);
    EXPECT_GT(work_ahead(with_layers, now).most, work_ahead(three_runs, now).most);
    EXPECT_EQ(work_ahead(with_layers, {.doing = Work::next_experiment}).most,
              work_ahead(three_runs, {.doing = Work::next_experiment}).most);
}

}  // namespace
}  // namespace tiretherm::diagnosis
