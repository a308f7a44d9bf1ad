// SPDX-License-Identifier: BSD-3-Clause
// Iterative solver for J x = b with a preconditioner: truncated generalised conjugate residuals, Orthomin(k)
// (Eisenstat, Elman & Schultz 1983).
#pragma once

#include <span>
#include <vector>

#include "solver/linear/factor.hpp"
#include "solver/linear/matrix.hpp"

namespace tiretherm::solver {

/// Preconditioned iteration for J x = b by truncated generalised conjugate residuals, Orthomin(k): Eisenstat, Elman and
/// Schultz, SIAM J. Numer. Anal. 20 (1983) 345-357. For a symmetric J it is the method of conjugate residuals; for the
/// mildly unsymmetric Jacobian of k(T), h(T) and laws of region means it keeps the cost of one solve an iteration.
/// Lengths and angles are taken with M^-1, in which a symmetric J stays symmetric under the preconditioner M. With an
/// exact fresh factor of J it ends after one solve. Buffers are allocated once.
class Krylov {
public:
    /// A large mesh, of which many runs never ask for it, gets its memory with the first solution.
    explicit Krylov(int n);

    struct Result {
        bool converged = false;
        int solves = 0;  ///< applications of the factor
    };

    /// The error of x is J^-1 (b - J x). It may be larger than the preconditioned residual M^-1 (b - J x), by up to the
    /// inverse of the smallest eigenvalue of M^-1 J. In a time step that is near one; in a steady state of layers whose
    /// conductivities differ much it is far below.
    /// @param x [n] out, the solution; starts from zero
    /// @param residual [n] out, b - J x
    /// @param tolerance largest entry of M^-1 (b - J x), over the smallest eigenvalue met (a Rayleigh quotient of the
    /// directions), in the units of x
    /// @param relative_tolerance the same beside the largest entry of M^-1 b; the looser of the two ends the iteration
    [[nodiscard]] Result solve(const Matrix& J, Factor& factor, std::span<const double> b, std::span<double> x,
                               std::span<double> residual, double tolerance, double relative_tolerance);

private:
    static constexpr std::size_t directions = 2;  ///< how many past directions a new one is made orthogonal to

    struct Direction {
        std::vector<double> p;
        std::vector<double> Jp;
        std::vector<double> s;  ///< M^-1 J p
        double length2 = 0.0;   ///< Jp' s
    };
    void take_memory(std::size_t n);
    static void make_orthogonal(Direction& now, const Direction& old);

    std::vector<Direction> past_;
    std::vector<double> z_;
};

}  // namespace tiretherm::solver
