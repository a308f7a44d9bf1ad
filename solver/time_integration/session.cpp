// SPDX-License-Identifier: BSD-3-Clause
// Takes one step of the problem's method per call, without error control, with inputs that are linear between two
// calls.

#include "solver/time_integration/session.hpp"

#include <cassert>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "solver/time_integration/sensor_outputs.hpp"
#include "solver/time_integration/stepper.hpp"

namespace tiretherm::solver {

namespace {

/// One step of any size, never rejected for its error; the run starts at time 0.
Problem for_real_time(Problem problem) {
    problem.settings.start = 0.0;
    problem.settings.fixed_step = 1.0;
    return problem;
}

}  // namespace

Session::Session(Problem problem, const physics::Inputs& start)
    : problem_(std::make_unique<Problem>(for_real_time(std::move(problem)))),
      stepper_(std::make_unique<Stepper>(*problem_)),
      sensor_outputs_(std::make_unique<SensorOutputs>(*problem_, stepper_->system())),
      inputs_(start),
      stage_inputs_(stepper_->stages().size()),
      channels_(problem_->channels.size()) {
    stepper_->newton().stop_timing();
    stepper_->find_watts(start);
    sensor_outputs_->begin(0.0, stepper_->temperature(), stepper_->watts(), start);
    sensor_outputs_->at(0.0, start, channels_);
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Status Session::advance(double dt, const physics::Inputs& inputs) {
    if (!(dt > 0.0) || !std::isfinite(dt)) {
        return {Outcome::step_too_small, fmt::format("a step of {} s was asked for; a step must be positive", dt)};
    }
    physics::Inputs at_end = inputs;
    at_end.time = stepper_->time() + dt;
    Stepper::Attempt attempt = stepper_->attempt(at_end.time, inputs_, at_end);
    if (attempt.status.ok()) {
        stepper_->accept();
        for (std::size_t i = 0; i < stage_inputs_.size(); ++i) {
            const double t = stepper_->stages()[i].time;
            stage_inputs_[i] = physics::between(inputs_, at_end, (t - inputs_.time) / dt);
        }
        sensor_outputs_->take_step(stepper_->stages(), stage_inputs_);
        sensor_outputs_->at(stepper_->time(), at_end, channels_);
        inputs_ = at_end;
        stage_inputs_.back() = at_end;
        has_last_step_ = true;
    }
    return std::move(attempt.status);
}

void Session::visit(Archive& archive) {
    archive(*stepper_);
    archive(*sensor_outputs_);
    archive(inputs_);
    archive(channels_);
}

std::vector<double> Session::state() {
    std::vector<double> numbers;
    Archive archive = Archive::writing(numbers);
    visit(archive);
    return numbers;
}

bool Session::restore(std::span<const double> state) {
    const std::vector<double> before = this->state();
    Archive archive = Archive::reading(state);
    visit(archive);
    if (!archive.complete()) {
        Archive back = Archive::reading(before);
        visit(back);
        return false;
    }
    has_last_step_ = false;
    return true;
}

void Session::exchange(Problem problem) {
    const std::vector<double> now = state();
    Session other(std::move(problem), inputs_);
    Archive archive = Archive::reading(now);
    other.visit(archive);
    assert(archive.complete());
    other.stepper_->forget_end();
    other.stepper_->find_watts(inputs_);
    other.sensor_outputs_->at(other.time(), inputs_, other.channels_);
    *this = std::move(other);
}

std::optional<LastStep> Session::last_step() const {
    if (!has_last_step_) {
        return std::nullopt;
    }
    return LastStep{.problem = problem_.get(),
                    .stepper = stepper_.get(),
                    .sensor_outputs = sensor_outputs_.get(),
                    .inputs = stage_inputs_};
}

double Session::time() const { return stepper_->time(); }

std::span<const double> Session::temperature() const { return stepper_->temperature(); }

double Session::channel(std::size_t index) const { return channels_[index]; }

std::span<const double> Session::watts() const { return stepper_->watts(); }

double Session::energy_closure() const { return stepper_->energy_closure(); }

}  // namespace tiretherm::solver
