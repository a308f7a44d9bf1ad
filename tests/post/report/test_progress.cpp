// SPDX-License-Identifier: BSD-3-Clause
// The progress line: its numbers, how often it is written, and its removal at the end.

#include <cstdio>
#include <thread>

#include <gtest/gtest.h>

#include "post/report/file.hpp"
#include "post/report/progress.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

/// What a progress of three updates, 0.11 s apart, writes.
std::string written(bool shown) {
    const sample::Scratch scratch;
    std::FILE* file = std::fopen((scratch / "screen").c_str(), "wb");
    {
        Progress progress(file, shown, "spot", 0.0, 100.0);
        const std::vector<double> temperature{300.0, 400.15};
        for (int i = 1; i <= 2; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(110));
            progress.update(10.0 * i, temperature);
            progress.update(10.0 * i, temperature);  // too soon: not written
        }
    }
    std::fclose(file);
    return read_text(scratch / "screen");
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++n;
    }
    return n;
}

TEST(Progress, LineTellsShareTimeHottestSpeedAndRest) {
    // 900 s of 1800 s in 0.5 s: 1 800 times real time, and as long again.
    EXPECT_EQ(progress_line("laser/one_watt",
                            {.start = 0.0, .end = 1800.0, .time = 900.0, .hottest = 371.25, .elapsed = 0.5}),
              "laser/one_watt  50 %  t = 900 s of 1800 s  hottest 98.1 °C  1 800 x real time  0.5 s left");
}

TEST(Progress, LineIsRewrittenAtMostTenTimesASecondAndRemovedAtTheEnd) {
    const std::string screen = written(true);
    EXPECT_EQ(count(screen, "hottest 127.0 °C"), 2u) << screen;
    EXPECT_EQ(count(screen, "\n"), 0u);
    EXPECT_TRUE(screen.ends_with("\r\033[K"));
}

TEST(Progress, StaysSilentWhenNotShown) { EXPECT_EQ(written(false), ""); }

}  // namespace
}  // namespace tiretherm::post
