// SPDX-License-Identifier: BSD-3-Clause
// The adjoint equals the transpose of the tangent run, (S h, w) = (h, S' w), and agrees with slopes of a heat source.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "solver/sensitivity/adjoint_record.hpp"
#include "tests/support/threads.hpp"
#include "tests/support/tire_section.hpp"

namespace tiretherm::solver {

namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::vector<double> random_numbers(std::size_t n, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double> numbers(n);
    for (double& number : numbers) {
        number = normal(generator);
    }
    return numbers;
}

/// A section whose loss follows the mean of its bulk, k its temperature and the film that of the surface: an unsymmetric
/// Jacobian with outer products. A probe lags, another's clock is late.
Problem tire() {
    Problem problem = support::tire_problem(1);
    problem.materials[0].conductivity.fill(physics::Curve::quadratic_about(293.15, 0.29, 0.005, 1e-5));
    for (const mesh::Region& region : problem.mesh.regions) {
        support::read(problem, region.name, region.mean);
    }
    support::switch_on(problem, "sensor_lag", {{"tau", 15.0}});
    problem.effects.back().channels = {1};
    support::switch_on(problem, "clock_delay", {{"delay", 7.0}});
    problem.effects.back().channels = {0};
    support::switch_on(problem, "clock_rate", {{"rate", 0.02}});
    problem.effects.back().channels = {0};
    problem.settings.end = 300.0;
    return problem;
}

/// One course of heat. @param heat [n_steps][n_nodes] W
std::vector<double> forward(AdjointRecord& record, const std::vector<double>& heat) {
    return record.forward(1, [&](std::size_t step, std::span<double> of_step) {
        std::ranges::copy(std::span(heat).subspan(step * record.n_nodes(), record.n_nodes()), of_step.begin());
    });
}

/// @param weights [n_times][n_channels]  @returns [n_steps][n_nodes]
std::vector<double> backward(AdjointRecord& record, const std::vector<double>& weights) {
    std::vector<double> slopes(record.n_steps() * record.n_nodes());
    record.backward(1, weights, [&](std::size_t step, std::span<const double> of_step) {
        std::ranges::copy(of_step, slopes.begin() + static_cast<std::ptrdiff_t>(step * record.n_nodes()));
    });
    return slopes;
}

std::vector<double> every(double interval, double end) {
    std::vector<double> times;
    for (int i = 0; i * interval <= end; ++i) {
        times.push_back(i * interval);
    }
    return times;
}

}  // namespace

// (S h, w) = (h, S' w) for random heat h and weights w: the definition of the adjoint. Both sides are sums of some 1e4
// products of size one times sensitivities; round-off of the linear solutions, 1e-13, is all that may differ.
TEST(AdjointRecord, BackwardsIsTheTransposedOfForwards) {
    const Problem problem = tire();
    const std::vector<double> times = every(10.0, 300.0);
    const Prediction run = predict(problem, {.times = times});
    ASSERT_TRUE(run.status.ok()) << run.status.message;
    AdjointRecord record(problem, times, run.step_ends);
    ASSERT_TRUE(record.status().ok()) << record.status().message;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        const std::vector<double> heat = random_numbers(record.n_steps() * record.n_nodes(), seed);
        const std::vector<double> weights = random_numbers(times.size() * problem.channels.size(), 100 + seed);
        const std::vector<double> answer = forward(record, heat);
        const std::vector<double> slopes = backward(record, weights);
        const double size = std::sqrt(dot(answer, answer) * dot(weights, weights));
        EXPECT_GT(size, 0.0);
        EXPECT_NEAR(dot(answer, weights), dot(heat, slopes), 1e-10 * size) << "seed " << seed;
    }
}

// Ten courses side by side, of sizes eleven decades apart, one of them nothing, and the last two from the middle of the run on,
// answer as each by itself: more than fit side by side in a panel.
TEST(AdjointRecord, CoursesOfHeatDoNotMix) {
    const Problem problem = tire();
    const std::vector<double> times = every(10.0, 300.0);
    const Prediction run = predict(problem, {.times = times});
    AdjointRecord record(problem, times, run.step_ends);
    ASSERT_TRUE(record.status().ok()) << record.status().message;
    std::vector<std::vector<double>> heats;
    for (const double size : {1e-5, 1e6, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}) {
        heats.push_back(random_numbers(record.n_steps() * record.n_nodes(), 7));
        for (double& watts : heats.back()) {
            watts *= size;
        }
    }
    std::ranges::reverse(heats[1]);
    for (std::vector<double>* late : {&heats[8], &heats[9]}) {
        std::fill_n(late->begin(), record.n_steps() / 2 * record.n_nodes(), 0.0);
    }
    const std::vector<double> together = record.forward(heats.size(), [&](std::size_t step, std::span<double> of_step) {
        for (std::size_t h = 0; h < heats.size(); ++h) {
            std::copy_n(heats[h].begin() + static_cast<std::ptrdiff_t>(step * record.n_nodes()), record.n_nodes(),
                        of_step.begin() + static_cast<std::ptrdiff_t>(h * record.n_nodes()));
        }
    });
    const std::size_t n = times.size() * problem.channels.size();
    for (std::size_t h = 0; h < heats.size(); ++h) {
        const std::vector<double> alone = forward(record, heats[h]);
        const double size = std::sqrt(dot(alone, alone));
        for (std::size_t i = 0; i < n; ++i) {
            EXPECT_NEAR(together[h * n + i], alone[i], 1e-10 * size) << "course " << h << ", reading " << i;
        }
    }
}

