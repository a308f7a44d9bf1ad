// SPDX-License-Identifier: BSD-3-Clause
// Bisects to the times at which a formula decides otherwise (a comparison, a sign, finite or not), halves the pieces
// between them until straight lines follow, and looks at places of its own whether something was missed.

#include "input/effects/formula_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "input/effects/formula_points.hpp"

namespace tiretherm::input {

namespace {

using solver::JumpSide;
using solver::SignalHistory;

constexpr int quiet_pieces = 8;     // between two knots where only schedules are followed
constexpr int first_pieces = 4096;  // over the run where the time itself is followed
constexpr int denser = 8;           // by so much where that missed something
constexpr int attempts = 3;
constexpr int most_rounds = 6;           // of a tighter tolerance, until the integral is right
constexpr int deepest = 1000;            // calls within one another: halving takes 40, a switch after another the rest
constexpr int probes = 2039;             // a prime; places at which the result is looked at
constexpr int dip_steps = 30;            // of the golden section that looks for a margin's zero
constexpr double margin_of_place = 0.5;  // beyond the ends, as a parabola's vertex is not quite that of the margin
constexpr double value_accuracy = 1e-3;  // of the largest value
// The most irrational of numbers: steps of it fall into no period that a formula may have.
constexpr double golden = 0.618033988749894848;

struct Sample {
    double t = 0.0;
    double value = 0.0;
    FormulaDecisions decisions;

    [[nodiscard]] bool finite() const { return std::isfinite(value); }
    [[nodiscard]] bool decides_as(const Sample& other) const { return decisions.taken == other.decisions.taken; }
};

/// Counts calls within one another.
class Level {
public:
    explicit Level(int& depth) : depth_(depth) { ++depth_; }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

private:
    int& depth_;
};

/// One attempt with one density and one tolerance.
class Sampling {
public:
    Sampling(const FormulaAtTime& formula, FormulaDetail detail, double jump_share, double tolerance)
        : formula_(&formula), detail_(detail), jump_share_(jump_share), tolerance_(tolerance) {}

    /// @param places between the knots, ascending
    void follow(double from, double to, const std::vector<double>& places) {
        width_ = to - from;
        Sample left = at(from, JumpSide::after);
        points_.add_knot(left.t, left.value);
        for (const double place : places) {
            Sample right = at(place, JumpSide::before);
            piece(left, right);
            points_.add_place(right.t, right.value);
            left = std::move(right);
        }
        const Sample right = at(to, JumpSide::before);
        piece(left, right);
        points_.add_knot(right.t, right.value);
    }

    [[nodiscard]] FormulaPoints& points() { return points_; }
    [[nodiscard]] bool integral_is_right() const { return deviation_ <= formula_accuracy * integral_; }

private:
    Sample at(double t, JumpSide side = JumpSide::before) {
        Sample sample{.t = t, .value = 0.0, .decisions = {}};
        sample.value = (*formula_)(t, side, sample.decisions);
        points_.see(sample.value);
        return sample;
    }

    /// Points inside of (left, right), whatever happens there.
    void piece(Sample left, const Sample& right) {
        while (!left.decides_as(right) && !points_.is_given_up()) {
            Sample before = left;
            Sample after = right;
            // Two times that are closer have no number between them.
            const double resolution =
                4.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(left.t), std::abs(right.t));
            while (after.t - before.t > resolution) {
                Sample middle = at(0.5 * (before.t + after.t));
                (middle.decides_as(before) ? before : after) = std::move(middle);
            }
            smooth(left, before);
            points_.add_jump(after.t, before.value, after.value, 0.5 * jump_share_ * width_);
            left = std::move(after);
        }
        smooth(left, right);
    }

    /// A place between two samples that decide the same at which a comparison comes out otherwise, if a margin's course
    /// over three samples suggests that it goes there and back.
    std::optional<Sample> hidden_switch(const Sample& left, const Sample& middle, const Sample& right) {
        for (std::size_t i = 0; i < left.decisions.margins.size(); ++i) {
            const double a = left.decisions.margins[i];
            const double b = middle.decisions.margins[i];
            const double c = right.decisions.margins[i];
            const double curvature = a + c - 2.0 * b;
            const double place = 0.5 + 0.25 * (a - c) / curvature;
            if (!(place > -margin_of_place && place < 1.0 + margin_of_place) || a * b <= 0.0 || curvature * a <= 0.0) {
                continue;
            }
            const double slope = 4.0 * b - 3.0 * a - c;
            const double lowest = a + place * (slope + 2.0 * place * curvature);
            if (lowest * a > 0.3 * std::max(std::abs(a), std::abs(c)) * std::abs(a)) {
                continue;
            }
            if (std::optional<Sample> found = search(left, right, i)) {
                return found;
            }
        }
        return std::nullopt;
    }

