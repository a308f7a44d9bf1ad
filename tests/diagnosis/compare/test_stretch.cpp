// SPDX-License-Identifier: BSD-3-Clause
// Mean, maximum and end of a stretch, energies between two times, and the friction power of a run's inputs.

#include "diagnosis/compare/stretch.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "tests/input/measurements/measured_bench.hpp"

namespace tiretherm::diagnosis {
namespace {

// From 0 to 10 along a line, then back to 4: between 5 and 12 the area is 7.5 * 5 + 7 * 2 over 7 s.
TEST(Stretch, MeanIsByTimeAndEndsAreCutOnTheLine) {
    const std::vector<double> time{0.0, 10.0, 12.0};
    const std::vector<double> value{0.0, 10.0, 4.0};
    const StretchValues found = values_between(time, value, 5.0, 12.0);
    EXPECT_NEAR(found.mean, (7.5 * 5.0 + 7.0 * 2.0) / 7.0, 1e-12);
    EXPECT_EQ(found.highest, 10.0);
    EXPECT_EQ(found.end, 4.0);
    EXPECT_NEAR(values_between(time, value, 2.0, 4.0).end, 4.0, 1e-12);
    EXPECT_NEAR(values_between(time, value, 2.0, 4.0).highest, 4.0, 1e-12);
}

// Samples 1, 4 and 3 count alike whatever their times: mean 8/3.
TEST(Stretch, OfSamplesEachCountsAlike) {
    const std::vector<double> samples{1.0, 4.0, 3.0};
    const StretchValues found = values_of(samples);
    EXPECT_NEAR(found.mean, 8.0 / 3.0, 1e-12);
    EXPECT_EQ(found.highest, 4.0);
    EXPECT_EQ(found.end, 3.0);
    EXPECT_TRUE(std::isnan(values_of({}).mean));
}

// Two energies that grow by 100 W and 10 W: between 2 s and 5 s they are 300 J and 30 J.
TEST(Stretch, EnergyIsTheDifferenceOfItsCourse) {
    const EnergyCourse course{
        .names = {"a", "b"}, .time = {0.0, 4.0, 8.0}, .joules = {0.0, 0.0, 400.0, 40.0, 800.0, 80.0}};
    EXPECT_NEAR(course.between(0, 2.0, 5.0), 300.0, 1e-9);
    EXPECT_NEAR(course.between(1, 2.0, 5.0), 30.0, 1e-9);
}

// 1000 N across at 2 degrees, the speed rising from 10 to 30 m/s in 10 s: 1000 N tan(2 deg) times 200 m; 500 N along at
// a slip of 1 % are 500 N * 0.01 * 200 m = 1000 J. The partition of 0.6 takes nothing of either.
TEST(Stretch, FrictionIsWholeWhateverTheTireTakesOfIt) {
    const input::Written written;
    written.add("speed.csv", "time [s],speed [km/h]\n0,36\n10,108\n");
    const input::Reading reading = input::read_case(written.add("slip.toml", std::string(input::bench) + R"(
[drive]
vertical_load = "4000 N"
air_temperature = "20 degC"
road_temperature = "20 degC"
slip_angle = "2 deg"
lateral_force = "-1000 N"
slip_ratio = "1 %"
longitudinal_force = "500 N"
[[drive.file]]
path = "speed.csv"
)"));
    ASSERT_TRUE(reading.problem) << input::render(reading);
    const EnergyCourse friction = friction_energy(*reading.problem);
    ASSERT_EQ(friction.names, (std::vector<std::string>{"along", "across"}));
    EXPECT_NEAR(friction.between(0, 0.0, 10.0), 1000.0, 1e-6);
    EXPECT_NEAR(friction.between(1, 0.0, 10.0), 1000.0 * std::tan(2.0 * std::numbers::pi / 180.0) * 200.0, 1e-6);
}

}  // namespace
}  // namespace tiretherm::diagnosis
