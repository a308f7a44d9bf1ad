// SPDX-License-Identifier: BSD-3-Clause
// Inputs below the curves: only what changes, in the units of the user, cut to the run; steps as bands with their names.

#include <set>
#include <string>

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

TEST(InputPanels, ShowWhatChangesBetweenTwoTimes) {
    const std::vector<TimeSeries> shown = changing_inputs(inputs(), 0.0, 60.0);
    ASSERT_EQ(shown.size(), 2u);  // the load stands still
    EXPECT_EQ(shown[0].channel, "speed");
    EXPECT_STREQ(shown[0].unit.name, "km/h");
    // 10 m/s rise to 16 m/s after 60 s.
    EXPECT_EQ(shown[0].curves[0].time, (std::vector<double>{0.0, 60.0}));
    EXPECT_EQ(shown[0].curves[0].value, (std::vector<double>{10.0, 16.0}));
    EXPECT_STREQ(shown[1].unit.name, "°C");
    // 27 degC, 22 after 50 s, and 21 after 60 s.
    EXPECT_EQ(shown[1].curves[0].time, (std::vector<double>{0.0, 50.0, 60.0}));
    EXPECT_NEAR(shown[1].unit.value(shown[1].curves[0].value[2]), 21.0, 1e-9);
}

TEST(InputPanels, InputsThatStandStillHaveNone) {
    solver::InputSignals constant;
    constant.add(*physics::find_signal("speed"), 20.0);
    EXPECT_TRUE(changing_inputs(constant, 0.0, 100.0).empty());
}

// Speed, load, pressure and the air's temperature change: four units, of which the first three in the order of the signals are shown,
// and the road's temperature would stand beside the air's.
TEST(InputPanels, NoMoreThanThreeUnitsAreShown) {
    solver::InputSignals many = inputs();
    many.add(series("longitudinal_force", {0.0, 100.0}, {0.0, 500.0}));
    many.add(series("slip_angle", {0.0, 100.0}, {0.0, 0.1}));
    many.add(series("inflation_pressure", {0.0, 100.0}, {2e5, 2.1e5}));
    std::set<std::string> units;
    for (const TimeSeries& one : changing_inputs(many, 0.0, 100.0)) {
        units.insert(one.unit.name);
    }
    EXPECT_EQ(units.size(), 3u);
    EXPECT_TRUE(units.contains("km/h"));
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
