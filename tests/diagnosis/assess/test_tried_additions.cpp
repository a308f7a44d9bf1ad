// SPDX-License-Identifier: BSD-3-Clause
// What is kept of additions: the last trial of each, with what it did to the sensor that gains most.

#include "diagnosis/assess/tried_additions.hpp"

#include <gtest/gtest.h>

namespace tiretherm::diagnosis {

namespace {

TriedModel trial(const std::string& id, const std::string& channel, double removed, std::size_t beside = 0) {
    return {.addition = {.causes = {{.id = id, .channel = channel}}, .beside = beside, .removed = removed},
            .model = {.candidates = {beside + 1}, .values = {0.0}}};
}

}  // namespace

// A lag was tried alone, where it removed 30 %, and again beside another cause, which left it 2 %: the latter is what it is worth now.
// Behind the second sensor it is another addition.
TEST(TriedAdditions, EachCountsAsItWasTriedLastAndTheLargestFirst) {
    const std::vector<TriedModel> once =
        ranked({trial("sensor_lag", "surface", 0.3), trial("wind", "", 0.1), trial("sensor_lag", "bulk", 0.05),
                trial("sensor_lag", "surface", 0.02, 1)});
    ASSERT_EQ(once.size(), 3u);
    EXPECT_EQ(once[0].addition.causes.front().id, "wind");
    EXPECT_EQ(once[1].addition.causes.front().channel, "bulk");
    EXPECT_EQ(once[2].addition.removed, 0.02);
    EXPECT_EQ(once[2].addition.beside, 1u);
}

// 2.0 to 1.0 K is half, 0.9 to 0.3 K two thirds. A channel of which nothing was left out says nothing.
TEST(TriedAdditions, TheChannelThatGainsTheLargestShareIsKept) {
    Observations observations;
    observations.channels = {0, 2, 3};
    PredictionGain gain;
    EXPECT_FALSE(largest_change(gain, observations));
    gain.channels = {{}, {.before = 2.0, .after = 1.0, .low = 0.8, .high = 1.2}, {.before = 0.9, .after = 0.3}};
    const std::optional<ChannelChange> change = largest_change(gain, observations);
    ASSERT_TRUE(change);
    EXPECT_EQ(change->channel, 3u);
    EXPECT_DOUBLE_EQ(change->gain(), 0.6);
}

TEST(TriedAdditions, APredictionGoesToTheLastTrialOfItsModel) {
    Observations observations;
    observations.channels = {0};
    ScoreTestData score_data;
    score_data.observations = &observations;
    std::vector<TriedModel> tried{trial("wind", "", 0.1), trial("wind", "", 0.2), trial("sensor_lag", "bulk", 0.05, 1)};
    FittedHypothesis model;
    model.candidates = {1};
    const PredictionGain gain{.removed = 0.15,
                              .low = -0.05,
                              .high = 0.3,
                              .channels = {{.before = 1.0, .after = 0.9, .low = -0.02, .high = 0.2}}};
    take_prediction(gain, AdditionDoubt::may_be_chance, model, score_data, tried);
    EXPECT_FALSE(tried[0].addition.is_tested());
    ASSERT_TRUE(tried[1].addition.is_tested());
    EXPECT_EQ(tried[1].addition.removed, 0.15);
    EXPECT_EQ(tried[1].addition.doubt, AdditionDoubt::may_be_chance);
    EXPECT_EQ(tried[1].addition.change->low, -0.02);
    EXPECT_FALSE(tried[2].addition.is_tested());
}

}  // namespace tiretherm::diagnosis
