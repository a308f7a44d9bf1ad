// SPDX-License-Identifier: BSD-3-Clause
// Speeds and loads beyond those at which the laws were compared with measurements.
#include "solver/compared_ranges.hpp"

#include <gtest/gtest.h>

#include "support/tire_section.hpp"

namespace tiretherm::solver {

namespace {

std::vector<std::string> said(const std::vector<double>& kmh, double load) {
    Problem problem = support::tire_problem(1);
    problem.input_signals = {};
    std::vector<double> time;
    std::vector<double> speed;
    for (const double one : kmh) {
        time.push_back(60.0 * static_cast<double>(time.size()));
        speed.push_back(one / 3.6);
    }
    problem.settings.end = time.back();
    support::schedule(problem, "speed", time, speed);
    support::hold(problem, "vertical_load", load);
    std::vector<std::string> sentences;
    for (const BeyondCompared& law : beyond_compared(problem)) {
        sentences.push_back(std::string(law.effect) + ": " + law.text());
    }
    return sentences;
}

}  // namespace

// The loss was compared at 40 to 150 km/h and 3 to 8 kN. A test that begins at rest is judged by its highest speed.
TEST(ComparedRanges, ATestBeyondTheLawsSpeedIsTold) {
    EXPECT_TRUE(said({0.0, 150.0, 150.0}, 4000.0).empty());
    EXPECT_EQ(said({0.0, 150.0, 260.0, 0.0}, 4000.0),
              std::vector<std::string>{"strain_energy_loss: compared up to 150 km/h, this test goes to 260"});
    EXPECT_EQ(said({0.0, 100.0}, 900.0),
              std::vector<std::string>{"strain_energy_loss: compared from 3 kN on, this test stays below 0.9"});
    EXPECT_EQ(said({0.0, 20.0}, 4000.0).size(), 1U);
}

}  // namespace tiretherm::solver
