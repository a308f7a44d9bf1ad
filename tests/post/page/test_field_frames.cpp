// SPDX-License-Identifier: BSD-3-Clause
// The page's field against time: which moments it has, and what its hottest moment is.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/page/field_chart.hpp"
#include "post/report/value.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {

// Fields are stored at 0 and 60 s alone, and the tire is hottest at 45 s: the button leads there. 26.85 degC at the surface, 24 K
// more 12 mm deep, 100 K of warming: a peak of 150.85 degC, which is the top of the scale as well.
TEST(FieldFrames, TheHottestMomentIsThatOfTheRunAndNotOfTheStoredFields) {
    const solver::Problem problem = sample::problem();
    FieldFrames frames(problem);
    frames.take(sample::Moment(problem, 0.0, {}, true).snapshot);
    frames.take(sample::Moment(problem, 60.0, {}, true).snapshot);
    frames.take_hottest(45.0, sample::Moment(problem, 100.0, {}, true).snapshot.temperature);
    const nlohmann::json chart = nlohmann::json::parse(json_text(frames.chart()));
    ASSERT_EQ(chart["times"].size(), 3U);
    EXPECT_EQ(chart["hottest"], 1);
    EXPECT_NEAR(chart["marks"][1][2].get<double>(), 150.85, 1e-3);
    EXPECT_NEAR(chart["high"].get<double>(), 150.85, 1e-3);
}

// A moment that is stored anyway is not shown twice.
TEST(FieldFrames, AHottestMomentThatIsStoredIsShownOnce) {
    const solver::Problem problem = sample::problem();
    FieldFrames frames(problem);
    frames.take(sample::Moment(problem, 0.0, {}, true).snapshot);
    frames.take(sample::Moment(problem, 60.0, {}, true).snapshot);
    frames.take_hottest(60.0, sample::Moment(problem, 60.0, {}, true).snapshot.temperature);
    const nlohmann::json chart = nlohmann::json::parse(json_text(frames.chart()));
    EXPECT_EQ(chart["times"].size(), 2U);
    EXPECT_EQ(chart["hottest"], 1);
}

}  // namespace tiretherm::post
