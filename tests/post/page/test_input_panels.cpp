// SPDX-License-Identifier: BSD-3-Clause
// Inputs below the curves: only what changes, in the units of the user, cut to the run; steps as bands with their names.

#include "post/page/input_panels.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

solver::Series series(const char* name, std::vector<double> time, std::vector<double> value) {
    return {.signal = physics::find_signal(name), .time = std::move(time), .value = std::move(value)};
}

/// 10 m/s rising to 20 m/s over 100 s, a load that stands still, and air that cools from 300.15 to 290.15 K.
solver::InputSignals inputs() {
    solver::InputSignals inputs;
    inputs.add(series("speed", {0.0, 100.0}, {10.0, 20.0}));
    inputs.add(series("vertical_load", {0.0, 100.0}, {4000.0, 4000.0}));
    inputs.add(series("air_temperature", {0.0, 50.0, 100.0}, {300.15, 295.15, 290.15}));
    return inputs;
}

Json panels(const LineChart& chart) { return Json::parse(compact_json(chart.data()))["panels"]; }

TEST(InputPanels, ShowWhatChangesInTheUnitsOfTheUser) {
    LineChart chart("time", "min", 0.0, 1.0);
    add_input_panels(chart, inputs(), 0.0, 60.0, 60.0);
    const Json all = panels(chart);
    ASSERT_EQ(all.size(), 2u);  // the load stands still
    EXPECT_EQ(all[0]["name"], "speed");
    EXPECT_EQ(all[0]["unit"], "km/h");
    // 10 m/s are 36 km/h; after 60 s 16 m/s, 57.6 km/h. One minute is 1.
    EXPECT_EQ(all[0]["series"][0]["points"], Json::parse("[[0.0,36.0],[1.0,57.6]]"));
    EXPECT_EQ(all[1]["unit"], "°C");
    // 27 degC, 22 after 50 s, and 21 after 60 s.
    EXPECT_EQ(all[1]["series"][0]["points"], Json::parse("[[0.0,27.0],[0.833333,22.0],[1.0,21.0]]"));
}

TEST(InputPanels, InputsThatStandStillHaveNone) {
    solver::InputSignals constant;
    constant.add(*physics::find_signal("speed"), 20.0);
    LineChart chart("time", "s", 0.0, 100.0);
    add_input_panels(chart, constant, 0.0, 100.0, 1.0);
    EXPECT_TRUE(chart.empty());
}

// 40 and 45 m/s are 144 and 162 km/h.
TEST(InputPanels, StepsAreNamedByWhatChanges) {
    std::vector<solver::ScheduleStep> steps{
        {.number = 1, .ramp = true, .from = 0.0, .to = 60.0, .speed = 40.0, .load = 5000.0},
        {.number = 1, .from = 60.0, .to = 600.0, .speed = 40.0, .load = 5000.0},
        {.number = 2, .from = 600.0, .to = 1200.0, .speed = 45.0, .load = 5000.0}};
    EXPECT_EQ(step_names(steps), (std::vector<std::string>{"", "144 km/h", "162 km/h"}));
    steps[2].load = 5500.0;
    EXPECT_EQ(step_names(steps), (std::vector<std::string>{"", "144 km/h, 5000 N", "162 km/h, 5500 N"}));
    steps[2].speed = 40.0;
    EXPECT_EQ(step_names(steps), (std::vector<std::string>{"", "5000 N", "5500 N"}));
}

TEST(InputPanels, StepsAreBandsInTheUnitOfTheAxis) {
    const std::vector<solver::ScheduleStep> steps{
        {.number = 1, .from = 0.0, .to = 600.0, .speed = 40.0, .load = 5000.0},
        {.number = 2, .from = 600.0, .to = 1200.0, .speed = 45.0, .load = 5000.0}};
    LineChart chart("time", "min", 0.0, 20.0);
    add_step_bands(chart, steps, 60.0);
    EXPECT_EQ(Json::parse(compact_json(chart.data()))["spans"],
              Json::parse(R"([{"name":"144 km/h","from":0.0,"to":10.0},{"name":"162 km/h","from":10.0,"to":20.0}])"));
    LineChart one("time", "min", 0.0, 20.0);
    add_step_bands(one, std::span(steps).first(1), 60.0);
    EXPECT_TRUE(Json::parse(compact_json(one.data()))["spans"].empty());
}

}  // namespace
}  // namespace tiretherm::post
