// SPDX-License-Identifier: BSD-3-Clause
// Interface of a factorised symmetric positive definite matrix: all that the solver knows about linear algebra
// libraries.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "solver/linear/matrix.hpp"
#include "solver/linear/panel.hpp"

namespace tiretherm::solver {

/// Which factor stands behind the linear systems; `automatic` looks at the fill that CHOLMOD's analysis predicts.
enum class LinearSolver : std::uint8_t { automatic, cholesky, conjugate_gradient };

/// An approximate or exact inverse of a symmetric positive definite matrix: the only thing the solver knows about
/// linear algebra libraries. The pattern is analysed in the constructor; after `factorise`, solves allocate nothing.
class Factor {
public:
    Factor() = default;
    Factor(const Factor&) = delete;
    Factor& operator=(const Factor&) = delete;
    virtual ~Factor() = default;

    /// @returns an empty text, or a sentence saying what is wrong with the matrix
    [[nodiscard]] virtual std::string factorise(const Matrix& matrix) = 0;
    /// The lower triangle that was last factorised, from which `factorise_again` makes the same factor to the last digit.
    [[nodiscard]] virtual std::span<const double> values() const = 0;
    /// @param values [values().size()]  @returns as `factorise`
    [[nodiscard]] virtual std::string factorise_again(std::span<const double> values) = 0;
    /// x = M^-1 b, with M the matrix last factorised. b and x do not overlap.
    virtual void solve(std::span<const double> b, std::span<double> x) = 0;
    /// x = A^-1 b, with A the matrix last factorised, to a relative accuracy in its energy. b and x do not overlap.
    /// @returns solves made; -1: it did not converge, and x is of no use
    virtual int solve_to(double /*accuracy*/, std::span<const double> b, std::span<double> x) {
        solve(b, x);
        return 1;
    }
    /// The same for a panel of right-hand sides.
    virtual void solve_panel(ConstPanel B, Panel X) {
        const std::size_t n = B.size();
        column_.resize(2 * n);
        const std::span<double> b = std::span(column_).first(n);
        const std::span<double> x = std::span(column_).last(n);
        for (std::size_t c = 0; c < panel_width; ++c) {
            for (std::size_t i = 0; i < n; ++i) {
                b[i] = B[i][c];
            }
            solve(b, x);
            for (std::size_t i = 0; i < n; ++i) {
                X[i].set(c, x[i]);
            }
        }
    }
    /// Another factor of the same pattern, which is not analysed again; not yet usable. Null where only one is ever of use.
    [[nodiscard]] virtual std::unique_ptr<Factor> alike() const { return nullptr; }
    /// Cost of a factorisation in units of one solve, from the analysis: decides when a new one pays.
    [[nodiscard]] virtual double factor_cost() const = 0;
    /// Whether `solve` is exact for the matrix that was factorised.
    [[nodiscard]] virtual bool is_exact() const = 0;
    [[nodiscard]] virtual std::string description() const = 0;

private:
    std::vector<double> column_;  ///< [2][n] of `solve_panel`
};

/// Sparse Cholesky factor by CHOLMOD.
[[nodiscard]] std::unique_ptr<Factor> make_cholesky(const Pattern& pattern);
/// Incomplete Cholesky factor without fill that keeps row sums, to precondition conjugate gradients.
[[nodiscard]] std::unique_ptr<Factor> make_incomplete_cholesky(const Pattern& pattern);
/// `automatic`: CHOLMOD unless its analysis predicts a fill at which incomplete Cholesky is faster.
[[nodiscard]] std::unique_ptr<Factor> make_factor(const Pattern& pattern, LinearSolver wanted);

}  // namespace tiretherm::solver
