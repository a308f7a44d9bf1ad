// SPDX-License-Identifier: BSD-3-Clause
// One step of a fit with the noise held.
#pragma once

#include <Eigen/Core>

#include "diagnosis/fit/refit.hpp"

namespace tiretherm::diagnosis {

/// A step of Gauss and Newton.
struct GaussNewtonStep {
    Eigen::VectorXd by;    ///< [n] in the scales; 0 of numbers that are held at a bound
    double to_gain = 0.0;  ///< in log likelihood twice, as the slopes have it
};

/// The step from where a fit is, by its slopes and what it leaves. @param at in and out: which numbers are held at a bound
[[nodiscard]] GaussNewtonStep gauss_newton_step(const Fit& fit, Refit& at);

}  // namespace tiretherm::diagnosis
