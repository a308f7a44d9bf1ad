// SPDX-License-Identifier: BSD-3-Clause
// Damped Newton iteration; a factor is kept until its age has cost more solves than a new one. Beside it stand the simplified
// iteration that comes first, the closing of the heat budget, and the search along a correction.

#include "solver/time_integration/newton.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "mesh/parallel.hpp"
#include "solver/time_integration/stopwatch.hpp"

namespace tiretherm::solver {

namespace {

constexpr int most_iterations = 50;
/// Corrections after which the next ones are searched along: by then a smooth balance has converged.
constexpr int unsearched = 6;
/// Newton's corrections need only this relative accuracy of the linear solution: the next one mends the rest.
constexpr double forcing = 1e-3;
/// Error estimates are wanted to this.
constexpr double one_digit = 0.1;
/// An iteration that was held back down to here would go on below the absolute zero. K
constexpr double absolute_zero = 1e-3;

}  // namespace

Newton::Newton(System& system)
    : system_(&system), factors_(system.pattern(), system.problem().settings.linear_solver), krylov_(system.size()) {
    const auto n = static_cast<std::size_t>(system.size());
    for (std::vector<double>* v :
         {&compliance_, &guess_, &residual_, &correction_, &remainder_, &J_ones_, &enthalpy_, &trial_}) {
        v->resize(n);
    }
    ones_.assign(n, 1.0);
    const std::vector<mesh::Face>& faces = system.problem().mesh.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const bool a = !system.has_capacity(static_cast<std::size_t>(faces[f].a));
        const bool b = !system.has_capacity(static_cast<std::size_t>(faces[f].b));
        if (a != b) {
            surface_faces_.push_back({.face = static_cast<int>(f),
                                      .surface = a ? faces[f].a : faces[f].b,
                                      .cell = a ? faces[f].b : faces[f].a,
                                      .surface_is_a = a});
        }
    }
    for (const physics::Material& material : system.problem().materials) {
        has_nonlinear_capacity_ = has_nonlinear_capacity_ || !material.heat_capacity.is_constant();
    }
    A_.value.reserve(system.pattern().nonzeros());
    J_.value.reserve(system.pattern().nonzeros());
    J_.outer.reserve(system.problem().mesh.regions.size());
}

void Newton::find_residual(const Stage& stage, std::span<const double> T) {
    const std::span<const double> q = system_->heat_flow();
    if (stage.steady) {
        clear_nodes(enthalpy_);
    } else {
        system_->enthalpy(T, enthalpy_);
    }
    over_nodes(residual_.size(), [&](std::size_t i) { residual_[i] = stage.known[i] + stage.s * q[i] - enthalpy_[i]; });
}

/// Largest residual over its diagonal: an estimate in kelvin that needs no solve. Also finds the worst node.
double Newton::scaled_residual() {
    const Pattern& p = system_->pattern();
    const Largest worst = largest_over_nodes(residual_.size(), [&](std::size_t i) {
        return std::abs(residual_[i]) / A_.value[static_cast<std::size_t>(p.diagonal[i])];
    });
    if (worst.value > 0.0) {
        now_.worst_node = static_cast<int>(worst.place);
    }
    return worst.value;
}

/// Factorises when there is no usable factor, when the step has changed too much for the old one, or when the solves
/// that a fresh factor would have saved have cost more than it does.
Status Newton::prepare(const Stage& stage) {
    return factors_.select(stage.s) && !factors_.is_worn_out() ? Status{} : renew(stage);
}

Status Newton::renew(const Stage& stage) {
    const Stopwatch watch(timed_ ? &now_.counters.factor_seconds : nullptr);
    ++now_.counters.factorisations;
    const physics::Terms& terms = system_->terms();
    over_nodes(compliance_.size(), [&](std::size_t i) {
        compliance_[i] = system_->has_capacity(i)
                             ? 1.0 / system_->capacity(i, terms.temperature[i])
                             : stage.s / A_.value[static_cast<std::size_t>(system_->pattern().diagonal[i])];
    });
    if (std::string problem = factors_.renew(A_, stage.s, compliance_); !problem.empty()) {
        return {Outcome::not_positive_definite, fmt::format("{}, at t = {:.6g} s", problem, stage.time)};
    }
    return {};
}

void Newton::assemble(const Stage& stage) {
    const Stopwatch watch(timed_ ? &now_.counters.assembly_seconds : nullptr);
    system_->matrices(stage.s, stage.steady, A_, J_);
}

/// The balance at T, and its residual; not done when it is not a number or an effect gave a negative conductance.
Status Newton::evaluate(const Stage& stage, std::span<const double> T) {
    {
        const Stopwatch watch(timed_ ? &now_.counters.assembly_seconds : nullptr);
        system_->evaluate(T, stage.coefficients);
        find_residual(stage, T);
    }
    if (const int bad = system_->first_not_finite(); bad >= 0) {
        return system_->failure_at(Outcome::not_finite, "the heat balance is not a number", bad, stage.time, T,
                                   stage.coefficients);
    }
    if (const physics::Terms& terms = system_->terms(); terms.negative_effect >= 0) {
        const physics::ActiveEffect& cause =
            system_->problem().effects[static_cast<std::size_t>(terms.negative_effect)];
        return system_->failure_at(
            Outcome::negative_conductance,
            fmt::format("effect {} gave a negative conductance (a law k(T) or h below zero?)", cause.title()),
            terms.negative_node, stage.time, T, stage.coefficients);
    }
    return {};
}

