// SPDX-License-Identifier: BSD-3-Clause
// Values of the channels at requested times and, on request, their derivatives with respect to free parameters.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/problem.hpp"
#include "solver/sensitivity/free_parameter.hpp"
#include "solver/status.hpp"

namespace tiretherm::solver {

/// What is asked of a run.
struct PredictionRequest {
    std::span<const double> times;                ///< s, ascending, within the run: when the channels are read
    std::span<const FreeParameter> parameters{};  ///< with respect to which derivatives are wanted
    std::span<const double> values{};             ///< [n_parameters] that the problem has now
    /// The steps to take, by their ends; empty: as the error control chooses. Runs of neighbouring problems that share
    /// their steps differ smoothly.
    std::span<const double> step_ends{};
    double tolerance = 1e-6;  ///< of the sensitivities' linear systems, relative to the largest sensitivity
};

/// What the sensors of a run give, and how that follows its parameters.
struct Prediction {
    Status status;
    std::size_t n_times = 0;
    std::size_t n_channels = 0;
    std::vector<double> value;      ///< [n_times][n_channels] SI
    std::vector<double> slope;      ///< [n_parameters][n_times][n_channels] SI per unit of the parameter
    std::vector<double> step_ends;  ///< s: the steps taken
    /// [n_steps][n_effects] J since the start, not scaled by symmetry; empty where the steps were given or kept
    std::vector<double> joules{};
    std::vector<std::string>
        non_smooth_parameters;  ///< parameters at a switch or a clamp, where the slope is that of one side

    [[nodiscard]] double at(std::size_t time, std::size_t channel) const { return value[time * n_channels + channel]; }
    [[nodiscard]] double slope_at(std::size_t parameter, std::size_t time, std::size_t channel) const {
        return slope[(parameter * n_times + time) * n_channels + channel];
    }
};

/// Runs a problem and reads its channels at the times asked for. A steady problem is solved once and read at every time.
[[nodiscard]] Prediction predict(const Problem& problem, const PredictionRequest& request);

}  // namespace tiretherm::solver
