// SPDX-License-Identifier: BSD-3-Clause
// One chart for all channels against time: a panel for each unit, differences below it, inputs and bands of the run.

#include <algorithm>

#include "post/page/time_chart.hpp"
#include "solver/quantity.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

struct Drawn {
    Json chart;
    std::string caption;
};

Drawn drawn(const TimeChart& chart) {
    ReportSection section("page");
    add_time_chart(section, "title", "Caption.", chart);
    const PageItem& item = section.blocks().front();
    EXPECT_EQ(item.kind, PageItem::Kind::chart);
    return {Json::parse(compact_json(item.chart)), item.caption};
}

/// A channel that rises from 300.15 to 301.15 K over 20 min.
TimeSeries temperature(const std::string& channel) {
    return {.channel = channel,
            .unit = solver::shown_unit(solver::Quantity::temperature),
            .curves = {{channel, CurveRole::line, {0.0, 1200.0}, {300.15, 301.15}}}};
}

/// 40 m/s for 10 min, then 45 m/s.
solver::InputSignals two_steps() {
    solver::InputSignals inputs;
    inputs.add({.signal = physics::find_signal("speed"),
                .time = {0.0, 600.0, 600.0, 1200.0},
                .value = {40.0, 40.0, 45.0, 45.0}});
    inputs.add(*physics::find_signal("vertical_load"), 4000.0);
    return inputs;
}

// 300.15 K are 27 °C, 1200 s are 20 min; a gas of 200 kPa has another unit and a panel of its own, a low one.
TEST(TimeChart, EachUnitHasAPanelInTheOrderOfTheFirst) {
    TimeChart chart{.series = {temperature("inner")}};
    chart.series.push_back({.channel = "gauge",
                            .unit = {"kPa", 1e-3},
                            .curves = {{"gauge", CurveRole::line, {0.0, 1200.0}, {2e5, 2.1e5}}}});
    chart.series.push_back(temperature("outer"));
    const Json panels = drawn(chart).chart["panels"];
    ASSERT_EQ(panels.size(), 2u);
    EXPECT_EQ(panels[0]["name"], "temperature");
    EXPECT_EQ(panels[0]["unit"], "°C");
    EXPECT_EQ(panels[0]["short"], false);
    ASSERT_EQ(panels[0]["series"].size(), 2u);
    EXPECT_EQ(panels[0]["series"][0]["points"], Json::parse("[[0.0,27.0],[20.0,28.0]]"));
    EXPECT_EQ(panels[0]["series"][1]["name"], "outer");
    EXPECT_EQ(panels[1]["name"], "gauge");
    EXPECT_EQ(panels[1]["short"], true);
    EXPECT_EQ(panels[1]["series"][0]["points"][0][1], 200.0);
}

// The difference of two temperatures has no zero to be shifted by: 2 K stay 2. A standard deviation of 1 K is a band of +-1.96 K.
TEST(TimeChart, DifferencesStandBelowWithTheirNoise) {
    TimeChart chart{.series = {temperature("inner")}};
    chart.series[0].differences = {{"inner", CurveRole::line, {0.0, 1200.0}, {2.0, -1.0}}};
    chart.series[0].noise = 1.0;
    const Json panels = drawn(chart).chart["panels"];
    ASSERT_EQ(panels.size(), 2u);
    EXPECT_EQ(panels[1]["name"], "simulated - measured");
    EXPECT_EQ(panels[1]["unit"], "K");
    EXPECT_EQ(panels[1]["series"][0]["points"], Json::parse("[[0.0,2.0],[20.0,-1.0]]"));
    EXPECT_EQ(panels[1]["series"][1]["role"], "band");
    EXPECT_EQ(panels[1]["series"][1]["points"][0], Json::parse("[0.0,-1.95996,1.95996]"));
    EXPECT_EQ(panels[1]["levels"][0]["value"], 0.0);
}

// A measured range of 300.15 to 302.15 K at 10 min, a level of 373.15 K, and a mark on it at 5 min.
TEST(TimeChart, RangesLevelsAndMarksHaveTheUnitsOfTheirPanel) {
    TimeChart chart{.series = {temperature("belt edge")}};
    chart.series[0].measured = {{600.0}, {300.15}, {302.15}};
    chart.series[0].levels = {{"critical", 373.15}};
    chart.series[0].marks = {{"passes", 373.15, 300.0}};
    const Json panel = drawn(chart).chart["panels"][0];
    EXPECT_EQ(panel["series"][1]["name"], "belt edge, measured");
    EXPECT_EQ(panel["series"][1]["points"], Json::parse("[[10.0,27.0,29.0]]"));
    EXPECT_EQ(panel["levels"][0]["value"], 100.0);
    EXPECT_EQ(panel["marks"][0]["x"], 5.0);
    EXPECT_EQ(panel["marks"][0]["y"], 100.0);
}

// 40 and 45 m/s are 144 and 162 km/h: two bands, and one panel of the speed, as the load stands still.
TEST(TimeChart, StepsOfTheScheduleAreBandsAndTheCaptionSaysSo) {
    const solver::InputSignals inputs = two_steps();
    TimeChart chart{.series = {temperature("inner")}, .inputs = &inputs};
    const Drawn whole = drawn(chart);
    ASSERT_EQ(whole.chart["panels"].size(), 2u);
    EXPECT_EQ(whole.chart["panels"][1]["name"], "speed");
    ASSERT_EQ(whole.chart["spans"].size(), 2u);
    EXPECT_EQ(whole.chart["spans"][1], Json::parse(R"({"name":"162 km/h","from":10.0,"to":20.0})"));
    EXPECT_EQ(whole.caption, "Caption. The bands are the steps of the schedule.");
    chart.has_input_panels = false;
    const Drawn without = drawn(chart);
    EXPECT_EQ(without.chart["panels"].size(), 1u);
    EXPECT_EQ(without.chart["spans"].size(), 2u);
}

// A run of 20 min on a page whose longest one takes 40 min.
TEST(TimeChart, TheAxisIsThatOfTheCurvesOrTheOneThatAPageShares) {
    TimeChart chart{.series = {temperature("inner")}};
    EXPECT_EQ(drawn(chart).chart["x"], Json::parse(R"({"name":"time","unit":"min","min":0.0,"max":20.0})"));
    chart.axis = {0.0, 2400.0};
    EXPECT_EQ(drawn(chart).chart["x"]["max"], 40.0);
}

TEST(TimeChart, LapsTakeThePlaceOfSteps) {
    const solver::InputSignals inputs = two_steps();
    const std::vector<input::Lap> laps{{.start = 0.0, .end = 300.0, .kind = input::LapKind::out},
                                       {.number = 1, .start = 300.0, .end = 1200.0}};
    const Drawn page = drawn({.series = {temperature("inner")}, .inputs = &inputs, .laps = laps});
    ASSERT_EQ(page.chart["spans"].size(), 2u);
    EXPECT_EQ(page.chart["spans"][0]["name"], "out");
    EXPECT_EQ(page.chart["spans"][1], Json::parse(R"({"name":"lap 1","from":5.0,"to":20.0})"));
    EXPECT_EQ(page.caption, "Caption. The bands are laps.");
}

}  // namespace
}  // namespace tiretherm::post
