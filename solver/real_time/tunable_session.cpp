// SPDX-License-Identifier: BSD-3-Clause
// Parameters are moved from the values of the model to those that were set, so that the way there makes no difference.

#include "solver/real_time/tunable_session.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "solver/time_integration/checkpoint.hpp"

namespace tiretherm::solver {

namespace {

std::string outside(std::string_view name, double value, std::string_view unit, double low, double high) {
    return fmt::format("{} = {} {} is not between {} and {}", name, value, unit, low, high);
}

std::vector<double> values_in(const SessionModel& model) {
    std::vector<double> values;
    for (const FreeParameter& parameter : model.parameters) {
        values.push_back(value_of(model.problem, parameter));
    }
    return values;
}

}  // namespace

TunableSession::TunableSession(SessionModel model)
    : model_(std::move(model)),
      base_(values_in(model_)),
      values_(base_),
      start_(model_.start),
      inputs_(model_.start),
      session_(model_.problem, start_) {}

std::string TunableSession::refusal(const physics::Signal& signal, double value) {
    return value >= signal.low && value <= signal.high
               ? std::string()
               : outside(signal.name, value, signal.unit, signal.low, signal.high);
}

std::string TunableSession::set_input(const physics::Signal& signal, double value) {
    std::string reason = refusal(signal, value);
    if (reason.empty()) {
        inputs_.*signal.member = value;
    }
    return reason;
}

std::string TunableSession::refusal(std::size_t index, double value) const {
    const FreeParameter& parameter = model_.parameters[index];
    return std::isfinite(value) && value >= parameter.low && value <= parameter.high
               ? std::string()
               : outside(parameter.name, value, parameter.unit, parameter.low, parameter.high);
}

std::string TunableSession::set_parameter(std::size_t index, double value) {
    std::string reason = refusal(index, value);
    if (reason.empty()) {
        values_[index] = value;
    }
    return reason;
}

void TunableSession::apply_parameters() {
    if (session_.time() > 0.0) {
        session_.exchange(moved(values_));
    } else {
        session_ = Session(moved(values_), start_);
    }
}

void TunableSession::begin(const physics::Inputs& start) {
    start_ = inputs_ = start;
    start_.time = inputs_.time = 0.0;
    session_ = Session(moved(values_), start_);
}

/// How far to go for a difference quotient: little beside any of what moves.
double TunableSession::reach(const SessionDirection& direction) const {
    double shift = std::numeric_limits<double>::infinity();
    for (const auto& [signal, rate] : direction.inputs) {
        // The range of the wheel's angle says nothing of what is small.
        const double range = signal->unit == "radian" ? 1.0 : signal->high - signal->low;
        shift = std::min(shift, 1e-5 * range / std::abs(rate));
    }
    for (const auto& [index, rate] : direction.parameters) {
        shift = std::min(shift, typical_step(model_.parameters[index], values_[index]) / std::abs(rate));
    }
    return shift;
}

/// What lies in the direction; where something would leave its range, what there is.
StepNeighbour TunableSession::neighbour(const SessionDirection& direction, const physics::Inputs& inputs,
                                        double shift) const {
    std::vector<double> values = values_;
    physics::Inputs to = inputs;
    bool allowed = true;
    for (const auto& [signal, rate] : direction.inputs) {
        to.*signal->member += shift * rate;
        allowed = allowed && refusal(*signal, to.*signal->member).empty();
    }
    for (const auto& [index, rate] : direction.parameters) {
        values[index] += shift * rate;
        allowed = allowed && refusal(index, values[index]).empty();
    }
    if (!allowed) {
        return {.problem = moved(values_), .to = inputs, .shift = 0.0};
    }
    return {.problem = moved(values), .to = to, .shift = shift};
}

Status TunableSession::find_slopes(const SessionDirection& direction, std::span<double> slope) const {
    std::ranges::fill(slope, 0.0);
    SessionDirection moving;
    const auto moves = [](const auto& one) { return one.rate != 0.0; };
    std::ranges::copy_if(direction.inputs, std::back_inserter(moving.inputs), moves);
    std::ranges::copy_if(direction.parameters, std::back_inserter(moving.parameters), moves);
    if (moving.inputs.empty() && moving.parameters.empty()) {
        return {};
    }
    const std::optional<LastStep> step = session_.last_step();
    if (!step && session_.time() > 0.0) {
        return {Outcome::stopped, "the last step is not known: a state was restored or a parameter set since"};
    }
    const physics::Inputs& inputs = step ? step->inputs.back() : start_;
    const double far = reach(moving);
    const StepNeighbour above = neighbour(moving, inputs, far);
    const StepNeighbour below = neighbour(moving, inputs, -far);
    if (!(above.shift > below.shift)) {
        return {Outcome::stopped, "there is no room to either side within the ranges"};
    }
    if (step) {
        return find_step_slopes(*step, above, below, slope);
    }
    const Session high(above.problem, above.to);
    const Session low(below.problem, below.to);
    for (std::size_t c = 0; c < slope.size(); ++c) {
        slope[c] = (high.channel(c) - low.channel(c)) / (above.shift - below.shift);
    }
    return {};
}

std::vector<double> TunableSession::state() {
    std::vector<double> numbers;
    Archive archive = Archive::writing(numbers);
    archive(inputs_);
    archive(start_);
    archive(values_);
    const std::vector<double> inner = session_.state();
    numbers.insert(numbers.end(), inner.begin(), inner.end());
    return numbers;
}

bool TunableSession::restore(std::span<const double> state) {
    physics::Inputs inputs;
    physics::Inputs start;
    std::vector<double> values = values_;
    Archive archive = Archive::reading(state);
    archive(inputs);
    archive(start);
    archive(values);
    const std::span<const double> inner = state.last(archive.left());
    if (values == values_) {
        if (!session_.restore(inner)) {
            return false;
        }
    } else {
        if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) {
            return false;
        }
        Session other(moved(values), start);
        if (!other.restore(inner)) {
            return false;
        }
        session_ = std::move(other);
    }
    inputs_ = inputs;
    start_ = start;
    values_ = std::move(values);
    return true;
}

Problem TunableSession::moved(const std::vector<double>& values) const {
    Problem problem = model_.problem;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i] != base_[i]) {
            move(problem, model_.parameters[i], base_[i], values[i]);
        }
    }
    return problem;
}

}  // namespace tiretherm::solver
