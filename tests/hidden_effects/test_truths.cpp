// SPDX-License-Identifier: BSD-3-Clause
// What the truths are driven by and what is added to them: programmes and noise.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "numerics/random_truth.hpp"
#include "two_node/programme_truth.hpp"

namespace hidden_effects {

// Over 2e5 samples at 2 s: variance 1, neighbours correlate by 0.7 0.9^2 = 0.567, those after 10 s by 0.7 0.9^10 =
// 0.244. Standard errors: the correlated part forgets itself over some 20 s, so about 2e4 independent values and 0.01.
TEST(NoiseTruth, HasItsVarianceAndItsMemory) {
    std::vector<double> times;
    for (int i = 0; i < 200000; ++i) {
        times.push_back(2.0 * i);
    }
    Random random(7);
    const std::vector<double> noise = draw_noise({.standard_deviation = 1.0}, times, random);
    const auto covariance = [&](std::size_t lag) {
        double sum = 0.0;
        for (std::size_t i = 0; i + lag < noise.size(); ++i) {
            sum += noise[i] * noise[i + lag];
        }
        return sum / static_cast<double>(noise.size() - lag);
    };
    EXPECT_NEAR(covariance(0), 1.0, 0.03);
    EXPECT_NEAR(covariance(1), 0.567, 0.03);
    EXPECT_NEAR(covariance(5), 0.244, 0.03);
}

// Gaps of 1 and of 9 s in turn: neighbours correlate by 0.7 0.9 = 0.63 and by 0.7 0.9^9 = 0.271.
TEST(NoiseTruth, KeepsItsMemoryOverUnevenTimes) {
    std::vector<double> times;
    for (int i = 0; i < 100000; ++i) {
        times.push_back(10.0 * i);
        times.push_back(10.0 * i + 1.0);
    }
    Random random(8);
    const std::vector<double> noise = draw_noise({.standard_deviation = 1.0}, times, random);
    double near = 0.0;
    double far = 0.0;
    for (std::size_t i = 0; i + 2 < noise.size(); i += 2) {
        near += noise[i] * noise[i + 1] / 1e5;
        far += noise[i + 1] * noise[i + 2] / 1e5;
    }
    EXPECT_NEAR(near, 0.63, 0.03);
    EXPECT_NEAR(far, 0.271, 0.03);
}

// A programme starts with a minute at rest, moves, slips and never leaves what the model is made for.
TEST(ProgrammeTruth, IsAProgramme) {
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Programme programme = draw_programme(seed);
        ASSERT_EQ(programme.time.size(), 1201U);
        for (std::size_t i = 0; i <= 30; ++i) {
            EXPECT_EQ(programme.speed[i], 0.0);
        }
        const auto [least, most] = std::minmax_element(programme.speed.begin(), programme.speed.end());
        EXPECT_GE(*least, 0.0);
        EXPECT_GT(*most, 30.0 / 3.6);
        EXPECT_LE(*most, 190.0 / 3.6 + 1e-9);
        for (std::size_t i = 0; i < programme.time.size(); ++i) {
            EXPECT_LE(programme.slip_angle[i] * programme.lateral_force[i], 0.0);
            EXPECT_LE(std::abs(programme.lateral_force[i]), 1.06 * programme.vertical_load[i]);
            EXPECT_GE(programme.throttle[i], 0.0);
            EXPECT_LE(programme.throttle[i], 1.0);
        }
    }
    EXPECT_EQ(draw_programme(5).speed, draw_programme(5).speed);
    EXPECT_NE(draw_programme(5).speed, draw_programme(6).speed);
    const Programme dull = draw_dull_programme(5);
    EXPECT_EQ(dull.speed.front(), dull.speed.back());
    EXPECT_EQ(dull.vertical_load.front(), dull.vertical_load.back());
}

}  // namespace hidden_effects
