// SPDX-License-Identifier: BSD-3-Clause
// What a session's last step would have led to with slightly other inputs at its end, or other numbers in its problem: the tangent
// of one step.
#pragma once

#include <span>

#include "solver/problem.hpp"
#include "solver/status.hpp"
#include "solver/time_integration/session.hpp"

namespace tiretherm::solver {

/// The problem and the inputs at the end of a step, moved from those of the step in one direction.
struct StepNeighbour {
    Problem problem;
    physics::Inputs to;
    double shift = 0.0;  ///< how far, in units of the direction
};

/// Derivatives of the channels at the end of a step in one direction, the state at its begin held: the tangent of its equations.
/// A stage H(T_i) - s q(T_i) = known gives, with x the way in the direction and partial derivatives by differences of the
/// right-hand side alone between two neighbours,
///
///     (C - s dq/dT) S_i = d(known)/dx - dH/dx + s dq/dx        S_i = dT_i/dx
///
/// solved by iteration on the factor that the step has left. The session goes on as if it had not been asked. Allocates.
/// @param slope out, [n_channels] SI per unit of the direction
[[nodiscard]] Status find_step_slopes(const LastStep& step, const StepNeighbour& above, const StepNeighbour& below,
                                      std::span<double> slope);

}  // namespace tiretherm::solver
