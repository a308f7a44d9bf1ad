// SPDX-License-Identifier: BSD-3-Clause
// Discretisation error of a fitted model by Richardson's extrapolation, from halved time steps and half the grid
// spacing.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/observations/observations.hpp"
#include "input/measurements/experiment.hpp"

namespace tiretherm::diagnosis {

/// The experiment as it stands at some values, with nothing free: what is simulated of it needs no sensitivities.
/// @param numbers of the same experiment
[[nodiscard]] input::Experiment frozen_at(const input::Experiment& experiment, const Simulator& numbers,
                                          const Eigen::VectorXd& values);

/// A model at the values that a fit has come to.
struct Model {
    const input::Experiment& experiment;
    const Observations& observations;
    const Eigen::VectorXd& values;     ///< [n_parameters]
    const Eigen::VectorXd& simulated;  ///< [n_rows] SI, at these values
    const std::vector<std::vector<double>>& steps;
};
/// What steps of half the width, and a grid of half the spacing, would change of what is simulated, carried on to the
/// limit of both.
/// @param finer the experiment on that grid; null: the steps alone  @returns [n_rows] SI
[[nodiscard]] Eigen::VectorXd change_by_refinement(const Model& model, const input::Experiment* finer);

/// The largest change of each observed channel but of cameras. @param change [n_rows] SI
/// @returns [n_noises of the observations] SI
[[nodiscard]] std::vector<double> largest_changes(const Observations& observations, const Eigen::VectorXd& change);

/// By how much the error of grid and steps moves what a case as it stands simulates at the samples.
struct GridError {
    std::size_t channel = 0;  ///< index into Problem::channels
    double largest = 0.0;     ///< SI
};
/// Of each channel that was measured; none where a simulation fails. @param finer the experiment on a grid of half the spacing
[[nodiscard]] std::vector<GridError> grid_errors(const input::Experiment& experiment, const input::Experiment& finer);

}  // namespace tiretherm::diagnosis
