// SPDX-License-Identifier: BSD-3-Clause
// Evaluates a formula at the samples of its signals; where these are schedules, halves the intervals until straight
// lines are accurate.

#include "input/effects/user_signals.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

using solver::JumpSide;
using solver::SignalHistory;

/// Straight lines deviate from a formula by less than this share of its largest value.
constexpr double close = 1e-4;
constexpr int most_halvings = 12;

/// Straight between its points and held beyond them.
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

/// A formula over the signals of a run.
class Follower {
public:
    Follower(const Formula& formula, const solver::InputSignals& input_signals, const std::vector<UserColumn>& columns)
        : formula_(&formula), input_signals_(&input_signals), values_(formula.signals().size()) {
        for (const std::string& name : formula.signals()) {
            const auto column = std::ranges::find(columns, name, &UserColumn::name);
            signals_.push_back(physics::find_signal(name));
            columns_.push_back(signals_.back() == nullptr && column != columns.end() ? &*column : nullptr);
        }
    }

    double operator()(double t, JumpSide side) {
        const physics::Inputs inputs = input_signals_->at(t, side);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_[i] = columns_[i] != nullptr   ? value_at(columns_[i]->signal, t)
                         : signals_[i] != nullptr ? inputs.*(signals_[i]->member)
                                                  : inputs.time;
        }
        return (*formula_)(values_);
    }

    /// Points of the signals within the run, its ends among them. @param logged out, whether any of them is a log
    std::vector<double> points(const solver::Settings& settings, bool& logged) const {
        std::vector<double> times{settings.start, settings.end};
        const auto add = [&](const std::vector<double>& more) {
            std::ranges::copy_if(more, std::back_inserter(times),
                                 [&](double t) { return t > settings.start && t < settings.end; });
        };
        logged = false;
        for (std::size_t i = 0; i < values_.size(); ++i) {
            if (columns_[i] != nullptr) {
                add(columns_[i]->signal.time);
                logged = true;
            }
            for (const solver::Series& series : input_signals_->series()) {
                if (series.signal == signals_[i]) {
                    add(series.time);
                    logged = logged || series.logged;
                }
            }
        }
        std::ranges::sort(times);
        times.erase(std::unique(times.begin(), times.end()), times.end());
        return times;
    }

private:
    const Formula* formula_;
    const solver::InputSignals* input_signals_;
    std::vector<const physics::Signal*> signals_;  ///< [signals] null for a column and for the time
    std::vector<const UserColumn*> columns_;       ///< [signals] null for an input and for the time
    std::vector<double> values_;
};

/// Points between two others where the formula bends.
void refine(Follower& follower, double t0, double v0, double t1, double v1, double tolerance, int halvings,
            SignalHistory& into) {
    const double width = t1 - t0;
    double worst = 0.0;
    for (const double share : {0.25, 0.5, 0.75}) {
        worst = std::max(worst, std::abs(follower(t0 + share * width, JumpSide::before) - v0 - share * (v1 - v0)));
    }
    if (worst > tolerance && halvings < most_halvings) {
        const double middle = 0.5 * (t0 + t1);
        const double v = follower(middle, JumpSide::before);
        refine(follower, t0, v0, middle, v, tolerance, halvings + 1, into);
        into.time.push_back(middle);
        into.value.push_back(v);
        refine(follower, middle, v, t1, v1, tolerance, halvings + 1, into);
    }
}

SignalHistory refined(Follower& follower, const SignalHistory& coarse) {
    double largest = 0.0;
    for (std::size_t i = 0; i < coarse.time.size(); ++i) {
        largest = std::max(largest, std::abs(coarse.value[i]));
        const double middle = i > 0 ? 0.5 * (coarse.time[i - 1] + coarse.time[i]) : coarse.time[i];
        largest = std::max(largest, std::abs(follower(middle, JumpSide::before)));
    }
    SignalHistory fine;
    for (std::size_t i = 0; i < coarse.time.size(); ++i) {
        if (i > 0 && coarse.time[i] > coarse.time[i - 1]) {
            refine(follower, coarse.time[i - 1], coarse.value[i - 1], coarse.time[i], coarse.value[i], close * largest,
                   0, fine);
        }
        fine.time.push_back(coarse.time[i]);
        fine.value.push_back(coarse.value[i]);
    }
    return fine;
}

UserColumn column_of(const MeasuredRun& run, const std::string& name, std::string unit, const Conversion& si,
                     const std::vector<double>& value) {
    UserColumn column{.name = name, .unit = std::move(unit), .signal = {}};
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        if (!std::isnan(value[i])) {
            column.signal.time.push_back(run.time[i]);
            column.signal.value.push_back(si.to_si(value[i]));
        }
    }
    return column;
}

/// What a measured run has beside its inputs.
std::vector<UserColumn> columns_of(const MeasuredRun& run) {
    std::vector<UserColumn> columns;
    for (const UnusedSignal& signal : run.unused) {
        const std::string unit = base_unit(signal.unit);
        const auto read = conversion(signal.unit, unit, Scale::absolute);
        const Conversion* known = std::get_if<Conversion>(&read);
        columns.push_back(column_of(run, signal.name, unit, known != nullptr ? *known : Conversion{}, signal.value));
    }
    for (const MeasuredSeries& series : run.series) {
        const solver::Channel& channel = run.problem.channels[series.channel];
        columns.push_back(
            column_of(run, channel.name, std::string(solver::unit_of(channel.quantity)), {}, series.value));
    }
    std::erase_if(columns, [](const UserColumn& column) { return column.signal.time.empty(); });
    return columns;
}

}  // namespace

std::string base_unit(const std::optional<std::string>& unit) {
    const std::string base = unit && !unit->empty() ? signature(*unit) : "1";
    return base.empty() ? "1" : base;
}

SignalHistory signal_history_of(const Formula& formula, const solver::InputSignals& input_signals,
                                const std::vector<UserColumn>& columns, const solver::Settings& settings) {
    Follower follower(formula, input_signals, columns);
    bool logged = false;
    SignalHistory history;
    for (const double t : follower.points(settings, logged)) {
        const double before = follower(t, JumpSide::before);
        const double after = follower(t, JumpSide::after);
        if (t > settings.start) {
            history.time.push_back(t);
            history.value.push_back(before);
        }
        if (t == settings.start || (after != before && t < settings.end)) {
            history.time.push_back(t);
            history.value.push_back(after);
        }
    }
    return logged ? history : refined(follower, history);
}

SignalHistory signal_history_of(std::string_view follows, const MeasuredRun& run) {
    Formula::Wrong wrong;
    const std::string text(follows);
    const std::vector<UserColumn> columns = columns_of(run);
    const bool is_column =
        physics::find_signal(text) == nullptr && std::ranges::count(columns, text, &UserColumn::name) > 0;
    const std::optional<Formula> formula = is_column ? Formula::of_signal(text) : Formula::read(text, "follows", wrong);
    if (!formula) {
        throw std::invalid_argument(wrong.error.what);
    }
    for (const std::string& name : formula->signals()) {
        const physics::Signal* signal = physics::find_signal(name);
        const bool known = signal != nullptr
                               ? run.problem.input_signals.gives(*signal)
                               : name == "time" || std::ranges::count(columns, name, &UserColumn::name) > 0;
        if (!known) {
            throw std::invalid_argument(fmt::format("the run {} has no signal {}", run.name, name));
        }
    }
    return signal_history_of(*formula, run.problem.input_signals, columns, run.problem.settings);
}

}  // namespace tiretherm::input
