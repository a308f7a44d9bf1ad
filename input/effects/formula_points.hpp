// SPDX-License-Identifier: BSD-3-Clause
// The points that stand for a formula, with jumps between them and stretches over which it has no value.
#pragma once

#include <limits>
#include <vector>

#include "input/effects/formula_sampling.hpp"

namespace tiretherm::input {

/// Collects the points of a formula in the order of their times. Values that are not finite make no points but gaps.
class FormulaPoints {
public:
    /// A value of the formula that was looked at, whether it becomes a point or not.
    void see(double value);
    /// The largest of these without sign.
    [[nodiscard]] double largest() const { return largest_; }

    void add(double t, double value);
    /// A point that is only looked at: it goes at the end if it is on the straight line between its neighbours.
    void add_place(double t, double value);
    /// At a knot a formula may begin or cease to have a value.
    void add_knot(double t, double value);
    /// @param t s, just after it  @param half s, half the width of the ramp that stands for it
    void add_jump(double t, double before, double after, double half);

    /// As many points as are allowed are not enough.
    void give_up() { samples_.too_fast = true; }
    [[nodiscard]] bool is_given_up() const { return samples_.too_fast; }

    /// The points of the whole run, which ends here. @param end s
    [[nodiscard]] FormulaSamples finished(double end);

private:
    void open_gap(double t);
    void close_gap(double t);
    void drop_idle_places();

    FormulaSamples samples_;
    std::vector<std::size_t> places_;  ///< indices into the history, ascending
    double largest_ = 0.0;
    double gap_since_ = std::numeric_limits<double>::infinity();
};

}  // namespace tiretherm::input