    /// Golden section for the smallest distance of one decision from another result.
    std::optional<Sample> search(const Sample& left, const Sample& right, std::size_t margin) {
        double from = left.t;
        double to = right.t;
        Sample low = at(to - golden * (to - from));
        Sample high = at(from + golden * (to - from));
        for (int i = 0; i < dip_steps; ++i) {
            for (Sample* sample : {&low, &high}) {
                if (!sample->decides_as(left)) {
                    return std::move(*sample);
                }
            }
            const bool left_is_closer =
                std::abs(low.decisions.margins[margin]) < std::abs(high.decisions.margins[margin]);
            (left_is_closer ? to : from) = left_is_closer ? high.t : low.t;
            (left_is_closer ? high : low) = std::move(left_is_closer ? low : high);
            (left_is_closer ? low : high) =
                at(left_is_closer ? to - golden * (to - from) : from + golden * (to - from));
        }
        return std::nullopt;
    }

    /// Points inside of (left, right), whose ends decide the same.
    void smooth(const Sample& left, const Sample& right) {
        const double width = right.t - left.t;
        const Level level(depth_);
        if (points_.is_given_up() || depth_ > deepest) {
            points_.give_up();
            return;
        }
        // Towards t = 0 numbers get finer without end: there the distance of the knots is the measure.
        if (width <= std::max(1e-12 * std::max(std::abs(left.t), std::abs(right.t)), 1e-15 * width_)) {
            deviation_ += detail_ == FormulaDetail::jumps ? 0.0 : width * std::abs(right.value - left.value);
            return;
        }
        const Sample middle = at(0.5 * (left.t + right.t));
        if (!middle.decides_as(left)) {
            split(left, middle, right);
            return;
        }
        if (const std::optional<Sample> hidden = hidden_switch(left, middle, right)) {
            split(left, *hidden, right);
            return;
        }
        if (detail_ == FormulaDetail::jumps || !left.finite()) {
            return;
        }
        const double first = at(left.t + 0.25 * width).value;
        const double third = at(left.t + 0.75 * width).value;
        const double bend = std::max({std::abs(first - 0.75 * left.value - 0.25 * right.value),
                                      std::abs(middle.value - 0.5 * left.value - 0.5 * right.value),
                                      std::abs(third - 0.25 * left.value - 0.75 * right.value)});
        const double error = std::max(std::abs(first - 0.5 * left.value - 0.5 * middle.value),
                                      std::abs(third - 0.5 * middle.value - 0.5 * right.value));
        if (!(error <= tolerance_)) {
            smooth(left, middle);
            points_.add(middle.t, middle.value);
            smooth(middle, right);
            return;
        }
        // Boole's rule tells the mean; the point in the middle is placed so that the two straight lines have it, too.
        const double two_lines = 0.25 * left.value + 0.5 * middle.value + 0.25 * right.value;
        const double simpson = left.value / 6.0 + middle.value * 2.0 / 3.0 + right.value / 6.0;
        const double boole =
            (left.value + right.value) * (7.0 / 90.0) + (first + third) * (32.0 / 90.0) + middle.value * (12.0 / 90.0);
        if (bend > 1e-12 * points_.largest()) {
            points_.add(middle.t, middle.value + 2.0 * (boole - two_lines));
        }
        deviation_ += width * std::abs(boole - simpson);
        integral_ += 0.5 * width * std::abs(left.value) + 0.5 * width * std::abs(right.value);
    }

    void split(const Sample& left, const Sample& middle, const Sample& right) {
        piece(left, middle);
        points_.add(middle.t, middle.value);
        piece(middle, right);
    }

