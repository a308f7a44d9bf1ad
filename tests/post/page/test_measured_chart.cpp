// SPDX-License-Identifier: BSD-3-Clause
// Measured beside simulated: curves that end where nothing was measured.

#include <algorithm>

#include "post/page/measured_chart.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

/// Two laps of 100 s at 1 Hz, with so much time between them.
Json panels(double between) {
    MeasuredSeries series{.channel = "surface",
                          .unit = solver::shown_unit(solver::Quantity::temperature),
                          .run = "session",
                          .time = {},
                          .measured = {},
                          .models = {{.name = "simulated", .simulated = {}}}};
    for (int i = 0; i <= 200; ++i) {
        series.time.push_back(i + (i > 100 ? between : 0.0));
        series.measured.push_back(300.0);
        series.models[0].simulated.push_back(301.0);
    }
    const ReportSection section = measured_section({series});
    const auto chart = std::ranges::find(section.blocks(), PageItem::Kind::chart, &PageItem::kind);
    EXPECT_NE(chart, section.blocks().end());
    return Json::parse(compact_json(chart->chart))["panels"];
}

// Of the temperatures there are points and a line, of the difference a line; with laps that do not count in between the lines have two
// pieces each, of 101 and 100 samples. A gap of 19 samples is one of the logger's.
TEST(MeasuredChart, LinesEndWhereNothingWasMeasured) {
    const Json whole = panels(18.0);
    ASSERT_EQ(whole[0]["series"].size(), 2u);
    ASSERT_EQ(whole[1]["series"].size(), 1u);
    const Json apart = panels(60.0);
    ASSERT_EQ(apart[0]["series"].size(), 3u);
    ASSERT_EQ(apart[1]["series"].size(), 2u);
    EXPECT_EQ(apart[1]["series"][0]["name"], apart[1]["series"][1]["name"]);
    EXPECT_EQ(apart[0]["series"][1]["points"].back()[0], 100.0);
    EXPECT_EQ(apart[0]["series"][2]["points"].front()[0], 161.0);
}

}  // namespace
}  // namespace tiretherm::post
