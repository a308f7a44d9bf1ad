// SPDX-License-Identifier: BSD-3-Clause
// Compares parameter slopes of predictions with central differences of whole runs over the same steps.
#pragma once

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "solver/sensitivity/prediction.hpp"

/// Slopes of predictions beside differences of runs.
namespace tiretherm::solver {

/// A parameter of an effect that is on.
inline FreeParameter number(const Problem& problem, std::string_view effect, std::string_view key) {
    FreeParameter parameter{.name = std::string(effect) + "." + std::string(key),
                            .unit = {},
                            .layers = {},
                            .knots = {},
                            .nodes = {},
                            .runs = {}};
    for (std::size_t e = 0; e < problem.effects.size(); ++e) {
        if (problem.effects[e].effect->id == effect) {
            parameter.effect = e;
            parameter.parameter = static_cast<std::size_t>(physics::find_parameter(*problem.effects[e].effect, key));
        }
    }
    return parameter;
}

inline FreeParameter law(FreeParameter::Kind kind, std::vector<int> layers, std::vector<double> knots,
                         std::size_t knot) {
    return {.name = "law",
            .unit = {},
            .kind = kind,
            .layers = std::move(layers),
            .knots = std::move(knots),
            .knot = knot,
            .nodes = {},
            .runs = {}};
}

inline FreeParameter start_of(const Problem& problem) {
    FreeParameter parameter{.name = "initial",
                            .unit = "K",
                            .kind = FreeParameter::Kind::initial,
                            .layers = {},
                            .knots = {},
                            .nodes = {},
                            .runs = {}};
    for (int node = 0; node < problem.mesh.n_nodes; ++node) {
        parameter.nodes.push_back(node);
    }
    return parameter;
}

inline std::vector<double> values_of(const Problem& problem, const std::vector<FreeParameter>& numbers) {
    std::vector<double> values;
    values.reserve(numbers.size());
    for (const FreeParameter& one : numbers) {
        values.push_back(value_of(problem, one));
    }
    return values;
}

/// Every slope against the central difference of two runs over the same steps, whose stages are converged to round-off.
/// The difference's own error: (step)^2 times the third derivative and round-off over the step, both below 1e-7 of the
/// largest slope for steps of 1e-4 of a number's size.
inline void expect_differences(Problem problem, const std::vector<FreeParameter>& numbers, double within = 1e-6) {
    std::vector<double> times;
    for (int i = 0; i <= 20; ++i) {
        times.push_back(problem.settings.start + (problem.settings.end - problem.settings.start) * i / 20.0);
    }
    const std::vector<double> values = values_of(problem, numbers);
    const Prediction coarse = predict(problem, {.times = times});
    ASSERT_TRUE(coarse.status.ok()) << coarse.status.message;
    problem.settings.tolerance = 1e-9;
    const Prediction base = predict(
        problem,
        {.times = times, .parameters = numbers, .values = values, .step_ends = coarse.step_ends, .tolerance = 1e-9});
    ASSERT_TRUE(base.status.ok()) << base.status.message;
    for (std::size_t j = 0; j < numbers.size(); ++j) {
        const double step = 3.0 * typical_step(numbers[j], values[j]);
        Problem above = problem;
        Problem below = problem;
        move(above, numbers[j], values[j], values[j] + step);
        move(below, numbers[j], values[j], values[j] - step);
        const Prediction up = predict(above, {.times = times, .step_ends = coarse.step_ends});
        const Prediction down = predict(below, {.times = times, .step_ends = coarse.step_ends});
        ASSERT_TRUE(up.status.ok() && down.status.ok());
        for (std::size_t c = 0; c < base.n_channels; ++c) {
            double largest = 0.0;
            double worst = 0.0;
            for (std::size_t k = 0; k < base.n_times; ++k) {
                const double difference = (up.at(k, c) - down.at(k, c)) / (2.0 * step);
                largest = std::max(largest, std::abs(difference));
                worst = std::max(worst, std::abs(base.slope_at(j, k, c) - difference));
            }
            EXPECT_LE(worst, within * largest + 1e-9 / step * 1e-3)
                << numbers[j].name << " in " << problem.channels[c].name << ", largest " << largest;
        }
    }
}

}  // namespace tiretherm::solver