// Two hundred courses, which several threads share: a sixth of them begins at each sixth of the run. They have the same digits on
// any number of threads, and each answers as by itself.
TEST(AdjointRecord, ManyCoursesHaveTheSameDigitsForAnyNumberOfThreads) {
    constexpr std::size_t many = 200;
    const Problem problem = tire();
    const std::vector<double> times = every(30.0, 300.0);
    const Prediction run = predict(problem, {.times = times});
    AdjointRecord record(problem, times, run.step_ends);
    ASSERT_TRUE(record.status().ok()) << record.status().message;
    const std::vector<double> watts = random_numbers(many * record.n_nodes(), 3);
    const auto take_course = [&](std::size_t h, std::size_t step, std::span<double> of_step) {
        const bool has_begun = step >= h * 6 / many * record.n_steps() / 6;
        for (std::size_t i = 0; i < of_step.size(); ++i) {
            of_step[i] = has_begun ? watts[h * of_step.size() + i] : 0.0;
        }
    };
    std::vector<std::vector<double>> answers;
    for (const int threads : {1, 2, 3}) {
        const support::Threads now(threads);
        answers.push_back(record.forward(many, [&](std::size_t step, std::span<double> heat) {
            for (std::size_t h = 0; h < many; ++h) {
                take_course(h, step, heat.subspan(h * record.n_nodes(), record.n_nodes()));
            }
        }));
    }
    ASSERT_TRUE(record.status().ok()) << record.status().message;
    EXPECT_EQ(answers[1], answers[0]);
    EXPECT_EQ(answers[2], answers[0]);
    const std::size_t n = times.size() * problem.channels.size();
    for (const std::size_t h : {std::size_t{0}, many / 2 - 1, many - 1}) {
        const std::vector<double> alone =
            record.forward(1, [&](std::size_t step, std::span<double> of_step) { take_course(h, step, of_step); });
        const double length = std::sqrt(dot(alone, alone));
        EXPECT_GT(length, 0.0);
        for (std::size_t i = 0; i < n; ++i) {
            EXPECT_NEAR(answers[0][h * n + i], alone[i], 1e-10 * length) << "course " << h << ", reading " << i;
        }
    }
}

// What a uniform source makes of one watt in the whole mesh, from the slopes of a prediction with its power density,
// equals the forward answer to that heat on every step: two codes for one derivative.
TEST(AdjointRecord, ForwardsEqualsTheSlopeOfASource) {
    Problem problem = tire();
    support::switch_on(problem, "uniform_source", {{"power_density", 100.0}});
    FreeParameter power{.name = "power",
                        .unit = "W m-3",
                        .effect = problem.effects.size() - 1,
                        .layers = {},
                        .knots = {},
                        .nodes = {},
                        .runs = {}};
    const std::vector<double> times = every(10.0, 300.0);
    const std::vector<FreeParameter> numbers{power};
    const std::vector<double> values{100.0};
    problem.settings.tolerance = 1e-7;  // of Newton's corrections too
    const std::vector<double> ends = every(5.0, 300.0);
    const Prediction run = predict(problem, {.times = times,
                                             .parameters = numbers,
                                             .values = values,
                                             .step_ends = std::span(ends).subspan(1),
                                             .tolerance = 1e-10});
    ASSERT_TRUE(run.status.ok()) << run.status.message;
    AdjointRecord record(problem, times, run.step_ends);
    ASSERT_TRUE(record.status().ok()) << record.status().message;
    std::vector<double> heat(record.n_steps() * record.n_nodes());
    for (std::size_t i = 0; i < heat.size(); ++i) {
        const std::size_t node = i % record.n_nodes();
        heat[i] = node < static_cast<std::size_t>(problem.mesh.n_cells) ? problem.mesh.volume[node] : 0.0;
    }
    const std::vector<double> answer = forward(record, heat);
    double largest = 0.0;
    for (const double value : answer) {
        largest = std::max(largest, std::abs(value));
    }
    for (std::size_t k = 0; k < times.size(); ++k) {
        for (std::size_t c = 0; c < problem.channels.size(); ++c) {
            EXPECT_NEAR(answer[k * problem.channels.size() + c], run.slope_at(0, k, c), 1e-7 * largest)
                << "channel " << problem.channels[c].name << " at " << times[k] << " s";
        }
    }
}

}  // namespace tiretherm::solver
