// SPDX-License-Identifier: BSD-3-Clause
// Remarks in words: numbers in their digits, spans of time in their unit, remarks inside of remarks, and words for every code.
#include "post/report/remark_text.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "post/report/stage_text.hpp"

namespace tiretherm::post {

namespace {

namespace remark = diagnosis::remark;
using diagnosis::Activity;
using diagnosis::Part;
using diagnosis::RemarkCode;
using diagnosis::RemarkKind;
using diagnosis::Seconds;
using diagnosis::Work;

// 20 Hz by means of ten samples are 2 Hz.
TEST(RemarkText, NamesAndNumbersStandInTheWords) {
    EXPECT_EQ(text_of(remark::thinned("run1", 20.0, 2.0, 10)),
              "run1: 20 Hz thinned to 2 Hz by means of 10 samples; the inputs are as they were logged");
    EXPECT_EQ(text_of(remark::noise_above_data_sheet("bulk", 1.6, "K", 3.2, 0.5)),
              "bulk: the noise of 1.6 K is 3.2 times what the data sheet says (0.5 K): either the sensor is worse than "
              "that, or an error of the model is counted as noise");
}

// Up to two minutes in seconds, up to two hours in minutes: 119 s, 600 s are 10 min, 9000 s are 2.5 h.
TEST(RemarkText, SpansOfTimeHaveTheUnitThatSuitsThem) {
    const auto limit = [](double seconds) {
        const std::string text = text_of(remark::noise_as_slow_as_allowed("bulk", Seconds(seconds)));
        return text.substr(0, text.find(" or a tenth"));
    };
    EXPECT_TRUE(limit(12.0).ends_with("upper limit, 12 s")) << limit(12.0);
    EXPECT_TRUE(limit(600.0).ends_with("upper limit, 10 min")) << limit(600.0);
    EXPECT_TRUE(limit(9000.0).ends_with("upper limit, 2.5 h")) << limit(9000.0);
}

TEST(RemarkText, RemarksInsideOfARemarkAreListed) {
    EXPECT_EQ(text_of(remark::no_sensor_changes({remark::sensor_of_run("surface", "run1"),
                                                 remark::sensor_of_run("bulk", "run1"),
                                                 remark::sensor_of_run("bulk", "run2")})),
              "no sensor changes (surface of run1, bulk of run1 and bulk of run2).");
    EXPECT_EQ(text_of(remark::without_cause({remark::parameter_is_unexpected(
                  "initial.offset", 16.5, " K", {remark::above_prior(5.5, 0.0, 3.0), remark::at_bound_of_allowed()},
                  {remark::known_reason("the tire was warm")})})),
              "without any cause, initial.offset: the data pull it to 16.5 K, 5.5 standard deviations above the 0 +- 3 "
              "that were known before and the bound of what is allowed: the tire was warm");
}

// A table with as many words as codes has all of them only where none is there twice.
TEST(RemarkText, EveryCodeHasWordsOfItsOwn) {
    std::vector<std::string> texts;
#define REMARK(name, ...) texts.push_back(worded(remark::name));
    const auto worded = []<typename... About>(const RemarkKind<About...>& kind) { return text_of(kind(About{}...)); };
#include "diagnosis/remarks/remarks.list"
#undef REMARK
    EXPECT_EQ(texts.size(), static_cast<std::size_t>(RemarkCode::count));
    for (const std::string& text : texts) {
        EXPECT_EQ(std::ranges::count(texts, text), 1) << text;
    }
}

TEST(RemarkText, RemarksAreTheSameWhereAllThatTheyAreAboutIs) {
    EXPECT_EQ(remark::at_kink("tau"), remark::at_kink("tau"));
    EXPECT_FALSE(remark::at_kink("tau") == remark::at_kink("delay"));
    EXPECT_FALSE(remark::at_kink("tau") == remark::key_is_left_out("tau"));
}

TEST(StageText, SaysWhichRunIsDiagnosedAlone) {
    EXPECT_EQ(text_of(Activity{.doing = Work::signatures, .count = 23}), "signatures of 23 candidates");
    EXPECT_EQ(
        text_of(Activity{.doing = Work::candidate, .of = "rim_conduction", .number = 3, .count = 14, .run = "run2"}),
        "run2 alone: candidate");
    EXPECT_EQ(text_of(Part::grid_error), "estimate of the grid's error");
}

}  // namespace
}  // namespace tiretherm::post
