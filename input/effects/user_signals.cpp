// SPDX-License-Identifier: BSD-3-Clause
// Evaluates a formula of the signals of a run, and judges whether the points that come of it can be used.

#include "input/effects/user_signals.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include <fmt/format.h>

#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

using solver::JumpSide;
using solver::SignalHistory;

/// A jump between two samples of a log, as a share of their distance.
constexpr double logged_jump = 1e-3;

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

    double operator()(double t, JumpSide side, FormulaDecisions& decisions) {
        const physics::Inputs inputs = input_signals_->at(t, side);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_[i] = columns_[i] != nullptr   ? value_at(columns_[i]->signal, t)
                         : signals_[i] != nullptr ? inputs.*(signals_[i]->member)
                                                  : inputs.time;
        }
        return formula_->evaluate(values_, decisions);
    }

    [[nodiscard]] bool has_time() const { return std::ranges::count(formula_->signals(), "time") > 0; }

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

UserColumn column_of(const MeasuredRun& run, const std::string& name, std::string unit, const Conversion& si,
                     const std::vector<double>& value) {
    UserColumn column{.name = name, .unit = std::move(unit), .signal = {}};
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        if (!std::isnan(value[i])) {
            column.signal.time.push_back(run.time[i]);
            column.signal.value.push_back(si.to_si(value[i]));
        }
    }
    column.signal = run.repeated.before(std::move(column.signal));
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

FormulaSamples signal_history_of(const Formula& formula, const solver::InputSignals& input_signals,
                                 const std::vector<UserColumn>& columns, const solver::Settings& settings) {
    Follower follower(formula, input_signals, columns);
    bool logged = false;
    const std::vector<double> points = follower.points(settings, logged);
    const FormulaDetail between = logged ? FormulaDetail::jumps : FormulaDetail::schedule;
    return sample_formula(std::ref(follower), points, follower.has_time() ? FormulaDetail::time : between,
                          logged ? logged_jump : 0.0);
}

std::optional<ErrorText> formula_error(const FormulaSamples& samples, const solver::Settings& settings) {
    const double length = settings.end - settings.start;
    if (samples.history.time.empty()) {
        return ErrorText{"is not a finite number at any time", "write a formula that has a value"};
    }
    if (too_long_a_gap(samples.longest_gap, length) || samples.undefined > most_missing_share * length) {
        return ErrorText{fmt::format("is not a finite number for {:.6g} s of {:.6g} s, from {:.6g} s on",
                                     samples.undefined, length, samples.gap_from),
                         "write what it is then, such as time > 1800 ? sqrt(time - 1800) : 0"};
    }
    if (samples.too_fast) {
        return ErrorText{fmt::format("changes too fast: {} points in {:.6g} s do not follow it to {:g} of its integral",
                                     most_formula_points, length, formula_accuracy),
                         "write its mean over a period, or shorten the run"};
    }
    return std::nullopt;
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
    FormulaSamples samples = signal_history_of(*formula, run.problem.input_signals, columns, run.problem.settings);
    if (const std::optional<ErrorText> error = formula_error(samples, run.problem.settings)) {
        throw std::invalid_argument(fmt::format("{} {}", follows, error->what));
    }
    return std::move(samples.history);
}

}  // namespace tiretherm::input
