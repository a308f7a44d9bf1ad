// SPDX-License-Identifier: BSD-3-Clause
// Parameters are moved from the values of the model to those that were set, so that the way there makes no difference.

#include "solver/real_time/tunable_session.hpp"

#include <algorithm>
#include <cmath>
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
