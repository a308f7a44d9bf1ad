// SPDX-License-Identifier: BSD-3-Clause
// Solves one implicit stage H(T) - s q(T) = known by Newton's method, iterating on the kept factor of A = C + s K; the
// heat budget closes to round-off.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "solver/linear/krylov.hpp"
#include "solver/system.hpp"
#include "solver/time_integration/checkpoint.hpp"
#include "solver/time_integration/kept_factors.hpp"

namespace tiretherm::solver {

/// Work done, for the report.
struct Counters {
    long newton_iterations = 0;
    long linear_iterations = 0;
    long factorisations = 0;
    double assembly_seconds = 0.0;
    double factor_seconds = 0.0;
    double solve_seconds = 0.0;
};

/// Solves one implicit stage,   H(T) - s q(T) = known,   by Newton's method. It starts with the simplified one: the kept
/// factor of A = C + s K stands for the Jacobian, so that a correction costs one solve and no matrix (Hairer and Wanner,
/// Solving Ordinary Differential Equations II, IV.8). Where that contracts too slowly, each correction solves the
/// unsymmetric Jacobian by iteration on the kept factor; a new factor is made when it pays.
///
/// Every correction of Newton's own is shifted by the constant that makes the linearised energy balance of the whole mesh
/// exact. What the last iterate leaves of the balance is told (`left`), so that a stepper can carry it into its next
/// step; a stage that asks for it closes its heat budget to round-off.
class Newton {
public:
    explicit Newton(System& system);

    struct Stage {
        double s = 0.0;                        ///< s, step times the method's diagonal coefficient
        std::span<const double> known;         ///< [n_nodes] J
        std::span<const double> coefficients;  ///< [n_coefficients]
        double time = 0.0;                     ///< s, for messages
        double tolerance = 1e-9;               ///< K
        bool steady = false;                   ///< -q(T) = known, without capacity
        bool closed = true;                    ///< whether the heat budget must close to round-off
    };

    /// @param T [n_nodes] K, in: a guess; out: the solution, at which the system has been evaluated
    [[nodiscard]] Status solve(const Stage& stage, std::span<double> T);

    /// What the last solution leaves of the balance: known + s q(T) - H(T). @returns [n_nodes] J
    [[nodiscard]] std::span<const double> left() const { return residual_; }

    /// x = A^-1 b, to one digit: filters the error estimate of a step into kelvin; a factor of a step nearby is enough.
    /// @pre a factor is at hand
    void filter(std::span<const double> b, std::span<double> x);

    /// One over the heat capacities in the matrix behind `filter`. @returns [n_nodes] K/J
    [[nodiscard]] std::span<const double> compliance() const { return factors_.compliance(); }

    /// Whether a factor at hand serves a stage of this length; `filter` uses it from now on.
    [[nodiscard]] bool has_factor_for(double s) { return factors_.select(s); }

    /// The state between two steps: what the next ones depend on, the factor included.
    void visit(Archive& archive);

    /// Whether a factor serves the steps of its length without iteration, and costs more than a solve.
    [[nodiscard]] bool keeps_factors() const { return factors_.current().is_exact(); }

    /// Lets the factor serve others: sensitivities and adjoints of the same steps.
    [[nodiscard]] Factor& factor() { return factors_.current(); }
    /// A factor serves stages up to this many times longer or shorter than its own. @param ratio > 1
    void set_reach(double ratio) { factors_.set_reach(ratio); }
    /// Solves that others needed because the factor is old count when a new one is weighed up.
    void add_excess_solves(double solves) { factors_.add_excess_solves(solves); }

    [[nodiscard]] const Counters& counters() const { return now_.counters; }
    /// Leaves the seconds of the parts uncounted: in real time, looking at the clock costs as much as a small effect.
    void stop_timing() { timed_ = false; }
    /// Whether the balance last evaluated is linear in the temperatures.
    [[nodiscard]] bool is_linear() const { return !system_->terms().nonlinear && !has_nonlinear_capacity_; }
    [[nodiscard]] std::string linear_solver() const { return factors_.current().description(); }

private:
    /// Corrections after which a balance that is solved but not closed to the last digit is taken as it is.
    static constexpr int max_stalled = 8;

    /// Where an iteration stands.
    struct Progress {
        double residual = 0.0;       ///< K, scaled residual of the iterate before
        double correction = 0.0;     ///< K, size of the last correction
        int corrections = 0;         ///< made by Newton's method
        bool solved = false;         ///< the balance is linear and its one correction is made
        bool polished = false;       ///< the last correction was made with the matrices at hand
        bool polish_spoils = false;  ///< such a correction led away: a law has a kink near the solution
    };
    [[nodiscard]] bool solve_simplified(const Stage& stage, std::span<double> T);
    [[nodiscard]] bool correct_simplified(const Stage& stage, std::span<double> T);
    void correct_surfaces(double s);
    [[nodiscard]] bool close_by_shifts(const Stage& stage, std::span<double> T);
    [[nodiscard]] double bound_of_error(double s) const;
    [[nodiscard]] Status evaluate(const Stage& stage, std::span<const double> T);
    [[nodiscard]] static bool is_small(const Progress& progress, double residual, double tolerance);
    [[nodiscard]] Status correct(const Stage& stage, std::span<double> T, Progress& progress);
    [[nodiscard]] double residual_along(const Stage& stage, std::span<const double> from, double share);
    void search_along_correction(const Stage& stage, std::span<const double> T);
    void count_solves(const Krylov::Result& result);
    double close_linearised_budget();
    void add_damped_correction(std::span<double> T, bool linear) const;
    [[nodiscard]] bool renew_for(const Stage& stage);
    [[nodiscard]] Status prepare(const Stage& stage);
    [[nodiscard]] Status renew(const Stage& stage);
    [[nodiscard]] double scaled_residual();
    [[nodiscard]] bool closes_heat_budget(const Stage& stage) const;
    void assemble(const Stage& stage);
    double polish(std::span<double> T);
    double shift_all(std::span<double> T);
    void find_residual(const Stage& stage, std::span<const double> T);

    System* system_;
    KeptFactors factors_;
    Krylov krylov_;
    Matrix A_;
    Matrix J_;
    std::vector<double> residual_;
    std::vector<double> correction_;
    std::vector<double> remainder_;
    std::vector<double> ones_;
    std::vector<double> J_ones_;
    std::vector<double> enthalpy_;
    std::vector<double> compliance_;  ///< of the matrices at hand, see KeptFactors
    std::vector<double> guess_;       ///< K
    /// A face that joins a surface without capacity to a cell.
    struct SurfaceFace {
        int face;
        int surface;
        int cell;
        bool surface_is_a;
    };
    std::vector<SurfaceFace> surface_faces_;
    std::vector<double> trial_;  ///< K, of a search along a correction
    bool has_nonlinear_capacity_ = false;
    /// What later stages depend on, beside the factors.
    struct State {
        int worst_node = 0;
        double weight = 0.0;      ///< J/K, what the balance of the whole mesh changes by when every temperature does
        double last_shift = 0.0;  ///< K, and the imbalance that it was for
        double last_joules = 0.0;
        double sharpness = 1.0;  ///< of the iterated corrections' accuracy: below 1 where they must be better
        Counters counters;
    };
    State now_;
    bool timed_ = true;
};

}  // namespace tiretherm::solver
