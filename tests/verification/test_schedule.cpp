// SPDX-License-Identifier: BSD-3-Clause
// Steps land exactly on points and jumps of a schedule, and pulses deliver their exact energy.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/laser_strip.hpp"
#include "tests/support/order.hpp"

namespace tiretherm {
namespace {

std::vector<double> step_ends(solver::Problem problem) {
    problem.settings.output_interval = 0.0;
    return support::record(problem).time;
}

TEST(Schedule, JumpsAndPointsAreLandedOnExactly) {
    // The observer sees every step when the output interval is 0. Points of a schedule, jumps of a schedule and jumps
    // of a logged series must be among them, to the last bit, with error control and with fixed steps that do not
    // divide them; samples of the logged series need not be.
    const double third = 100.0 / 3.0;
    for (const double fixed : {0.0, 7.0}) {
        solver::Problem problem = support::laser_strip();
        support::schedule(problem, "laser_power", {0.0, third, third, 200.0, 200.0, 431.7},
                          {1.0, 1.0, 3.0, 3.0, 0.0, 2.0});
        support::Samples road = support::sampled(600.0, 1.0, [](double t) { return 300.0 + std::sin(t); });
        road.time.insert(road.time.begin() + 301, 300.0);  // beside the sample at 300 s: a jump of 5 K
        road.value.insert(road.value.begin() + 301, 305.0);
        support::log(problem, "road_temperature", road.time, road.value);
        if (fixed > 0.0) {
            problem.settings.fixed_step = fixed;
        } else {
            problem.settings.tolerance = 0.5;
        }
        const std::vector<double> ends = step_ends(problem);
        for (const double wanted : {third, 200.0, 300.0, 431.7, 600.0}) {
            EXPECT_TRUE(std::find(ends.begin(), ends.end(), wanted) != ends.end())
                << wanted << " s, fixed step " << fixed;
        }
        EXPECT_LT(ends.size(), 500U);
        EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
    }
}

TEST(Schedule, PulsesDeliverTheirEnergy) {
    // Ten pulses of 2 W for 7 s each: 140 J, whatever the steps, as none crosses an edge. 1e-12 is round-off.
    std::vector<double> time{0.0};
    std::vector<double> power{0.0};
    for (int i = 0; i < 10; ++i) {
        const double on = 30.0 + 50.0 * i;
        time.insert(time.end(), {on, on, on + 7.0, on + 7.0});
        power.insert(power.end(), {0.0, 2.0, 2.0, 0.0});
    }
    for (const double tolerance : {1.0, 1e-2, 1e-4}) {
        solver::Problem problem = support::laser_strip();
        support::schedule(problem, "laser_power", time, power);
        problem.settings.tolerance = tolerance;
        const solver::MarchReport report = support::run_closed(problem);
        support::expect_below("relative_error", report.joules[support::strip::laser] / 140.0 - 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace tiretherm
