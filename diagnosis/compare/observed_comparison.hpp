// SPDX-License-Identifier: BSD-3-Clause
// What a fit or a diagnosis leaves, with the figures of compare.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "diagnosis/compare/comparison.hpp"
#include "diagnosis/observations/observations.hpp"

namespace tiretherm::diagnosis {

/// Measured beside simulated, channel by channel with the figures of compare: by run, phase, signal, corner and lap. Camera images
/// and single numbers are no channels.
/// @param simulated [n_rows of the observations] SI
[[nodiscard]] std::vector<ComparedChannel> compare_observed(const input::Experiment& experiment,
                                                            const Observations& observations,
                                                            const Eigen::VectorXd& simulated);

}  // namespace tiretherm::diagnosis
