#pragma once

#include <Eigen/Core>

#include "diagnosis/detect/score_test_data.hpp"

namespace tiretherm::diagnosis {

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

/// What time steps and grid change in the simulated data.
struct DiscretisationError {
    Eigen::VectorXd change;  ///< [n_rows] SI, to be added to what is simulated: Richardson's extrapolation
    double sigma = 0.0;      ///< of the change, beside what the free numbers take up of it, in standard deviations
};

/// Simulates the fitted model with every step halved and, where a finer grid is given, with half the spacing. Both are of
/// second order: four thirds of what changes is the error.
/// @param finer the experiment on the finer grid, or null
[[nodiscard]] DiscretisationError estimate_discretisation_error(ScoreTestData& score_data,
                                                                const input::Experiment* finer);

}  // namespace tiretherm::diagnosis
