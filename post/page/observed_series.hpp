// SPDX-License-Identifier: BSD-3-Clause
// The observations of a fit or a diagnosis as series for a chart.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "diagnosis/observations/observations.hpp"
#include "input/measurements/experiment.hpp"
#include "post/page/measured_chart.hpp"

namespace tiretherm::post {

/// Channels of each run with what the models say; pixels of cameras are left out.
/// @param models name and simulated values [n_rows] SI
[[nodiscard]] std::vector<MeasuredSeries> observed_series(
    const input::Experiment& experiment, const diagnosis::Observations& observations,
    const std::vector<std::pair<std::string, const Eigen::VectorXd*>>& models);

}  // namespace tiretherm::post
