// SPDX-License-Identifier: BSD-3-Clause
// Lines of progress: their numbers, how often they are written, and their removal at the end.

#include <cstdio>

#include <gtest/gtest.h>

#include "post/report/file.hpp"
#include "post/report/progress.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

using Kind = ProgressLine::Kind;

/// What a line writes that is shown at some seconds of a clock; each text is its time.
std::string written(Kind kind, std::initializer_list<double> seconds) {
    const sample::Scratch scratch;
    std::FILE* file = std::fopen((scratch / "screen").c_str(), "wb");
    double now = 0.0;
    {
        ProgressLine line(file, kind, [&] { return now; });
        for (const double second : seconds) {
            now = second;
            line.show([](double elapsed) { return std::to_string(static_cast<int>(10.0 * elapsed + 0.5)); });
        }
    }
    std::fclose(file);
    return read_text(scratch / "screen");
}

TEST(Progress, LineTellsShareTimeHottestSpeedAndRest) {
    // 900 s of 1800 s in 0.5 s: 1 800 times real time, and as long again.
    EXPECT_EQ(progress_line("laser/one_watt",
                            {.start = 0.0, .end = 1800.0, .time = 900.0, .hottest = 371.25, .elapsed = 0.5}),
              "laser/one_watt  50 %  about 0.5 s left  t = 900 s of 1800 s  hottest 98.1 °C  1 800 x real time");
}

TEST(Progress, TimeLeftFollowsFromTheRunsThatTookTime) {
    // 12 of 40 runs are done, 2 of them by an earlier call: 10 in 20 s are 0.5 a second, and 28 more take 56 s.
    EXPECT_EQ(work_line({.done = 12, .total = 40, .kept = 2}, 20.0), "12 of 40 runs, 0.5 runs/s, about 56 s left");
}

// 12 in 4 s are 3 a second: 28 to 118 more take 9.3 to 39.3 s. Where all that is certain is done the rest may be nothing.
TEST(Progress, TimeLeftLiesWithinTheBoundsOfTheTotal) {
    EXPECT_EQ(work_line({.done = 12, .total = 40, .at_most = 130}, 4.0),
              "12 of 40 to 130 runs, 3 runs/s, 9.3 s to 39 s left");
    EXPECT_EQ(work_line({.done = 12, .total = 12, .at_most = 130}, 4.0),
              "12 of 12 to 130 runs, 3 runs/s, at most 39 s left");
}

TEST(Progress, NothingIsSaidOfTheTimeLeftWhereTheTotalIsUnknown) {
    // 300 simulations in 150 s are 2 a second; one in 50 s is slower than 0.1 a second, which is said as seconds for one.
    EXPECT_EQ(work_line({.stage = {.doing = "looking back"}, .done = 300, .thing = "simulation"}, 150.0),
              "looking back, 300 simulations, 2 simulations/s, 2 min so far");
    EXPECT_EQ(work_line({.done = 1, .thing = "simulation"}, 50.0), "1 simulation, 50 s a simulation, 50 s so far");
}

// Six candidates took 36 s, and so the seventh to the 23rd take 17 x 6 s = 102 s. Of the first nothing is known.
TEST(Progress, TimeLeftOfAStageFollowsFromItsOwnPieces) {
    WorkDone work{
        .stage = {.doing = "candidate", .of = "sidewall_convection", .number = 7, .count = 23, .elapsed = 36.0},
        .done = 300,
        .thing = "simulation"};
    EXPECT_EQ(
        work_line(work, 150.0),
        "candidate 7 of 23: sidewall_convection, about 102 s left, 300 simulations, 2 simulations/s, 2 min so far");
    work.stage.number = 1;
    EXPECT_EQ(work_line(work, 150.0),
              "candidate 1 of 23: sidewall_convection, 300 simulations, 2 simulations/s, 2 min so far");
}

// Updates within a tenth of a second after one that was written are not: of 0.10, 0.15, 0.20 s the second is left out.
TEST(Progress, ALineOnATerminalIsRewrittenAtMostTenTimesASecondAndRemovedAtTheEnd) {
    EXPECT_EQ(written(Kind::rewritten, {0.1, 0.15, 0.21}), "\r1\033[K\r2\033[K\r\033[K");
}

// The first line comes after ten seconds, the next a minute after it: of 9, 12, 60, 73, 100 s the second and the fourth.
TEST(Progress, InAPipeThereIsALineAfterTenSecondsAndThenOneAMinute) {
    EXPECT_EQ(written(Kind::each_minute, {9.0, 12.0, 60.0, 73.0, 100.0}), "120\n730\n");
}

TEST(Progress, StaysSilentWhenNotShown) { EXPECT_EQ(written(Kind::silent, {1.0, 100.0, 1000.0}), ""); }

}  // namespace
}  // namespace tiretherm::post
