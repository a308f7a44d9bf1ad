// SPDX-License-Identifier: BSD-3-Clause
// Two results side by side: what differs in their cases, and what their channels, hottest places and heat come to.
#include "post/pair/pair_report.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

/// A run of 100 s whose bulk goes from 20 to a last temperature on a straight line.
StoredResult result(const char* folder, double last) {
    StoredResult made{.folder = folder, .kind = "run"};
    made.case_values = {{"drive.speed", "100 km/h"}, {"drive.vertical_load", "4000 N"}};
    made.data = {{"hottest", {{"temperature", last + 5.0}, {"time", 100.0}, {"layer", "bulk"}}},
                 {"budget",
                  {{{"effect", "loss"}, {"watts_final", 300.0}, {"joules", 30e3}},
                   {{"effect", "laser"}, {"watts_final", 0.0}, {"joules", 0.0}}}}};
    made.courses = {{.name = "bulk", .unit = "degC", .time = {0.0, 100.0}, .value = {20.0, last}}};
    return made;
}

Json data_of(const StoredResult& a, const StoredResult& b) { return Json::parse(json_text(pair_report(a, b).data)); }

/// The chart of a page. @pre there is one
Json chart_of(const Report& report) {
    for (const ReportSection& section : report.sections) {
        const auto chart = std::ranges::find(section.blocks(), PageItem::Kind::chart, &PageItem::kind);
        if (chart != section.blocks().end()) {
            return Json::parse(compact_json(chart->chart));
        }
    }
    ADD_FAILURE() << "no chart";
    return {};
}

// Means of straight lines from 20 to 60 and to 80: 40 and 50. All differences are B - A.
TEST(PairReport, ChannelsAreComparedByTheirLastLargestAndMeanValue) {
    const Json channel = data_of(result("a", 60.0), result("b", 80.0))["channels"][0];
    EXPECT_EQ(channel["channel"], "bulk");
    EXPECT_EQ(channel["final_difference"], 20.0);
    EXPECT_EQ(channel["max_b"], 80.0);
    EXPECT_NEAR(channel["mean_a"].get<double>(), 40.0, 1e-9);
    EXPECT_NEAR(channel["mean_difference"].get<double>(), 10.0, 1e-9);
}

TEST(PairReport, OnlyInputsThatDifferAreListed) {
    const StoredResult a = result("a", 60.0);
    StoredResult b = result("b", 60.0);
    b.case_values["drive.speed"] = "120 km/h";
    b.case_values["tire.width"] = "200 mm";
    const Json inputs = data_of(a, b)["inputs"];
    ASSERT_EQ(inputs.size(), 2U);
    EXPECT_EQ(inputs[0], (Json{{"key", "drive.speed"}, {"a", "100 km/h"}, {"b", "120 km/h"}}));
    EXPECT_EQ(inputs[1]["a"], "-");  // A's case has no such key
    EXPECT_NE(page_text(pair_report(a, a), false).find("none: both cases have the same values"), std::string::npos);
}

// An effect that makes nothing in both has no row; of 300 W and 450 W the difference is 150 W.
TEST(PairReport, HeatAndHottestPlacesAreComparedWhereThereAreAny) {
    StoredResult b = result("b", 80.0);
    b.data["budget"][0]["watts_final"] = 450.0;
    const Json data = data_of(result("a", 60.0), b);
    ASSERT_EQ(data["heat"].size(), 1U);
    EXPECT_EQ(data["heat"][0]["effect"], "loss");
    EXPECT_EQ(data["heat"][0]["watts_difference"], 150.0);
    EXPECT_EQ(data["heat"][0]["kilojoules_a"], 30.0);
    EXPECT_EQ(data["hottest"][0]["hottest_difference"], 20.0);
    EXPECT_TRUE(data["hot_spots"].empty());
}

// B's rows stand at 0, 50 and 100 s. A's are at 0 and 100 s: the differences are taken there.
TEST(PairReport, TheChartHasBothCoursesAndTheirDifferenceAtTheTimesOfA) {
    StoredResult b = result("b", 80.0);
    b.courses[0].time = {0.0, 50.0, 100.0};
    b.courses[0].value = {21.0, 50.0, 80.0};
    const Json panels = chart_of(pair_report(result("a", 60.0), b))["panels"];
    ASSERT_EQ(panels.size(), 2U);
    EXPECT_EQ(panels[0]["series"][0]["role"], "dashed");
    EXPECT_EQ(panels[0]["series"][1]["points"].size(), 3U);
    EXPECT_EQ(panels[1]["name"], "B - A");
    EXPECT_EQ(panels[1]["unit"], "K");
    EXPECT_EQ(panels[1]["series"][0]["points"], Json::parse("[[0.0,1.0],[100.0,20.0]]"));
}

TEST(PairReport, SaysWhyTwoResultsCannotBeCompared) {
    const StoredResult run = result("a", 60.0);
    StoredResult other = result("b", 60.0);
    EXPECT_EQ(nothing_in_common(run, other), "");
    other.courses[0].name = "liner";
    EXPECT_EQ(nothing_in_common(run, other), "a and b have no channel in common");
    other.kind = "compare";
    EXPECT_EQ(nothing_in_common(run, other), "a is a result of run, b one of compare");
}

TEST(PairReport, ChannelsOfOneResultAloneAreNamed) {
    const StoredResult a = result("a", 60.0);
    StoredResult b = result("b", 60.0);
    b.courses.push_back({.name = "liner", .unit = "degC", .time = {0.0, 1.0}, .value = {20.0, 21.0}});
    EXPECT_NE(page_text(pair_report(a, b), false).find("only B has liner"), std::string::npos);
}

}  // namespace
}  // namespace tiretherm::post