/// Whether the error of the iterate is within the tolerance. The correction just made was for the residual before; what
/// is left of it shrank as the residual did.
bool Newton::is_small(const Progress& progress, double residual, double tolerance) {
    const double error = progress.residual > 0.0 ? progress.correction * residual / progress.residual : 0.0;
    return progress.solved || error <= tolerance;
}

/// The first solve with a new factor sets what a solve costs; more than that is owed to the factor's age.
void Newton::count_solves(const Krylov::Result& result) {
    now_.counters.linear_iterations += result.solves;
    ++now_.counters.newton_iterations;
    factors_.count_solves(result.solves);
    if (!result.converged) {
        factors_.wear_out();
    }
}

/// A temperature below a fifth of the present one is an overshoot of the linear model, unless the balance is linear.
void Newton::add_damped_correction(std::span<double> T, bool linear) const {
    const auto damping_of = [&](std::size_t begin, std::size_t end) {
        double damping = 1.0;
        for (std::size_t i = begin; i < end; ++i) {
            if (correction_[i] < -0.8 * T[i]) {
                damping = std::min(damping, -0.5 * T[i] / correction_[i]);
            }
        }
        return damping;
    };
    const auto smaller = [](double a, double b) { return std::min(a, b); };
    const double damping = linear ? 1.0 : joined_over_ranges(correction_.size(), damping_of, smaller);
    over_nodes(correction_.size(), [&](std::size_t i) { T[i] += damping * correction_[i]; });
}

/// One correction by Newton's method with the matrices of the iterate.
Status Newton::correct(const Stage& stage, std::span<double> T, Progress& progress) {
    if (Status status = prepare(stage); !status.ok()) {
        return status;
    }
    const Stopwatch watch(timed_ ? &now_.counters.solve_seconds : nullptr);
    const bool linear = is_linear();
    const Krylov::Result result = krylov_.solve(J_, factors_.current(), residual_, correction_, remainder_,
                                                0.5 * stage.tolerance, linear ? 0.0 : forcing);
    count_solves(result);
    progress.solved = linear && result.converged;
    progress.polished = false;
    progress.correction = close_linearised_budget();
    if (++progress.corrections > unsearched) {
        search_along_correction(stage, T);
    }
    add_damped_correction(T, linear);
    return {};
}

Status Newton::solve(const Stage& stage, std::span<double> T) {
    if (solve_simplified(stage, T)) {
        return {};
    }
    Progress progress;
    int stalled = 0;
    for (int iteration = 0; iteration <= most_iterations; ++iteration) {
        if (Status status = evaluate(stage, T); !status.ok()) {
            return status;
        }
        if (iteration == 0) {
            assemble(stage);  // the residual is scaled by its diagonal
        }
        const double residual = scaled_residual();
        const bool small = iteration > 0 && is_small(progress, residual, stage.tolerance);
        stalled += small ? 1 : 0;
        progress.polish_spoils = progress.polish_spoils || (progress.polished && !small);
        if (small && (!stage.closed || closes_heat_budget(stage) || stalled > max_stalled)) {
            return {};
        }
        if (small && (factors_.current().is_exact() || stalled > max_stalled / 2)) {
            // The field is as good as found: what is left needs no new matrix, and after that only the mean still has to
            // close the heat budget to the last digit.
            const bool only_mean = progress.polished || progress.polish_spoils || !factors_.current().is_exact();
            progress.correction = only_mean ? shift_all(T) : polish(T);
            progress.polished = true;
        } else {
            if (iteration > 0) {
                assemble(stage);
            }
            if (iteration == most_iterations) {
                break;
            }
            if (Status status = correct(stage, T, progress); !status.ok()) {
                return status;
            }
        }
        progress.residual = residual;
    }
    const auto lowest = std::min_element(T.begin(), T.end());
    if (*lowest < absolute_zero) {
        return system_->failure_at(Outcome::not_converged,
                                   stage.steady
                                       ? "the way to the steady state leads below the absolute zero"
                                       : "the step is too long: its heat balance leads below the absolute zero",
                                   static_cast<int>(lowest - T.begin()), stage.time, T, stage.coefficients);
    }
    return system_->failure_at(Outcome::not_converged, "the heat balance did not converge", now_.worst_node, stage.time,
                               T, stage.coefficients);
}

void Newton::visit(Archive& archive) {
    archive(now_);
    archive(factors_);
}

void Newton::filter(std::span<const double> b, std::span<double> x) {
    const Stopwatch watch(timed_ ? &now_.counters.solve_seconds : nullptr);
    const int solves = factors_.current().solve_to(one_digit, b, x);
    now_.counters.linear_iterations += std::max(1, solves);
    if (solves < 0) {
        factors_.current().solve(b, x);
    }
}

}  // namespace tiretherm::solver
