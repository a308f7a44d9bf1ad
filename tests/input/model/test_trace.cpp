// SPDX-License-Identifier: BSD-3-Clause
// Interpolation, means, extremes and rise times of recorded channels, against hand calculation.

#include "input/validation/trace.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::input {

namespace {

/// Two channels at 0, 10, 20 and 40 s: the first rises from 0 to 8 and falls to 4, the second stands at 7.
Trace hill() {
    Trace trace;
    for (const auto& [time, height] :
         {std::pair(0.0, 0.0), std::pair(10.0, 6.0), std::pair(20.0, 8.0), std::pair(40.0, 4.0)}) {
        const std::array channels{height, 7.0};
        solver::Snapshot snapshot;
        snapshot.time = time;
        snapshot.channels = channels;
        trace.take(snapshot);
    }
    return trace;
}

using enum Window::Take;

}  // namespace

TEST(Trace, IsStraightBetweenRowsAndHeldBeyond) {
    const Trace trace = hill();
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = at, .from = 5.0, .to = 5.0}), 3.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = at, .from = 20.0, .to = 20.0}), 8.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = at, .from = 99.0, .to = 99.0}), 4.0);
    EXPECT_DOUBLE_EQ(trace.read(1, {.take = at, .to = 33.0}), 7.0);
}

// From 5 s (3) over 10 s (6) and 20 s (8) to 30 s (6): (22.5 + 70 + 70) / 25.
TEST(Trace, MeanIsThatOfTheCourseNotOfTheRows) {
    const Trace trace = hill();
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = mean, .from = 5.0, .to = 30.0}), 162.5 / 25.0);
    EXPECT_DOUBLE_EQ(trace.read(1, {.take = mean, .from = 5.0, .to = 30.0}), 7.0);
}

TEST(Trace, ExtremesMayLieOnTheEndsOfTheSpan) {
    const Trace trace = hill();
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = max, .from = 5.0, .to = 30.0}), 8.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = max, .from = 0.0, .to = 15.0}), 7.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = min, .from = 5.0, .to = 30.0}), 3.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = min, .from = 20.0, .to = 40.0}), 4.0);
}

// 0 to 8 over 20 s: 6 at 10 s, 7.6 at 18 s. From 10 s on the change is 2: half of it after 5 s more. Falling: 8 to 4.
TEST(Trace, TimeToAShareOfTheChangeCountsFromTheBeginOfTheSpan) {
    const Trace trace = hill();
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = time_to, .from = 0.0, .to = 20.0, .share = 0.95}), 18.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = time_to, .from = 10.0, .to = 20.0, .share = 0.5}), 5.0);
    EXPECT_DOUBLE_EQ(trace.read(0, {.take = time_to, .from = 20.0, .to = 40.0, .share = 0.25}), 5.0);
    // Over the top: the change is 4, which is first passed on the way up at 4/6 of 10 s.
    EXPECT_NEAR(trace.read(0, {.take = time_to, .from = 0.0, .to = 40.0, .share = 1.0}), 20.0 / 3.0, 1e-12);
}

TEST(Trace, CourseThatDoesNotChangeIsThereAtOnce) {
    EXPECT_DOUBLE_EQ(hill().read(1, {.take = time_to, .from = 0.0, .to = 40.0, .share = 0.95}), 0.0);
}

}  // namespace tiretherm::input
