// SPDX-License-Identifier: BSD-3-Clause
// Factors of A = C + s K for the step lengths in use, kept over many steps; knows when a new one pays.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solver/linear/factor.hpp"
#include "solver/problem.hpp"
#include "solver/time_integration/checkpoint.hpp"

namespace tiretherm::solver {

/// A few factors of A = C + s K, one for each step length s [s] in use: over a log, steps of 1, 2, 4 samples take turns.
/// A factor serves while the solves that its age costs are fewer than those that a new one would. Exact factors of small
/// meshes are kept four at a time, two while steps only grow, others one.
class KeptFactors {
public:
    KeptFactors(const Pattern& pattern, LinearSolver wanted);

    /// Makes the factor current whose s is nearest, within reach. @returns false where there is none
    bool select(double s);
    [[nodiscard]] bool has_current() const { return now_->s > 0.0; }
    /// s of the current factor. @returns s, 0: none
    [[nodiscard]] double s() const { return now_->s; }
    [[nodiscard]] Factor& current() { return *now_->factor; }
    [[nodiscard]] const Factor& current() const { return *now_->factor; }
    /// What a residual is weighed by: one over the heat capacity of each cell [K/J], and of a surface without one s over its
    /// own row [K/W], of the matrix that the current factor is of. @returns [n_nodes]
    [[nodiscard]] std::span<const double> compliance() const { return now_->compliance; }

    /// Whether a new factor costs less than the solves lost with the current one.
    [[nodiscard]] bool is_worn_out() const { return now_->excess_solves >= now_->factor->factor_cost(); }
    /// Solves that a correction took: the first ones with a new factor set what is least.
    void count_solves(int solves);
    /// The same of the corrections of a simplified iteration, each with its evaluation of the effects.
    void count_corrections(int corrections);
    void add_excess_solves(double solves) { now_->excess_solves += solves; }
    void wear_out() { now_->excess_solves = 2.0 * now_->factor->factor_cost(); }

    /// A new factor, in the place of the worn-out one of this s or of the one that was longest out of use.
    /// @param compliance [n_nodes] see compliance()  @returns as Factor::factorise
    [[nodiscard]] std::string renew(const Matrix& A, double s, std::span<const double> compliance);

    /// A factor serves stages up to this many times longer or shorter than its own. @param ratio > 1
    void set_reach(double ratio) { reach_ = ratio; }

    void visit(Archive& archive);

private:
    /// What is known of a factor, all of it part of a checkpoint.
    struct Use {
        double s = 0.0;              ///< s, 0: not factorised
        int least_solves = 0;        ///< of the first correction; 0: not yet known
        int least_corrections = 0;   ///< of the first simplified iteration
        double excess_solves = 0.0;  ///< solves beyond the least
        long last_used = 0;
    };
    struct Kept : Use {
        std::unique_ptr<Factor> factor;
        std::vector<double> compliance;
    };
    [[nodiscard]] bool reaches(const Kept& kept, double s) const {
        return kept.s > 0.0 && reach_ * s > kept.s && s < reach_ * kept.s;
    }
    void make_current(Kept& kept);

    const Pattern* pattern_;
    std::vector<Kept> kept_;
    Kept* now_;
    long uses_ = 0;
    double reach_ = 1.99;      ///< steps twice as long have a factor of their own
    bool alternates_ = false;  ///< a step length came back to which another factor fitted
};

}  // namespace tiretherm::solver
