// SPDX-License-Identifier: BSD-3-Clause
// Weighs the change by refinement after the projection that removes the free parameters.

#include "diagnosis/detect/discretisation_error.hpp"

#include "diagnosis/fit/refinement.hpp"

namespace tiretherm::diagnosis {

DiscretisationError estimate_discretisation_error(ScoreTestData& score_data, const input::Experiment* finer) {
    DiscretisationError error{.change = change_by_refinement({.experiment = *score_data.experiment,
                                                              .observations = *score_data.observations,
                                                              .values = score_data.base.values,
                                                              .simulated = score_data.base.simulated,
                                                              .steps = score_data.steps},
                                                             finer)};
    score_data.count(static_cast<long>(score_data.experiment->runs.size()) * (finer != nullptr ? 2 : 1));
    Eigen::MatrixXd whitened = error.change;
    whiten(score_data.observations->blocks, score_data.noise, whitened);
    error.sigma = NuisanceProjector(score_data.base.slopes, score_data.base.precision).project(whitened).norm();
    return error;
}

}  // namespace tiretherm::diagnosis
