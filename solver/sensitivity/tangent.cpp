// SPDX-License-Identifier: BSD-3-Clause
// Solves the linearised stages for all parameters at once with the block solver and the kept factor of the run; surface
// nodes without capacity by a diagonal iteration.

#include "solver/sensitivity/tangent.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/index.hpp"
#include "solver/sensitivity/stage_guess.hpp"

namespace tiretherm::solver {

namespace {

/// A kept factor serves sensitivities less long than a run: all of them pay for its age.
constexpr double reach = 1.7;
}  // namespace

Tangent::Tangent(const Problem& problem, Stepper& stepper, std::span<const FreeParameter> parameters,
                 std::span<const double> values, double tolerance)
    : problem_(&problem),
      stepper_(&stepper),
      system_(&stepper.system()),
      n_(at(system_->size())),
      tolerance_(tolerance),
      solver_(system_->size()),
      settling_(*system_) {
    for (std::size_t j = 0; j < parameters.size(); ++j) {
        perturbations_.push_back(std::make_unique<ParameterPerturbation>(problem, parameters[j], values[j]));
    }
    const std::size_t all = n_ * perturbations_.size();
    const auto stages = at(stepper.method().stages);
    capacity_.resize(n_);
    base_flow_.resize(n_);
    S_.assign(stages, Block(all));
    dq_.assign(stages, Block(all));
    for (Block* block : {&before_, &enthalpy_begin_, &enthalpy_end_, &known_, &partial_, &product_}) {
        block->resize(all);
    }
    if (!perturbations_.empty()) {
        stepper.newton().set_reach(reach);
    }
}

void Tangent::begin(const physics::Inputs& inputs) {
    for (std::size_t j = 0; j < size(); ++j) {
        std::ranges::copy(perturbations_[j]->start(), column(S_.back(), j).begin());
        perturbations_[j]->begin_sensor_outputs(stepper_->time(), stepper_->temperature(), column(S_.back(), j),
                                                stepper_->watts(), inputs);
    }
    last_width_ = 0.0;
}

/// dq/dp of every parameter at a given temperature, into partial_.
void Tangent::find_flow_slopes(int stage, std::span<const double> T) {
    const std::span<const double> base = stepper_->coefficients(stage);
    bool base_is_known = false;
    for (std::size_t j = 0; j < size(); ++j) {
        const std::span<double> out = column(partial_, j);
        if (const std::span<const std::size_t> straight = perturbations_[j]->straight(); !straight.empty()) {
            if (!base_is_known) {
                system_->find_flow_of(straight, T, system_->means(), base, base_flow_);
                base_is_known = true;
            }
            perturbations_[j]->flow_above(T, system_->means(), base, base_flow_, out);
        } else if (perturbations_[j]->moves_flow()) {
            perturbations_[j]->flow(stage, T, system_->means(), base, out);
        } else {
            std::fill(out.begin(), out.end(), 0.0);
        }
    }
}

void Tangent::find_capacities(std::span<const double> T) {
    for (std::size_t i = 0; i < n_; ++i) {
        capacity_[i] = system_->has_capacity(i) ? system_->capacity(i, T[i]) : 0.0;
    }
}

/// The explicit stage: the state of the step's begin, whose surfaces follow the inputs.
Status Tangent::start_step(double s) {
    const std::span<const double> T = stepper_->stages().front().temperature;
    before_ = S_[S_.size() - 2];
    S_.front() = S_.back();
    const bool goes_on =
        last_width_ > 0.0 && std::ranges::equal(stepper_->coefficients(0), ended_) &&
        std::ranges::all_of(perturbations_, [](const auto& perturbation) { return perturbation->goes_on(); });
    if (goes_on) {
        dq_.front() = dq_.back();
        std::swap(enthalpy_begin_, enthalpy_end_);
        return {};
    }
    system_->evaluate(T, stepper_->coefficients(0));
    system_->matrices(s, false, A_, J_);
    find_flow_slopes(0, T);
    if (Status status = settling_.settle(J_, partial_, s, 1e-3 * tolerance_, S_.front()); !status.ok()) {
        return status;
    }
    find_capacities(T);
    // s dq/dT S = C S - J S
    J_.multiply_block(S_.front(), product_, size());
    for (std::size_t j = 0; j < size(); ++j) {
        const std::span<double> dq = column(dq_.front(), j);
        const std::span<double> H = column(enthalpy_begin_, j);
        perturbations_[j]->enthalpy(T, H);
        for (std::size_t i = 0; i < n_; ++i) {
            const double stored = capacity_[i] * S_.front()[j * n_ + i];
            dq[i] = (stored - product_[j * n_ + i]) / s + partial_[j * n_ + i];
            H[i] += stored;
        }
    }
    return {};
}

Status Tangent::solve_stage(int stage, double dt) {
    const Tableau& method = stepper_->method();
    const double s = dt * method.diagonal;
    const std::span<const double> T = stepper_->stages()[at(stage)].temperature;
    system_->evaluate(T, stepper_->coefficients(stage));
    system_->matrices(s, false, A_, J_);
    find_flow_slopes(stage, T);
    guess_stage(method, stage, dt, last_width_, S_, before_);
    for (std::size_t j = 0; j < size(); ++j) {
        perturbations_[j]->enthalpy(T, column(product_, j));
    }
    known_ = enthalpy_begin_;
    for (int k = 0; k < stage; ++k) {
        const double weight = dt * method.a[at(stage)][at(k)];
        for (std::size_t i = 0; i < known_.size(); ++i) {
            known_[i] += weight * dq_[at(k)][i];
        }
    }
    for (std::size_t i = 0; i < known_.size(); ++i) {
        dq_[at(stage)][i] = -known_[i] / s;
        known_[i] += s * partial_[i] - product_[i];
    }
    Newton& newton = stepper_->newton();
    const BlockSolver::Result result = solver_.solve(J_, newton.factor(), known_, S_[at(stage)], tolerance_);
    sweeps_ += result.sweeps;
    newton.add_excess_solves(static_cast<double>(std::max(0, result.sweeps - 2) * static_cast<int>(size())) / 2.0);
    if (!result.converged) {
        return {Outcome::not_converged,
                fmt::format("the sensitivities did not converge at t = {:.6g} s", stepper_->stages()[at(stage)].time)};
    }
    find_capacities(T);
    // dq = (C S + dH/dp - known) / s
    for (std::size_t j = 0; j < size(); ++j) {
        for (std::size_t i = 0; i < n_; ++i) {
            const std::size_t k = j * n_ + i;
            const double stored = capacity_[i] * S_[at(stage)][k];
            enthalpy_end_[k] = product_[k] + stored;
            dq_[at(stage)][k] += enthalpy_end_[k] / s;
        }
    }
    return {};
}

Status Tangent::take_step(std::span<const physics::Inputs> inputs) {
    if (perturbations_.empty()) {
        return {};
    }
    const double dt = stepper_->width();
    for (const std::unique_ptr<ParameterPerturbation>& perturbation : perturbations_) {
        perturbation->open(stepper_->begin(), stepper_->time(), stepper_->forcing());
    }
    if (Status status = start_step(dt * stepper_->method().diagonal); !status.ok()) {
        return status;
    }
    for (int stage = 1; stage < stepper_->method().stages; ++stage) {
        if (Status status = solve_stage(stage, dt); !status.ok()) {
            return status;
        }
    }
    last_width_ = dt;
    const std::span<const double> ended = stepper_->coefficients(stepper_->method().stages - 1);
    ended_.assign(ended.begin(), ended.end());
    std::vector<std::span<const double>> S(S_.size());
    std::vector<std::span<const double>> coefficients(S_.size());
    for (std::size_t i = 0; i < S_.size(); ++i) {
        coefficients[i] = stepper_->coefficients(static_cast<int>(i));
    }
    for (std::size_t j = 0; j < size(); ++j) {
        for (std::size_t i = 0; i < S_.size(); ++i) {
            S[i] = column(S_[i], j);
        }
        perturbations_[j]->take_step(stepper_->stages(), S, coefficients, inputs);
    }
    return {};
}

Status Tangent::take_steady(const physics::Inputs& inputs) {
    if (perturbations_.empty()) {
        return {};
    }
    const double t = stepper_->time();
    const std::span<const double> T = stepper_->temperature();
    for (const std::unique_ptr<ParameterPerturbation>& perturbation : perturbations_) {
        perturbation->open(t, t, stepper_->forcing());
    }
    system_->evaluate(T, stepper_->coefficients(0));
    system_->matrices(1.0, true, A_, J_);
    find_flow_slopes(0, T);
    std::ranges::fill(S_.back(), 0.0);
    const BlockSolver::Result result = solver_.solve(J_, stepper_->newton().factor(), partial_, S_.back(), tolerance_);
    sweeps_ += result.sweeps;
    if (!result.converged) {
        return {Outcome::not_converged, "the sensitivities of the steady state did not converge"};
    }
    for (std::size_t j = 0; j < size(); ++j) {
        perturbations_[j]->begin_sensor_outputs(t, T, column(S_.back(), j), stepper_->watts(), inputs);
    }
    return {};
}

void Tangent::read(double t, const physics::Inputs& logged, std::span<double> out) {
    const std::size_t channels = problem_->channels.size();
    for (std::size_t j = 0; j < size(); ++j) {
        perturbations_[j]->read(t, logged, out.subspan(j * channels, channels));
    }
}

}  // namespace tiretherm::solver
