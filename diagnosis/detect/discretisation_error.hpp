// SPDX-License-Identifier: BSD-3-Clause
// Error of time steps and grid in the simulated data, by Richardson's extrapolation, and its size in standard
// deviations of the noise.
#pragma once

#include <Eigen/Core>

#include "diagnosis/detect/score_test_data.hpp"

namespace tiretherm::diagnosis {

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
