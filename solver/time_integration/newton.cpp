// SPDX-License-Identifier: BSD-3-Clause
// Damped Newton iteration; a factor is kept until its age has cost more solves than a new one. A constant shift of all
// temperatures closes the energy balance of the mesh.

#include "solver/time_integration/newton.hpp"

#include <algorithm>
#include <array>
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
/// Corrections with A alone, before Newton's own: with a kept factor, or by iteration with a matrix of this stage.
constexpr int most_simplified = 4;
constexpr int most_iterated = 8;
/// A correction larger than this share of the one before it is no contraction worth waiting for.
constexpr double slow_contraction = 0.3;
constexpr double slow_iterated = 0.6;
/// A correction by iteration is found to this accuracy: the next one mends what A leaves out of the Jacobian as well.
constexpr double accuracy_of_iteration = 0.03;
/// A guess whose error is below this share of the tolerance needs no correction: in a session at 1 kHz, most.
constexpr double guess_share = 0.02;
/// Error estimates are wanted to this.
constexpr double one_digit = 0.1;
/// A correction this large is Newton's own business, which is damped. K
constexpr double far = 20.0;
/// An iteration that was held back down to here would go on below the absolute zero. K
constexpr double absolute_zero = 1e-3;
/// A move of all temperatures from which the slope of the balance is learnt whatever it is. K
constexpr double smallest_learnt = 1e-9;

/// Adds the time until its end to a total, if there is one.
class Stopwatch {
public:
    explicit Stopwatch(double* total) : total_(total) {
        if (total_ != nullptr) {
            start_ = std::chrono::steady_clock::now();
        }
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() {
        if (total_ != nullptr) {
            *total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        }
    }

private:
    double* total_;
    std::chrono::steady_clock::time_point start_;
};

double sum(std::span<const double> values) { return std::accumulate(values.begin(), values.end(), 0.0); }

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
    return factors_.select(stage.s) && !factors_.is_worn_out() ? Status{} : renew(stage);
}

Status Newton::renew(const Stage& stage) {
    const Stopwatch watch(timed_ ? &counters_.factor_seconds : nullptr);
    ++counters_.factorisations;
    const physics::Terms& terms = system_->terms();
    for (std::size_t i = 0; i < compliance_.size(); ++i) {
        compliance_[i] = system_->has_capacity(i)
                             ? 1.0 / system_->capacity(i, terms.temperature[i])
                             : stage.s / A_.value[static_cast<std::size_t>(system_->pattern().diagonal[i])];
    }
    if (std::string problem = factors_.renew(A_, stage.s, compliance_); !problem.empty()) {
        return {Outcome::not_positive_definite, fmt::format("{}, at t = {:.6g} s", problem, stage.time)};
    }
    return {};
}

void Newton::assemble(const Stage& stage) {
    const Stopwatch watch(timed_ ? &counters_.assembly_seconds : nullptr);
    system_->matrices(stage.s, stage.steady, A_, J_);
}

/// The largest error in kelvin that the residual allows: A has row sums of at least C, so that the error of cells is at
/// most the largest residual over C (maximum principle); that of a surface without capacity, which passes its residual on
/// to its cell, is at most its residual over its own row beside that.
double Newton::bound_of_error(double s) const {
    const std::span<const double> compliance = factors_.compliance();
    std::array<double, 4> of_cells{};  // side by side, so that no comparison waits for the one before
    double of_surfaces = 0.0;
    const auto cells = static_cast<std::size_t>(system_->problem().mesh.n_cells);
    std::size_t i = 0;
    for (; i + 4 <= cells; i += 4) {
        for (std::size_t k = 0; k < 4; ++k) {
            const double bound = std::abs(residual_[i + k]) * compliance[i + k];
            of_cells[k] = bound > of_cells[k] ? bound : of_cells[k];
        }
    }
    for (; i < residual_.size(); ++i) {
        double& bound = system_->has_capacity(i) ? of_cells[0] : of_surfaces;
        bound = std::max(bound, std::abs(residual_[i]) * compliance[i]);
    }
    return std::ranges::max(of_cells) + of_surfaces / s;
}

/// Moves all temperatures alike until the heat budget closes. @returns false where that does not lead there
bool Newton::close_by_shifts(const Stage& stage, std::span<double> T) {
    last_shift_ = 0.0;
    for (int shift = 0; shift < max_stalled / 2; ++shift) {
        if (closes_heat_budget(stage)) {
            return true;
        }
        shift_all(T);
        if (!evaluate(stage, T).ok()) {
            return false;
        }
    }
    return closes_heat_budget(stage);
}

/// Surfaces without capacity follow their cells and what acts on them now, not when the factor was made: speed and load
/// change their exchange more than anything else.
void Newton::correct_surfaces(double s) {
    const physics::Terms& terms = system_->terms();
    for (const SurfaceFace& face : surface_faces_) {
        const auto i = static_cast<std::size_t>(face.surface);
        remainder_[i] = residual_[i] / s;
        trial_[i] = terms.node_G[i] - terms.node_slope[i];
    }
    for (const SurfaceFace& face : surface_faces_) {
        const auto f = static_cast<std::size_t>(face.face);
        const auto i = static_cast<std::size_t>(face.surface);
        const double G = terms.face_G[f];
        const double own = face.surface_is_a ? G - terms.face_dq_dTa[f] : G + terms.face_dq_dTb[f];
        const double other = face.surface_is_a ? G + terms.face_dq_dTb[f] : G - terms.face_dq_dTa[f];
        trial_[i] += own;
        remainder_[i] += other * correction_[static_cast<std::size_t>(face.cell)];
    }
    for (const SurfaceFace& face : surface_faces_) {
        const auto i = static_cast<std::size_t>(face.surface);
        correction_[i] = trial_[i] > 0.0 ? remainder_[i] / trial_[i] : correction_[i];
    }
}

