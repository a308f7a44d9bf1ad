// SPDX-License-Identifier: BSD-3-Clause
// Corrections by the factor at hand alone, without matrices, as long as they contract; what is left of the error is bounded by the
// maximum principle.
#include "solver/time_integration/newton.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/parallel.hpp"
#include "solver/time_integration/stopwatch.hpp"

namespace tiretherm::solver {

namespace {

/// Corrections with A alone, before Newton's own: with a kept factor, or by iteration with a matrix of this stage.
constexpr int most_simplified = 4;
constexpr int most_iterated = 8;
/// A correction larger than this share of the one before it is no contraction worth waiting for.
constexpr double slow_contraction = 0.3;
constexpr double slow_iterated = 0.6;
/// A correction by iteration is found to this accuracy: the next one mends what A leaves out of the Jacobian as well.
constexpr double accuracy_of_iteration = 0.03;
/// That accuracy is one of the energy, in which cells much smaller than the others hardly weigh: where the corrections do not contract,
/// it is sharpened by this factor, and the stages after it keep to that; twice at most.
constexpr double sharpening = 0.1;
constexpr double sharpest = 0.011;
/// A guess whose error is below this share of the tolerance needs no correction: in a session at 1 kHz, most.
constexpr double guess_share = 0.02;
/// A correction this large is Newton's own business, which is damped. K
constexpr double far = 20.0;

}  // namespace

/// The largest error in kelvin that the residual allows: A has row sums of at least C, so that the error of cells is at
/// most the largest residual over C (maximum principle); that of a surface without capacity, which passes its residual on
/// to its cell, is at most its residual over its own row beside that.
double Newton::bound_of_error(double s) const {
    const std::span<const double> compliance = factors_.compliance();
    const auto cells = static_cast<std::size_t>(system_->problem().mesh.n_cells);
    const auto larger = [](double a, double b) { return a > b ? a : b; };
    const auto bound_of_range = [&](std::size_t begin, std::size_t end) {
        const auto take = [&](double most, std::size_t i) {
            return larger(std::abs(residual_[i]) * compliance[i], most);
        };
        return fold_side_by_side(begin, end, 0.0, take, larger);
    };
    double of_cells = joined_over_ranges(cells, bound_of_range, larger);
    double of_surfaces = 0.0;
    for (std::size_t i = cells; i < residual_.size(); ++i) {
        double& bound = system_->has_capacity(i) ? of_cells : of_surfaces;
        bound = std::max(bound, std::abs(residual_[i]) * compliance[i]);
    }
    return of_cells + of_surfaces / s;
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
    double accuracy = now_.sharpness * accuracy_of_iteration;
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
        const Stopwatch watch(timed_ ? &now_.counters.solve_seconds : nullptr);
        const int solves = factors_.current().solve_to(accuracy, residual_, correction_);
        now_.counters.linear_iterations += std::max(1, solves);
        ++now_.counters.newton_iterations;
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
        const double size =
            largest_over_nodes(correction_.size(), [&](std::size_t i) { return std::abs(correction_[i]); }).value;
        const bool slow = correction > 1 && size > (kept ? slow_contraction : slow_iterated) * before;
        if (!(size < far) || (slow && (kept || now_.sharpness < sharpest))) {
            return false;
        }
        now_.sharpness *= slow ? sharpening : 1.0;
        over_nodes(T.size(), [&](std::size_t i) { T[i] += correction_[i]; });
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
        accuracy = now_.sharpness * std::clamp(0.5 * stage.tolerance / next, accuracy_of_iteration, 0.5);
        before = size;
    }
    return false;
}

/// A factor of A at this evaluation: for one that costs no more than a solve. @returns false where A has none
bool Newton::renew_for(const Stage& stage) {
    {
        const Stopwatch watch(timed_ ? &now_.counters.assembly_seconds : nullptr);
        system_->symmetric_matrix(stage.s, stage.steady, A_);
    }
    return renew(stage).ok();
}

/// The stage with the factor at hand alone. @returns false where Newton's own corrections must do it; T is the guess then
bool Newton::solve_simplified(const Stage& stage, std::span<double> T) {
    if (stage.steady || (factors_.current().is_exact() && (!factors_.select(stage.s) || factors_.is_worn_out()))) {
        return false;
    }
    copy_nodes(T, guess_);
    const long before = now_.counters.newton_iterations;
    const bool solved = correct_simplified(stage, T) && (!stage.closed || close_by_shifts(stage, T));
    factors_.count_corrections(static_cast<int>(now_.counters.newton_iterations - before));
    if (solved) {
        return true;
    }
    copy_nodes(guess_, T);
    factors_.wear_out();
    return false;
}

}  // namespace tiretherm::solver
