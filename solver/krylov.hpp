#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/factor.hpp"
#include "solver/matrix.hpp"

namespace tiretherm::solver {

/// Preconditioned iteration for J x = b: conjugate gradients while J is symmetric, otherwise BiCGStab (van der Vorst
/// 1992). With an exact fresh factor of a symmetric J it ends after one solve. Buffers are allocated once.
class Krylov {
public:
    explicit Krylov(int n);

    struct Result {
        bool converged = false;
        int solves = 0;  ///< applications of the factor
    };

    /// @param x [n] out, the solution; starts from zero
    /// @param residual [n] out, b - J x
    /// @param tolerance largest entry of M^-1 (b - J x), in the units of x
    [[nodiscard]] Result solve(const Matrix& J, Factor& factor, std::span<const double> b, std::span<double> x,
                               std::span<double> residual, double tolerance, double relative_tolerance);

private:
    [[nodiscard]] Result conjugate_gradients(const Matrix& J, Factor& factor, std::span<double> x, std::span<double> r,
                                             double tolerance, double relative_tolerance);
    [[nodiscard]] Result bicgstab(const Matrix& J, Factor& factor, std::span<double> x, std::span<double> r,
                                  double tolerance, double relative_tolerance);

    std::array<std::vector<double>, 6> work_;
};

}  // namespace tiretherm::solver