/// Corrections by the factor at hand alone, without matrices, while they contract; the system is left evaluated at T.
bool Newton::correct_simplified(const Stage& stage, std::span<double> T) {
    const bool kept = factors_.current().is_exact();
    double accuracy = accuracy_of_iteration;
    double before = 0.0;
    for (int correction = 1; correction <= (kept ? most_simplified : most_iterated); ++correction) {
        if (!evaluate(stage, T).ok()) {
            return false;
        }
        const bool comparable = kept || correction > 1;  // the factor at hand is of this matrix, or near it
        if (comparable && bound_of_error(stage.s) <= (correction > 1 ? 1.0 : guess_share) * stage.tolerance) {
            return true;
        }
        if (!kept && correction == 1 && !renew_for(stage)) {
            return false;
        }
        const Stopwatch watch(timed_ ? &counters_.solve_seconds : nullptr);
        const int solves = factors_.current().solve_to(accuracy, residual_, correction_);
        counters_.linear_iterations += std::max(1, solves);
        ++counters_.newton_iterations;
        if (solves < 0) {
            return false;
        }
        if (kept) {
            // A factor of another step length: a correction between what the two lengths ask for.
            const double relaxation = 2.0 / (1.0 + stage.s / factors_.s());
            for (double& change : correction_) {
                change *= relaxation;
            }
            correct_surfaces(stage.s);
        }
        double size = 0.0;
        for (const double change : correction_) {
            size = std::max(size, std::abs(change));
        }
        if (!(size < far) || (correction > 1 && size > (kept ? slow_contraction : slow_iterated) * before)) {
            return false;
        }
        for (std::size_t i = 0; i < T.size(); ++i) {
            T[i] += correction_[i];
        }
        if (correction > 1 && size * size / before <= stage.tolerance) {
            if (!evaluate(stage, T).ok()) {
                return false;
            }
            // Small corrections of an iteration may be those of one that fails: then the residual has stayed.
            if (kept || scaled_residual() <= stage.tolerance) {
                return true;
            }
        }
        // What the next correction will be is known by its size: it need be no more accurate than the tolerance asks for.
        const double next = correction > 1 ? size * size / before : size * accuracy_of_iteration;
        accuracy = std::clamp(0.5 * stage.tolerance / next, accuracy_of_iteration, 0.5);
        before = size;
    }
    return false;
}

/// A factor of A at this evaluation: for one that costs no more than a solve. @returns false where A has none
bool Newton::renew_for(const Stage& stage) {
    {
        const Stopwatch watch(timed_ ? &counters_.assembly_seconds : nullptr);
        system_->symmetric_matrix(stage.s, stage.steady, A_);
    }
    return renew(stage).ok();
}

/// The stage with the factor at hand alone. @returns false where Newton's own corrections must do it; T is the guess then
bool Newton::solve_simplified(const Stage& stage, std::span<double> T) {
    if (stage.steady || (factors_.current().is_exact() && (!factors_.select(stage.s) || factors_.is_worn_out()))) {
        return false;
    }
    std::ranges::copy(T, guess_.begin());
    const long before = counters_.newton_iterations;
    const bool solved = correct_simplified(stage, T) && (!stage.closed || close_by_shifts(stage, T));
    factors_.count_corrections(static_cast<int>(counters_.newton_iterations - before));
    if (solved) {
        return true;
    }
    std::ranges::copy(guess_, T.begin());
    factors_.wear_out();
    return false;
}

/// One correction with the matrices at hand, and the constant that closes the balance of the whole mesh. @returns the
/// largest change, K
double Newton::polish(std::span<double> T) {
    const Stopwatch watch(timed_ ? &counters_.solve_seconds : nullptr);
    last_shift_ = 0.0;
    factors_.current().solve(residual_, correction_);
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
        const Stopwatch watch(timed_ ? &counters_.assembly_seconds : nullptr);
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
    factors_.count_solves(result.solves);
    if (!result.converged) {
        factors_.wear_out();
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
    const Stopwatch watch(timed_ ? &counters_.solve_seconds : nullptr);
    const bool linear = !system_->terms().nonlinear && !has_nonlinear_capacity_;
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
                                   "the step is too long: its heat balance leads below the absolute zero",
                                   static_cast<int>(lowest - T.begin()), stage.time, T, stage.coefficients);
    }
    return system_->failure_at(Outcome::not_converged, "the heat balance did not converge", worst_node_, stage.time, T,
                               stage.coefficients);
}

void Newton::visit(Archive& archive) {
    for (double* number : {&weight_, &last_shift_, &last_joules_, &counters_.assembly_seconds,
                           &counters_.factor_seconds, &counters_.solve_seconds}) {
        archive(*number);
    }
    for (long* count : {&counters_.newton_iterations, &counters_.linear_iterations, &counters_.factorisations}) {
        archive.whole(*count);
    }
    archive.whole(worst_node_);
    factors_.visit(archive);
}

void Newton::filter(std::span<const double> b, std::span<double> x) {
    const Stopwatch watch(timed_ ? &counters_.solve_seconds : nullptr);
    const int solves = factors_.current().solve_to(one_digit, b, x);
    counters_.linear_iterations += std::max(1, solves);
    if (solves < 0) {
        factors_.current().solve(b, x);
    }
}

}  // namespace tiretherm::solver
