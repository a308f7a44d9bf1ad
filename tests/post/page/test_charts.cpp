// SPDX-License-Identifier: BSD-3-Clause
// Data of charts: no peak is lost, gaps stay gaps, bytes as RFC 4648 has them.

#include "post/page/charts.hpp"
#include "post/report/base64.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

/// The points of the only curve of a chart.
Json points_of(const LineChart& chart) {
    return Json::parse(compact_json(chart.data()))["panels"][0]["series"][0]["points"];
}

LineChart chart_of(const std::vector<double>& y) {
    std::vector<double> x;
    for (std::size_t i = 0; i < y.size(); ++i) {
        x.push_back(static_cast<double>(i));
    }
    LineChart chart("time", "s", 0.0, static_cast<double>(y.size()));
    chart.add_panel("temperature", "°C");
    chart.add_curve("a", "", CurveRole::line, x, y);
    return chart;
}

TEST(Charts, ShortCurvesAreWhole) {
    const Json points = points_of(chart_of({1.0, 2.0, 4.0}));
    EXPECT_EQ(points, Json::parse("[[0.0,1.0],[1.0,2.0],[2.0,4.0]]"));
}

TEST(Charts, ALongCurveKeepsItsPeaksAndItsEnds) {
    std::vector<double> y(100'000, 20.0);
    y.front() = 19.0;
    y[54'321] = 93.25;
    y[54'325] = -7.5;
    y.back() = 21.0;
    const Json points = points_of(chart_of(y));
    EXPECT_LE(points.size(), 2401u);  // two of each of 1200 pieces, and the last
    EXPECT_EQ(points.front(), Json::parse("[0.0,19.0]"));
    EXPECT_EQ(points.back(), Json::parse("[99999.0,21.0]"));
    EXPECT_NE(std::ranges::find(points, Json::parse("[54321.0,93.25]")), points.end());
    EXPECT_NE(std::ranges::find(points, Json::parse("[54325.0,-7.5]")), points.end());
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_LT(points[i - 1][0], points[i][0]);
    }
}

TEST(Charts, WhatIsNoNumberIsAGap) {
    const Json points = points_of(chart_of({1.0, std::numeric_limits<double>::quiet_NaN(), 3.0}));
    EXPECT_TRUE(points[1][1].is_null());
}

TEST(Charts, LongCurvesWithGapsStillKeepTheirPeak) {
    std::vector<double> y(10'000, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < y.size(); i += 2) {
        y[i] = 20.0;
    }
    y[5000] = 80.0;
    bool found = false;
    for (const Json& point : points_of(chart_of(y))) {
        found = found || point[1] == 80.0;
    }
    EXPECT_TRUE(found);
}

TEST(Charts, ALimitOfPointsKeepsThePeak) {
    std::vector<double> x;
    std::vector<double> y(10'000, 20.0);
    for (std::size_t i = 0; i < y.size(); ++i) {
        x.push_back(static_cast<double>(i));
    }
    y[7777] = 80.0;
    LineChart chart("time", "s", 0.0, 1e4);
    chart.share_points(1000, 5);
    chart.add_panel("temperature", "°C");
    chart.add_curve("a", "", CurveRole::line, x, y);
    const Json points = points_of(chart);
    EXPECT_LE(points.size(), 201u);  // two of each of 100 pieces, and the last
    EXPECT_NE(std::ranges::find(points, Json::parse("[7777.0,80.0]")), points.end());
}

TEST(Charts, AMarkStandsInThePanelThatItWasAddedTo) {
    LineChart chart("time", "min", 0.0, 10.0);
    chart.add_panel("temperature", "°C");
    chart.add_mark("belt edge passes 110 °C", "belt edge", 3.5, 110.0);
    chart.add_panel("speed", "km/h", true);
    const Json panels = Json::parse(compact_json(chart.data()))["panels"];
    EXPECT_EQ(panels[0]["marks"],
              Json::parse(R"([{"name":"belt edge passes 110 °C","group":"belt edge","x":3.5,"y":110.0}])"));
    EXPECT_TRUE(panels[1]["marks"].empty());
}

TEST(Charts, BarsHaveTheirIntervalsOnlyWhereTheyAreKnown) {
    const Json chart = Json::parse(
        compact_json(bar_chart("gain", "%",
                               {{.name = "all", .value = 40.0, .low = 30.0, .high = 50.0, .is_marked = true},
                                {.name = "run 1", .value = -5.0}},
                               {{.name = "half", .value = 50.0}})));
    EXPECT_EQ(chart["items"], Json::parse(R"([{"name":"all","value":40.0,"low":30.0,"high":50.0,"marked":true},
                                              {"name":"run 1","value":-5.0}])"));
    EXPECT_EQ(chart["levels"], Json::parse(R"([{"name":"half","value":50.0}])"));
}

TEST(Charts, BarsSideBySideKeepTheirOrderAndTheirGaps) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const Json chart = Json::parse(
        compact_json(grouped_bar_chart("rms", "K", {"before", "after"}, {{.name = "surface", .values = {2.0, none}}})));
    EXPECT_EQ(chart["series"], Json::parse(R"(["before","after"])"));
    EXPECT_EQ(chart["items"], Json::parse(R"([{"name":"surface","values":[2.0,null]}])"));
}

// Powers of ten times 1, 2, 2.5 and 5, the next one upwards.
TEST(Charts, StepsOfAnAxisAreRound) {
    EXPECT_DOUBLE_EQ(round_step(6.0), 10.0);
    EXPECT_DOUBLE_EQ(round_step(0.08), 0.1);
    EXPECT_DOUBLE_EQ(round_step(2.4), 2.5);
    EXPECT_DOUBLE_EQ(round_step(140.0), 200.0);
    EXPECT_DOUBLE_EQ(round_step(0.0051), 0.01);
    EXPECT_DOUBLE_EQ(round_step(5.0), 5.0);
}

TEST(Charts, NumbersHaveSixDigits) {
    EXPECT_EQ(rounded(1.0 / 3.0), 0.333333);
    EXPECT_EQ(rounded(123456789.0), 123457000.0);
    EXPECT_EQ(rounded(-0.00012345649, 5), -0.00012346);
}

TEST(Charts, BytesAsTextAreThoseOfTheStandard) {
    // RFC 4648, section 10.
    const auto text = [](std::string_view bytes) {
        return base64({reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size()});
    };
    EXPECT_EQ(text(""), "");
    EXPECT_EQ(text("f"), "Zg==");
    EXPECT_EQ(text("fo"), "Zm8=");
    EXPECT_EQ(text("foo"), "Zm9v");
    EXPECT_EQ(text("foob"), "Zm9vYg==");
    EXPECT_EQ(text("fooba"), "Zm9vYmE=");
    EXPECT_EQ(text("foobar"), "Zm9vYmFy");
}

TEST(Charts, TextAsBytesIsTheOtherWayRound) {
    EXPECT_EQ(from_base64("Zg=="), "f");
    EXPECT_EQ(from_base64("Zm9vYmE="), "fooba");
    EXPECT_EQ(from_base64("AAEC/w=="), (std::string("\0\1\2\xff", 4)));
    EXPECT_EQ(from_base64("Zg="), std::nullopt);   // cut off
    EXPECT_EQ(from_base64("Zm9 "), std::nullopt);  // a blank is no letter
    EXPECT_EQ(from_base64("Z=9v"), std::nullopt);
}

}  // namespace
}  // namespace tiretherm::post
