// SPDX-License-Identifier: BSD-3-Clause
// The charts of a run's page: sensors with measured values, and the heat of each path.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/run/run_sections.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

struct DrawnChart {
    Json chart;
    std::string caption;
};

/// The first chart that a function adds for the sample; nothing where it adds none.
template <typename Add>
DrawnChart drawn(Add add, const solver::Problem& problem = sample::problem()) {
    const solver::MarchReport report = sample::report();
    const History history = sample::history(problem);
    const RunRecord run{.problem = problem,
                        .report = report,
                        .history = history,
                        .provenance = {.version = "9.9", .case_file = "", .case_text = ""},
                        .warnings = {},
                        .files = {}};
    ReportSection section("page");
    add(section, run);
    return section.blocks().empty() ? DrawnChart{}
                                    : DrawnChart{Json::parse(compact_json(section.blocks().front().chart)),
                                                 section.blocks().front().caption};
}

DrawnChart sensors(const solver::Problem& problem = sample::problem()) {
    return drawn([](ReportSection& section, const RunRecord& run) { add_channel_charts(section, std::span(&run, 1)); },
                 problem);
}

// Rows at 0, 30 and 60 s; the spot goes from 23 to 97.5 degC. The liner was measured as 37 to 47 degC after 30 s.
TEST(RunCharts, SensorsStandBesideWhatWasMeasuredOfThem) {
    const DrawnChart page = sensors();
    const Json& panels = page.chart["panels"];
    ASSERT_EQ(panels.size(), 1U);
    const Json& series = panels[0]["series"];
    ASSERT_EQ(series.size(), 4U);
    EXPECT_EQ(series[0]["name"], "spot");
    EXPECT_EQ(series[0]["points"], Json::parse("[[0.0,23.0],[30.0,80.0],[60.0,97.5]]"));
    EXPECT_EQ(series[3]["name"], "liner, measured");
    EXPECT_EQ(series[3]["role"], "range");
    EXPECT_EQ(series[3]["points"], Json::parse("[[30.0,37.0,47.0]]"));
    EXPECT_EQ(page.caption, "Lines are simulated; a bar with circles is a measured value or range.");
}

// A value at the end of a run stands at its last row, one that the run has not reached is left out.
TEST(RunCharts, WhatTheRunHasNotReachedIsLeftOut) {
    solver::Problem problem = sample::problem();
    problem.measured[0].time = std::numeric_limits<double>::infinity();
    problem.measured[1].time = 90.0;
    const Json series = sensors(problem).chart["panels"][0]["series"];
    ASSERT_EQ(series.size(), 3U);
    EXPECT_EQ(series[1]["points"], Json::parse("[[60.0,85.0,85.0]]"));
}

TEST(RunCharts, ARunWithoutSensorsHasNoChartOfThem) {
    solver::Problem problem = sample::problem();
    problem.channels.clear();
    problem.measured.clear();
    EXPECT_TRUE(sensors(problem).chart.is_null());
}

// Conduction makes no heat of its own and is left out. The laser brings 1 W, the air takes 0.25: the sum is 0.75 W.
TEST(RunCharts, HeatHasACurveForEachPathThatDoesAnythingAndTheirSum) {
    const DrawnChart page = drawn(add_heat_course);
    const Json& panel = page.chart["panels"][0];
    EXPECT_EQ(panel["name"], "heat into it");
    EXPECT_EQ(panel["unit"], "W");
    EXPECT_EQ(panel["short"], false);
    ASSERT_EQ(panel["series"].size(), 3U);
    EXPECT_EQ(panel["series"][0]["name"], "laser");
    EXPECT_EQ(panel["series"][2]["role"], "dashed");
    EXPECT_EQ(panel["series"][2]["points"][1], Json::parse("[30.0,0.75]"));
    EXPECT_EQ(panel["levels"][0]["value"], 0.0);
}

TEST(RunCharts, ASteadyStateHasNoCourseOfHeat) {
    solver::Problem problem = sample::problem();
    problem.settings.steady = true;
    EXPECT_TRUE(drawn(add_heat_course, problem).chart.is_null());
}

}  // namespace
}  // namespace tiretherm::post
