// SPDX-License-Identifier: BSD-3-Clause
// Repeats a run with given steps and keeps its stages, effect coefficients and the linear form of every sampled output; what both
// sweeps need of a step.

#include "solver/sensitivity/adjoint_record.hpp"

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::solver {

namespace {

Problem with_given_steps(Problem problem) {
    problem.settings.fixed_step = 1.0;
    return problem;
}

}  // namespace

AdjointRecord::AdjointRecord(const Problem& problem, std::span<const double> times, std::span<const double> step_ends)
    : problem_(with_given_steps(problem)),
      n_(at(problem.mesh.n_nodes)),
      stepper_(problem_),
      factor_(make_factor(stepper_.system().pattern(), problem.settings.linear_solver)),
      settling_(stepper_.system()),
      n_samples_(times.size() * problem.channels.size()) {
    SensorOutputs sensor_outputs(problem_, stepper_.system());
    const double start = problem_.settings.start;
    const physics::Inputs first = problem_.input_signals.at(start, JumpSide::after);
    stepper_.find_watts(first);
    sensor_outputs.begin(start, stepper_.temperature(), stepper_.watts(), first);
    const std::size_t channels = problem_.channels.size();
    for (std::size_t c = 0; c < channels; ++c) {
        places_.push_back(sensor_outputs.place(c));
    }
    std::vector<physics::Inputs> inputs;
    std::vector<std::vector<OutputSample>> of_step;
    std::size_t next = 0;
    while (next < times.size() && times[next] <= start) {
        ++next;  // the initial state follows no heat
    }
    for (const double end : step_ends) {
        leave_if_stopped();
        Stepper::Attempt attempt = stepper_.attempt(end, false);
        if (!attempt.status.ok()) {
            status_ = std::move(attempt.status);
            return;
        }
        stepper_.accept();
        inputs.clear();
        for (const StepMoment& stage : stepper_.stages()) {
            inputs.push_back(
                problem_.input_signals.at(stage.time, inputs.empty() ? JumpSide::after : JumpSide::before));
        }
        sensor_outputs.take_step(stepper_.stages(), inputs);
        add_step(stepper_, inputs, sensor_outputs);
        of_step.emplace_back();
        for (; next < times.size() && times[next] <= end; ++next) {
            const physics::Inputs logged = problem_.input_signals.at(times[next], JumpSide::before);
            for (std::size_t c = 0; c < channels; ++c) {
                // A delayed clock shows a moment that may lie in an earlier step.
                const double when = sensor_outputs.moment(c, times[next]);
                std::size_t step = steps_.size() - 1;
                while (step > 0 && when < steps_[step].stages.front().time) {
                    --step;
                }
                if (when < steps_[step].stages.front().time) {
                    continue;
                }
                OutputSample sample{.step = step, .channel = c, .place = next * channels + c, .form = {}};
                // The inputs matter to sensor models before a lag alone, which look at the air.
                std::vector<physics::Inputs> then;
                for (const StepMoment& stage : steps_[step].stages) {
                    then.push_back(
                        problem_.input_signals.at(stage.time, then.empty() ? JumpSide::after : JumpSide::before));
                }
                sample.form = sensor_outputs.form(c, steps_[step].stages, then, when);
                const double slope = sensor_outputs.slope(c, times[next], logged);
                for (double& weight : sample.form.stage) {
                    weight *= slope;
                }
                sample.form.lagged *= slope;
                of_step[step].push_back(sample);
            }
        }
    }
    for (const std::vector<OutputSample>& some : of_step) {
        first_sample_.push_back(samples_.size());
        samples_.insert(samples_.end(), some.begin(), some.end());
    }
    first_sample_.push_back(samples_.size());
}

void AdjointRecord::add_step(const Stepper& stepper, std::span<const physics::Inputs> inputs,
                             const SensorOutputs& sensor_outputs) {
    Step step;
    step.dt = stepper.width();
    for (std::size_t i = 0; i < stepper.stages().size(); ++i) {
        const StepMoment& stage = stepper.stages()[i];
        const std::span<const double> coefficients = stepper.coefficients(static_cast<int>(i));
        step.T.emplace_back(stage.temperature.begin(), stage.temperature.end());
        step.coefficients.emplace_back(coefficients.begin(), coefficients.end());
        step.stages.push_back({.time = stage.time, .temperature = {}, .watts = {}});
    }
    steps_.push_back(std::move(step));
    Step& kept = steps_.back();
    for (std::size_t i = 0; i < kept.stages.size(); ++i) {
        kept.stages[i].temperature = kept.T[i];
    }
    for (std::size_t c = 0; c < problem_.channels.size(); ++c) {
        kept.carry.push_back(sensor_outputs.form(c, kept.stages, inputs, kept.stages.back().time));
    }
}

void AdjointRecord::linearise(const Step& step) {
    System& system = stepper_.system();
    const std::size_t stages = step.T.size();
    now_.s = step.dt * stepper_.method().diagonal;
    now_.J.resize(stages);
    now_.slopes.resize(stages);
    now_.capacity.assign(stages, std::vector<double>(n_));
    for (std::size_t i = 0; i < stages; ++i) {
        system.evaluate(step.T[i], step.coefficients[i]);
        system.matrices(now_.s, false, now_.A, now_.J[i]);
        // The outer products point into the terms, which the next stage overwrites.
        now_.slopes[i] = system.terms().region_slope;
        for (Matrix::Outer& outer : now_.J[i].outer) {
            const auto offset = outer.row.data() - system.terms().region_slope.data();
            outer.row = std::span(now_.slopes[i]).subspan(static_cast<std::size_t>(offset), n_);
        }
        for (std::size_t k = 0; k < n_; ++k) {
            now_.capacity[i][k] = system.has_capacity(k) ? system.capacity(k, step.T[i][k]) : 0.0;
        }
    }
    if (const std::string wrong = factor_->factorise(now_.A); !wrong.empty()) {
        status_ = {Outcome::not_positive_definite, wrong};
    }
}

void AdjointRecord::note(Status status) {
    if (!status.ok()) {
        status_ = std::move(status);
    }
}

Status AdjointRecord::solve(BlockSolver& solver, Factor& factor, const Matrix& J, std::span<const double> B,
                            std::span<double> X, double tolerance, std::size_t step) const {
    if (solver.solve(J, factor, B, X, tolerance).converged) {
        return {};
    }
    return {Outcome::not_converged, fmt::format("the answers to heat did not converge at t = {:.6g} s", end(step))};
}

}  // namespace tiretherm::solver
