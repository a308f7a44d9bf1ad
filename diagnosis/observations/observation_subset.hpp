// SPDX-License-Identifier: BSD-3-Clause
// Some rows of the measured values as observations of their own, to fit a part of the data and predict the rest.
#pragma once

#include <vector>

#include "diagnosis/observations/observations.hpp"

namespace tiretherm::diagnosis {

/// Some rows of the data.
using RowIndices = std::vector<Eigen::Index>;

/// These rows alone, with the same runs, channels and noises; a run without rows is not simulated.
/// @param rows ascending, of an experiment without images
[[nodiscard]] Observations subset(const Observations& observations, const RowIndices& rows);

/// The weights of a covariance for these rows; its channels stay.
[[nodiscard]] Covariance subset(const Covariance& covariance, const RowIndices& rows);

}  // namespace tiretherm::diagnosis
