// SPDX-License-Identifier: BSD-3-Clause
// Turns a formula over the time of a run into points that straight lines join: jumps and kinks exactly, the rest as
// close as it takes for the integral to be right.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "input/effects/user_formula.hpp"
#include "solver/input_signals.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::input {

/// A formula at a time: its value, and what it decided on the way.
using FormulaAtTime = std::function<double(double t, solver::JumpSide side, FormulaDecisions& decisions)>;

/// How closely a formula is followed between the knots.
enum class FormulaDetail {
    jumps,     ///< its jumps and kinks alone: what it is made of is known at the knots only, as a log is
    schedule,  ///< all of it; between the knots what it is made of is straight
    time,      ///< all of it; it may turn anywhere, for it has the time itself in it
};

/// A formula over a run as points, and how far they are to be trusted.
struct FormulaSamples {
    solver::SignalHistory history;  ///< finite values alone; two points at one time are a jump
    double undefined = 0.0;         ///< for how long it is not a finite number, s
    double longest_gap = 0.0;       ///< the longest stretch of that, s
    double gap_from = 0.0;          ///< where that begins, s
    bool too_fast = false;          ///< as many points as are allowed do not follow it
};

/// The most points of a formula.
constexpr std::size_t most_formula_points = std::size_t{1} << 20;

/// The integral of the points over the run, taken without sign, deviates from that of the formula by less than this share.
constexpr double formula_accuracy = 1e-4;

/// @param knots s, ascending: the run's start and end, and where the signals of the formula have points. Between two of
///              them the signals are straight; at them they may jump.
/// @param jump_share of the distance of two knots: a jump between them becomes a ramp of this width; 0 for a true jump
[[nodiscard]] FormulaSamples sample_formula(const FormulaAtTime& formula, const std::vector<double>& knots,
                                            FormulaDetail detail, double jump_share);

/// The value of a history at a time: straight between its points and held beyond them; before a jump at the jump.
[[nodiscard]] double value_at(const solver::SignalHistory& history, double t);

}  // namespace tiretherm::input
