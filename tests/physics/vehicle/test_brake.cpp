// SPDX-License-Identifier: BSD-3-Clause
// A brake disc under powers whose courses can be written down.
#include <cmath>

#include <gtest/gtest.h>

#include "physics/vehicle/brake.hpp"

namespace tiretherm::physics {
namespace {

// 8 kW against 40 W/K end 200 K above the air of 300 K, with a time constant of 5000/40 = 125 s, whatever the steps.
TEST(Brake, WarmsUpAsAnExponential) {
    std::vector<double> time;
    for (int i = 0; i <= 100; ++i) {
        time.push_back(0.05 * i * i);
    }
    const std::vector<double> power(time.size(), 8000.0);
    const std::vector<double> air(time.size(), 300.0);
    const std::vector<double> T = brake_temperature({}, time, power, air);
    for (std::size_t i = 0; i < time.size(); ++i) {
        EXPECT_NEAR(T[i], 300.0 + 200.0 * (1.0 - std::exp(-time[i] / 125.0)), 1e-9);
    }
}

// A stop from 100 kW to 0 in 4 s is 200 kJ: without cooling 40 K in 5 kJ/K, with cooling a little less.
TEST(Brake, KeepsTheEnergyOfAStop) {
    const std::vector<double> time{0.0, 4.0, 10.0};
    const std::vector<double> power{100e3, 0.0, 0.0};
    const std::vector<double> air(3, 290.0);
    const std::vector<double> kept = brake_temperature({.cooling = 0.0}, time, power, air);
    EXPECT_NEAR(kept[1], 330.0, 1e-9);
    EXPECT_NEAR(kept[2], 330.0, 1e-9);
    const std::vector<double> cooled = brake_temperature({}, time, power, air);
    EXPECT_LT(cooled[1], 330.0);
    EXPECT_NEAR(cooled[2], 290.0 + (cooled[1] - 290.0) * std::exp(-40.0 * 6.0 / 5000.0), 1e-9);
}

}  // namespace
}  // namespace tiretherm::physics