    const FormulaAtTime* formula_;
    FormulaDetail detail_;
    double jump_share_;
    double tolerance_;
    double width_ = 0.0;
    int depth_ = 0;  ///< calls of smooth() within one another
    double deviation_ = 0.0;
    double integral_ = 0.0;
    FormulaPoints points_;
};

/// Places between two knots, at distances that no period of the formula fits.
std::vector<double> places_between(double from, double to, int pieces) {
    std::vector<double> places;
    for (int i = 1; i < pieces; ++i) {
        const double shift = std::fmod(golden * i, 1.0) - 0.5;
        places.push_back(from + (to - from) * (i + 0.6 * shift) / pieces);
    }
    return places;
}

class SamplingAttempt {
public:
    SamplingAttempt(const FormulaAtTime& formula, const std::vector<double>& knots, FormulaDetail detail,
                    double jump_share)
        : formula_(&formula), knots_(&knots), detail_(detail), jump_share_(jump_share) {}

    /// The tolerance is that of the values first, then what the integral takes.
    FormulaSamples with_pieces(int pieces_over_run) const {
        double tolerance =
            value_accuracy * run(std::numeric_limits<double>::infinity(), pieces_over_run).points().largest();
        for (int round = 0;; ++round) {
            Sampling sampling = run(tolerance, pieces_over_run);
            FormulaSamples samples = sampling.points().finished(knots_->back());
            samples.too_fast = samples.too_fast || (round + 1 == most_rounds && !sampling.integral_is_right());
            if (sampling.integral_is_right() || samples.too_fast) {
                return samples;
            }
            tolerance *= 0.1;
        }
    }

    /// Whether points are where the formula is, at places that have nothing to do with those of the points.
    [[nodiscard]] bool holds(const SignalHistory& history) const {
        const double start = knots_->front();
        const double length = knots_->back() - start;
        FormulaDecisions ignored;
        double deviation = 0.0;
        double size = 0.0;  // not 0: where every probe falls beside narrow pulses, round-off remains
        for (const double value : history.value) {
            size = std::max(size, 1e-6 * std::abs(value));
        }
        for (int i = 0; i < probes; ++i) {
            const double t = start + length * std::fmod(0.5 + golden * i, 1.0);
            const double value = (*formula_)(t, JumpSide::before, ignored);
            if (std::isfinite(value) && !history.time.empty()) {
                deviation += std::abs(value - value_at(history, t));
                size += std::abs(value);
            }
        }
        return deviation <= 10.0 * formula_accuracy * size;
    }

private:
    [[nodiscard]] Sampling run(double tolerance, int pieces_over_run) const {
        Sampling sampling(*formula_, detail_, jump_share_, tolerance);
        const double length = knots_->back() - knots_->front();
        for (std::size_t i = 1; i < knots_->size(); ++i) {
            const double from = (*knots_)[i - 1];
            const double to = (*knots_)[i];
            const double share = length > 0.0 ? (to - from) / length : 1.0;
            int pieces = detail_ == FormulaDetail::jumps ? 1 : quiet_pieces;
            if (detail_ == FormulaDetail::time) {
                pieces = std::max(pieces, static_cast<int>(std::ceil(share * pieces_over_run)));
            }
            sampling.follow(from, to, places_between(from, to, pieces));
        }
        return sampling;
    }

    const FormulaAtTime* formula_;
    const std::vector<double>* knots_;
    FormulaDetail detail_;
    double jump_share_;
};

}  // namespace

double value_at(const SignalHistory& history, double t) {
    const auto next = std::ranges::lower_bound(history.time, t);
    const auto i = static_cast<std::size_t>(next - history.time.begin());
    if (i == 0 || i == history.time.size()) {
        return i == 0 ? history.value.front() : history.value.back();
    }
    const double width = history.time[i] - history.time[i - 1];
    return history.time[i] == t
               ? history.value[i]
               : history.value[i - 1] + (history.value[i] - history.value[i - 1]) * (t - history.time[i - 1]) / width;
}

FormulaSamples sample_formula(const FormulaAtTime& formula, const std::vector<double>& knots, FormulaDetail detail,
                              double jump_share) {
    if (knots.size() < 2) {
        FormulaDecisions ignored;
        return {.history = {knots, {formula(knots.front(), JumpSide::after, ignored)}}};
    }
    const SamplingAttempt attempt(formula, knots, detail, jump_share);
    int pieces = first_pieces;
    for (int i = 0;; ++i, pieces *= denser) {
        FormulaSamples samples = attempt.with_pieces(pieces);
        if (detail == FormulaDetail::jumps || samples.too_fast || attempt.holds(samples.history)) {
            return samples;
        }
        if (i + 1 == attempts || detail == FormulaDetail::schedule) {
            samples.too_fast = true;
            return samples;
        }
    }
}

}  // namespace tiretherm::input
