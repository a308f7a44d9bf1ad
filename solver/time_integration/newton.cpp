// SPDX-License-Identifier: BSD-3-Clause
// Damped Newton iteration; a factor is kept until its age has cost more solves than a new one. A constant shift of all
// temperatures closes the energy balance of the mesh.

#include "solver/time_integration/newton.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace tiretherm::solver {

namespace {

constexpr int most_iterations = 50;
/// Corrections after which the next ones are searched along: by then a smooth balance has converged.
constexpr int unsearched = 6;
/// Trials of one search along a correction.
constexpr int most_trials = 30;
/// Newton's corrections need only this relative accuracy of the linear solution: the next one mends the rest.
constexpr double forcing = 1e-3;
/// The share of the heat turned over in a stage by which its heat budget may fail to close.
constexpr double energy_closure = 1e-11;
/// Corrections after which a balance that is solved but not closed to the last digit is taken as it is.
constexpr int max_stalled = 8;
/// An iteration that was held back down to here would go on below the absolute zero. K
constexpr double absolute_zero = 1e-3;
/// A move of all temperatures from which the slope of the balance is learnt whatever it is. K
constexpr double smallest_learnt = 1e-9;

class Stopwatch {
public:
    explicit Stopwatch(double& total) : total_(&total), start_(std::chrono::steady_clock::now()) {}
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() { *total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    double* total_;
    std::chrono::steady_clock::time_point start_;
};

double sum(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

Newton::Newton(System& system)
    : system_(&system),
      factor_(make_factor(system.pattern(), system.problem().settings.linear_solver)),
      krylov_(system.size()) {
    const auto n = static_cast<std::size_t>(system.size());
    for (std::vector<double>* v : {&residual_, &correction_, &remainder_, &J_ones_, &enthalpy_, &trial_}) {
        v->resize(n);
    }
    ones_.assign(n, 1.0);
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
        std::fill(enthalpy_.begin(), enthalpy_.end(), 0.0);
    } else {
        system_->enthalpy(T, enthalpy_);
    }
    for (std::size_t i = 0; i < residual_.size(); ++i) {
        residual_[i] = stage.known[i] + stage.s * q[i] - enthalpy_[i];
    }
}

/// Largest residual over its diagonal: an estimate in kelvin that needs no solve. Also finds the worst node.
double Newton::scaled_residual() {
    const Pattern& p = system_->pattern();
    double worst = 0.0;
    for (std::size_t i = 0; i < residual_.size(); ++i) {
        const double scaled = std::abs(residual_[i]) / A_.value[static_cast<std::size_t>(p.diagonal[i])];
        if (scaled > worst) {
            worst = scaled;
            worst_node_ = static_cast<int>(i);
        }
    }
    return worst;
}

/// Whether the heat budget of the stage closes: the balance of the whole mesh, beside the heat turned over and the
/// round-off of the enthalpies that it is a difference of.
bool Newton::closes_heat_budget(const Stage& stage) const {
    double turnover = 0.0;
    for (const double w : system_->terms().watts) {
        turnover += std::abs(w);
    }
    return std::abs(sum(residual_)) <= energy_closure * stage.s * turnover + 4e-16 * sum(enthalpy_);
}

/// Factorises when there is no usable factor, when the step has changed too much for the old one, or when the solves
/// that a fresh factor would have saved have cost more than it does.
Status Newton::prepare(const Stage& stage) {
    if (has_factor_for(stage.s) && excess_solves_ < factor_->factor_cost()) {
        return {};
    }
    const Stopwatch watch(counters_.factor_seconds);
    ++counters_.factorisations;
    factored_s_ = 0.0;
    if (std::string problem = factor_->factorise(A_); !problem.empty()) {
        return {Outcome::not_positive_definite, fmt::format("{}, at t = {:.6g} s", problem, stage.time)};
    }
    factored_s_ = stage.s;
    fresh_solves_ = 0;
    excess_solves_ = 0.0;
    return {};
}

void Newton::assemble(const Stage& stage) {
    const Stopwatch watch(counters_.assembly_seconds);
    system_->matrices(stage.s, stage.steady, A_, J_);
}

/// One correction with the matrices at hand, and the constant that closes the balance of the whole mesh. @returns the
/// largest change, K
double Newton::polish(std::span<double> T) {
    const Stopwatch watch(counters_.solve_seconds);
    last_shift_ = 0.0;
    factor_->solve(residual_, correction_);
    ++counters_.linear_iterations;
    J_.multiply(correction_, remainder_);
    const double left = sum(residual_) - sum(remainder_);
    const double shift = weight_ != 0.0 ? left / weight_ : 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < T.size(); ++i) {
        T[i] += correction_[i] + shift;
        largest = std::max(largest, std::abs(correction_[i] + shift));
    }
    return largest;
}

/// Moves every temperature by the constant that closes the balance of the whole mesh, whose slope is learnt from one
/// such move to the next. @returns K
double Newton::shift_all(std::span<double> T) {
    const double joules = sum(residual_);
    if (last_shift_ != 0.0) {
        const double slope = (last_joules_ - joules) / last_shift_;
        // Of a move near round-off only what is plausible; of a larger one anything that rises: a law may have a kink there.
        const bool kink = std::abs(last_shift_) > smallest_learnt && slope > 0.0;
        weight_ = kink || (slope > 0.5 * weight_ && slope < 2.0 * weight_) ? slope : weight_;
    }
    last_joules_ = joules;
    last_shift_ = weight_ != 0.0 ? joules / weight_ : 0.0;
    for (double& t : T) {
        t += last_shift_;
    }
    return std::abs(last_shift_);
}

/// The balance at T, and its residual; not done when it is not a number or an effect gave a negative conductance.
Status Newton::evaluate(const Stage& stage, std::span<const double> T) {
    {
        const Stopwatch watch(counters_.assembly_seconds);
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
    counters_.linear_iterations += result.solves;
    ++counters_.newton_iterations;
    fresh_solves_ = fresh_solves_ == 0 ? std::max(1, result.solves) : fresh_solves_;
    excess_solves_ += std::max(0, result.solves - fresh_solves_);
    if (!result.converged) {
        excess_solves_ = 2.0 * factor_->factor_cost();  // a fresh factor next time
    }
}

/// Shifts the correction by the constant that makes the linearised balance of the whole mesh exact. @returns its size, K
double Newton::close_linearised_budget() {
    J_.multiply(ones_, J_ones_);
    weight_ = sum(J_ones_);
    const double shift = weight_ != 0.0 ? sum(remainder_) / weight_ : 0.0;
    double largest = 0.0;
    for (double& change : correction_) {
        change += shift;
        largest = std::max(largest, std::abs(change));
    }
    return largest;
}

/// A temperature below a fifth of the present one is an overshoot of the linear model, unless the balance is linear.
void Newton::add_damped_correction(std::span<double> T, bool linear) const {
    double damping = 1.0;
    for (std::size_t i = 0; i < correction_.size() && !linear; ++i) {
        if (correction_[i] < -0.8 * T[i]) {
            damping = std::min(damping, -0.5 * T[i] / correction_[i]);
        }
    }
    for (std::size_t i = 0; i < correction_.size(); ++i) {
        T[i] += damping * correction_[i];
    }
}

/// The residual along the correction at a share of it: zero where the heat balance, were it that of an energy, is at its
/// least on the way. @returns K J
double Newton::residual_along(const Stage& stage, std::span<const double> from, double share) {
    for (std::size_t i = 0; i < from.size(); ++i) {
        trial_[i] = from[i] + share * correction_[i];
    }
    system_->evaluate(trial_, stage.coefficients);
    find_residual(stage, trial_);
    return std::inner_product(residual_.begin(), residual_.end(), correction_.begin(), 0.0);
}

/// Shortens a correction that jumps over a kink of a law, such as a peak of c(T): enthalpies grow with temperature, so that
/// the residual along the correction falls, and the share of it is sought where that is nearly zero (regula falsi, Illinois).
void Newton::search_along_correction(const Stage& stage, std::span<const double> T) {
    const double start = std::inner_product(residual_.begin(), residual_.end(), correction_.begin(), 0.0);
    double share = 1.0;
    double low = 0.0;
    double at_low = start;
    double high = 1.0;
    double at_high = residual_along(stage, T, high);
    if (at_high > 0.0 || !(start > 0.0)) {
        return;
    }
    for (int trial = 0; trial < most_trials; ++trial) {
        const double chord = low + (high - low) * at_low / (at_low - at_high);
        share = std::isfinite(chord) && trial % 3 != 2 ? chord : 0.5 * (low + high);
        const double at_share = residual_along(stage, T, share);
        if (std::abs(at_share) <= 0.1 * start) {
            break;
        }
        if (at_share > 0.0) {
            low = share;
            at_low = at_share;
            at_high *= 0.5;
        } else {
            high = share;
            at_high = at_share;
            at_low *= 0.5;
        }
    }
    for (double& change : correction_) {
        change *= share;
    }
}

/// One correction by Newton's method with the matrices of the iterate.
Status Newton::correct(const Stage& stage, std::span<double> T, Progress& progress) {
    if (Status status = prepare(stage); !status.ok()) {
        return status;
    }
    const Stopwatch watch(counters_.solve_seconds);
    const bool linear = !system_->terms().nonlinear && !has_nonlinear_capacity_;
    const Krylov::Result result =
        krylov_.solve(J_, *factor_, residual_, correction_, remainder_, 0.5 * stage.tolerance, linear ? 0.0 : forcing);
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
        if (small && (closes_heat_budget(stage) || stalled > max_stalled)) {
            return {};
        }
        if (small && (factor_->is_exact() || stalled > max_stalled / 2)) {
            // The field is as good as found: what is left needs no new matrix, and after that only the mean still has to
            // close the heat budget to the last digit.
            const bool only_mean = progress.polished || progress.polish_spoils || !factor_->is_exact();
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
                                   "the step is too long: its heat balance leads below the absolute zero",
                                   static_cast<int>(lowest - T.begin()), stage.time, T, stage.coefficients);
    }
    return system_->failure_at(Outcome::not_converged, "the heat balance did not converge", worst_node_, stage.time, T,
                               stage.coefficients);
}

void Newton::visit(Archive& archive) {
    for (double* number : {&weight_, &last_shift_, &last_joules_, &reach_, &factored_s_, &excess_solves_,
                           &counters_.assembly_seconds, &counters_.factor_seconds, &counters_.solve_seconds}) {
        archive(*number);
    }
    for (long* count : {&counters_.newton_iterations, &counters_.linear_iterations, &counters_.factorisations}) {
        archive.whole(*count);
    }
    archive.whole(worst_node_);
    archive.whole(fresh_solves_);
    if (!factor_->is_exact()) {  // the filter looks at the matrix last assembled
        bool assembled = !A_.value.empty();
        archive.whole(assembled);
        A_.value.resize(assembled ? system_->pattern().nonzeros() : 0);
        A_.pattern = &system_->pattern();
        archive(A_.value);
    }
    if (factored_s_ > 0.0) {
        std::vector<double> values(factor_->values().begin(), factor_->values().end());
        archive(values);
        if (archive.is_reading() && !factor_->factorise_again(values).empty()) {
            factored_s_ = 0.0;
        }
    }
}

void Newton::filter(std::span<const double> b, std::span<double> x) {
    const Stopwatch watch(counters_.solve_seconds);
    // An error estimate is wanted to one digit only: an exact factor of a step nearby is enough.
    if (factor_->is_exact()) {
        factor_->solve(b, x);
        ++counters_.linear_iterations;
        return;
    }
    counters_.linear_iterations += krylov_.solve(A_, *factor_, b, x, remainder_, 0.0, 0.1).solves;
}

}  // namespace tiretherm::solver
