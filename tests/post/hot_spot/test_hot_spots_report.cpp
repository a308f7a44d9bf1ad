// SPDX-License-Identifier: BSD-3-Clause
// Hot spots in words, as data, as a chart and as a table: what was reached, when, and what could not be found out.
#include "post/hot_spot/hot_spots_report.hpp"

#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {

namespace {

using diagnosis::HotSpot;
using diagnosis::HotSpots;
using diagnosis::TestMoment;

using Json = nlohmann::json;

/// The whole specimen of the sample with 50 degC as critical, over three rows that are 30 K apart.
HotSpots made_up(const solver::Problem& problem) {
    std::vector<int> cells(static_cast<std::size_t>(problem.mesh.n_cells));
    std::iota(cells.begin(), cells.end(), 0);
    HotSpot spot{.history = solver::HotSpotHistory(
                     problem.mesh, {.name = "specimen", .temperature = 323.15, .nodes = std::move(cells)}),
                 .passing = std::nullopt};
    for (const double time : {0.0, 30.0, 60.0}) {
        spot.history.take(tiretherm::sample::Moment(problem, time, {300.0, 300.0}, true).snapshot);
    }
    spot.hottest = {.time = 60.0, .speed = 0.0, .load = 0.0, .temperature = spot.history.temperature().back()};
    return {.spots = {std::move(spot)}, .notes = {diagnosis::remark::at_kink("sensor_lag.tau")}};
}

// 40 m/s are 144 km/h. Step 3 begins after 20 min; 24 min are 4 min into it, and 20 min and 30 s half a minute up its ramp.
TEST(HotSpotsReport, AMomentIsToldByItsStepOrByWhatActsThen) {
    TestMoment moment{.time = 1440.0, .speed = 40.0, .load = 5580.0};
    EXPECT_EQ(moment_text(moment), "after 24.0 min, at 144 km/h, 5580 N");
    moment.step = solver::ScheduleStep{.number = 3, .from = 1200.0, .to = 1800.0};
    EXPECT_EQ(moment_text(moment), "after 24.0 min, 4.0 min into step 3 (144 km/h, 5580 N)");
    moment.step->ramp = true;
    EXPECT_EQ(moment_text(moment), "after 24.0 min, 4.0 min up the ramp to step 3 (144 km/h, 5580 N)");
    moment.steady = true;
    EXPECT_EQ(moment_text(moment), "in the steady state of 144 km/h, 5580 N");
}

// The inner face is 12 mm deep: 300 K + 2 K/mm * 12 mm + 60 K = 384 K at the end, 60.85 K above 323.15 K.
TEST(HotSpotsReport, DataHaveTheMarginAndTheNotes) {
    const solver::Problem problem = tiretherm::sample::problem();
    const Json data = Json::parse(json_text(hot_spots_data(made_up(problem), problem.mesh)));
    const Json& spot = data["spots"][0];
    EXPECT_EQ(spot["name"], "specimen");
    EXPECT_EQ(spot["critical"], 50.0);
    EXPECT_EQ(spot["layer"], "bulk");
    EXPECT_NEAR(spot["margin"].get<double>(), -60.85, 1e-9);
    EXPECT_TRUE(spot["passed"].is_null());
    EXPECT_EQ(data["notes"][0], "sensor_lag.tau is at a kink: its derivative is one-sided.");
}

TEST(HotSpotsReport, TheChartHasTheCourseAndTheCriticalTemperature) {
    const solver::Problem problem = tiretherm::sample::problem();
    const ReportSection section = hot_spots_section(made_up(problem), problem.mesh);
    const auto chart = std::ranges::find(section.blocks(), PageItem::Kind::chart, &PageItem::kind);
    ASSERT_NE(chart, section.blocks().end());
    const Json panel = Json::parse(compact_json(chart->chart))["panels"][0];
    EXPECT_EQ(panel["name"], "temperature");
    EXPECT_EQ(panel["levels"][0]["name"], "specimen: critical 50 °C");
    EXPECT_EQ(panel["levels"][0]["value"], 50.0);
    const Json& points = panel["series"][0]["points"];
    ASSERT_EQ(points.size(), 3U);
    EXPECT_NEAR(points[2][1].get<double>() - points[0][1].get<double>(), 60.0, 1e-3);  // a kelvin a second
}

TEST(HotSpotsReport, TheTableHasARowForEachRowOfTheRun) {
    const tiretherm::sample::Scratch scratch;
    const solver::Problem problem = tiretherm::sample::problem();
    write_hot_spots_csv(scratch / "hot_spots.csv", made_up(problem), problem);
    const std::string text = read_text(scratch / "hot_spots.csv");
    EXPECT_TRUE(text.starts_with("time [s],speed [km/h],vertical_load [N],specimen [degC],specimen margin [K],"))
        << text;
    EXPECT_EQ(std::ranges::count(text, '\n'), 4) << text;
    EXPECT_NE(text.find(",bulk,"), std::string::npos) << text;
}

}  // namespace
// Four standard deviations are not 100 %: the spreads are assumed, and the tails are not looked at.
TEST(HotSpotsReport, TailsOfAProbabilityAreBounded) {
    EXPECT_EQ(probability_text(0.641), "64.1 %");
    EXPECT_EQ(probability_text(0.009), "less than 1 %");
    EXPECT_EQ(probability_text(0.99997), "more than 99 %");
}

}  // namespace tiretherm::post
