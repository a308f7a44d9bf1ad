// SPDX-License-Identifier: BSD-3-Clause
// Puts points in their places and measures the gaps.
#include "input/effects/formula_points.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::input {

using solver::SignalHistory;

void FormulaPoints::see(double value) {
    if (std::isfinite(value)) {
        largest_ = std::max(largest_, std::abs(value));
    }
}

void FormulaPoints::add(double t, double value) {
    if (!std::isfinite(value) || samples_.too_fast) {
        return;  // a place without a point is no harm: the next point stands for it
    }
    SignalHistory& history = samples_.history;
    samples_.too_fast = history.time.size() >= most_formula_points;
    history.time.push_back(history.time.empty() ? t : std::max(t, history.time.back()));
    history.value.push_back(value);
}

void FormulaPoints::add_place(double t, double value) {
    places_.push_back(samples_.history.time.size());
    add(t, value);
}

void FormulaPoints::add_knot(double t, double value) {
    const SignalHistory& history = samples_.history;
    if (history.time.empty() || history.time.back() != t || history.value.back() != value) {
        add(t, value);
    }
    if (std::isfinite(value)) {
        close_gap(t);
    } else {
        open_gap(t);
    }
}

void FormulaPoints::add_jump(double t, double before, double after, double half) {
    if (std::isfinite(before) && !std::isfinite(after)) {
        add(t, before);
        open_gap(t);
    } else if (!std::isfinite(before) && std::isfinite(after)) {
        close_gap(t);
        add(t, after);
    } else if (std::abs(after - before) <= 1e-9 * largest_) {
        add(t, after);
    } else {
        add(t - half, before);
        add(t + half, after);
    }
}

FormulaSamples FormulaPoints::finished(double end) {
    close_gap(end);
    drop_idle_places();
    return std::move(samples_);
}

void FormulaPoints::open_gap(double t) { gap_since_ = std::min(gap_since_, t); }

void FormulaPoints::close_gap(double t) {
    if (gap_since_ < t) {
        const double gap = t - gap_since_;
        samples_.undefined += gap;
        if (gap > samples_.longest_gap) {
            samples_.longest_gap = gap;
            samples_.gap_from = gap_since_;
        }
    }
    gap_since_ = std::numeric_limits<double>::infinity();
}

void FormulaPoints::drop_idle_places() {
    const SignalHistory& all = samples_.history;
    SignalHistory kept;
    auto place = places_.begin();
    for (std::size_t i = 0; i < all.time.size(); ++i) {
        const bool only_looked_at = place != places_.end() && *place == i;
        place += only_looked_at ? 1 : 0;
        if (only_looked_at && !kept.time.empty() && i + 1 < all.time.size()) {
            const double t0 = kept.time.back();
            const double t1 = all.time[i + 1];
            const double share = t1 > t0 ? (all.time[i] - t0) / (t1 - t0) : 0.0;
            const double line = (1.0 - share) * kept.value.back() + share * all.value[i + 1];
            if (t1 > t0 && std::abs(all.value[i] - line) <= 1e-12 * largest_) {
                continue;
            }
        }
        kept.time.push_back(all.time[i]);
        kept.value.push_back(all.value[i]);
    }
    samples_.history = std::move(kept);
}

}  // namespace tiretherm::input
