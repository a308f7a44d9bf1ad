#include "solver/session.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "solver/stepper.hpp"

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
      inputs_(start) {}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

Status Session::advance(double dt, const physics::Inputs& inputs) {
    if (!(dt > 0.0) || !std::isfinite(dt)) {
        return {Outcome::step_too_small, fmt::format("a step of {} s was asked for; a step must be positive", dt)};
    }
    Stepper::Attempt attempt = stepper_->attempt(stepper_->time() + dt, inputs_, inputs);
    if (attempt.status.ok()) {
        stepper_->accept();
        inputs_ = inputs;
    }
    return std::move(attempt.status);
}

double Session::time() const { return stepper_->time(); }

std::span<const double> Session::temperature() const { return stepper_->temperature(); }

double Session::channel(std::size_t index) const { return problem_->channels[index].where(stepper_->temperature()); }

std::span<const double> Session::watts() const { return stepper_->watts(); }

double Session::energy_closure() const { return stepper_->energy_closure(); }

}  // namespace tiretherm::solver
