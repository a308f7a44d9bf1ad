// SPDX-License-Identifier: BSD-3-Clause
// What a run spends on its step lengths: factors and solves of a linear balance, and error estimates over a rough log.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {
namespace {

struct Stepped {
    MarchReport report;
    std::vector<double> ends{0.0};  ///< s
    std::vector<double> lengths;    ///< s
};

Stepped step_by_step(const Problem& problem) {
    Stepped result;
    result.report = run(problem, [&](const Snapshot& now) {
        if (now.time > result.ends.back()) {
            result.lengths.push_back(now.time - result.ends.back());
            result.ends.push_back(now.time);
        }
        return true;
    });
    EXPECT_TRUE(result.report.status.ok()) << result.report.status.message;
    return result;
}

/// Lengths that differ by more than round-off, from the shortest on.
std::vector<double> different(std::vector<double> lengths) {
    std::ranges::sort(lengths);
    const auto alike = [](double a, double b) { return b - a < 1e-9 * b; };
    lengths.erase(std::unique(lengths.begin(), lengths.end(), alike), lengths.end());
    return lengths;
}

/// Whether each is a power of two times the shortest.
void expect_powers_of_two(const std::vector<double>& lengths) {
    for (const double length : lengths) {
        const double doublings = std::log2(length / lengths.front());
        EXPECT_NEAR(doublings, std::round(doublings), 1e-9) << length;
    }
}

TEST(StepLengths, OfALinearBalanceAreDoubledSoThatEachHasItsFactor) {
    const Stepped run = step_by_step(heated_strip(40));
    const std::vector<double> lengths = different(run.lengths);
    expect_powers_of_two(lengths);
    EXPECT_EQ(run.report.factorisations, static_cast<long>(lengths.size()));
    EXPECT_LE(lengths.size(), 6U);
    // A stage takes one solve. The last step closes its heat budget; some errors are known without a solve.
    EXPECT_EQ(run.report.newton_iterations, 2 * (run.report.steps + run.report.rejected));
    EXPECT_LT(run.report.linear_iterations, 3 * (run.report.steps + run.report.rejected));
    EXPECT_DOUBLE_EQ(run.ends.back(), 1000.0);
}

TEST(StepLengths, WholeStepsLeadToEachStop) {
    // Without a jump, so that the length that was wanted before the short piece is wanted behind it.
    Problem problem = heated_strip(40);
    problem.input_signals.add(
        {.signal = physics::find_signal("speed"), .time = {0.0, 500.0, 501.0, 1000.0}, .value = {0.0, 1.0, 0.0, 1.0}});
    const Stepped run = step_by_step(problem);
    std::vector<double> before;
    std::vector<double> behind;
    for (std::size_t i = 0; i < run.lengths.size(); ++i) {
        if (run.ends[i + 1] <= 500.0) {
            before.push_back(run.lengths[i]);
        } else if (run.ends[i] >= 501.0) {
            behind.push_back(run.lengths[i]);
        }
    }
    EXPECT_EQ(std::ranges::count(run.ends, 500.0), 1);
    EXPECT_EQ(std::ranges::count(run.ends, 501.0), 1);
    ASSERT_FALSE(before.empty() || behind.empty());
    expect_powers_of_two(different(before));
    expect_powers_of_two(different(behind));
    EXPECT_GT(behind.front(), 0.49 * before.back());
}

TEST(StepLengths, LargestStepHolds) {
    Problem problem = heated_strip(40);
    problem.settings.largest_step = 30.0;
    const Stepped run = step_by_step(problem);
    EXPECT_LE(std::ranges::max(run.lengths), 30.0);
    expect_powers_of_two(different(run.lengths));
}

TEST(StepLengths, OfABalanceThatIsNotLinearAreAsTheErrorAsks) {
    Problem problem = heated_strip(40);
    problem.materials = {material(physics::Curve::quadratic_about(293.15, 0.29, 0.002, 0.0))};
    problem.settings.tolerance = 1e-3;
    EXPECT_GT(different(step_by_step(problem).lengths).size(), 8U);
}

TEST(StepLengths, WhereALogLetsNoneGrowABoundOfTheErrorIsEnough) {
    // A load that differs by a fifth from one second to the next.
    Problem problem = two_node_tire();
    std::vector<double> time;
    std::vector<double> load;
    for (int i = 0; i <= 600; ++i) {
        time.push_back(i);
        load.push_back(4000.0 + (i % 2 == 0 ? 400.0 : -400.0) * (1.0 + (i % 7) / 7.0));
    }
    problem.input_signals = {};
    hold(problem, "speed", 100.0 / 3.6);
    hold(problem, "air_temperature", 296.15);
    hold(problem, "road_temperature", 296.15);
    problem.input_signals.add(
        {.signal = physics::find_signal("vertical_load"), .time = time, .value = load, .logged = true});
    problem.settings.tolerance = 0.002;
    const MarchReport report = step_by_step(problem).report;
    EXPECT_GT(report.rejected, 20);
    // Beside the corrections: one solve for each error that is filtered.
    EXPECT_LT(report.linear_iterations - report.newton_iterations, report.steps * 2 / 3);
}

}  // namespace
}  // namespace tiretherm::solver
