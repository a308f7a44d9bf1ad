// SPDX-License-Identifier: BSD-3-Clause
// A new direction is made orthogonal to two past ones, or to one when J is symmetric; the iteration ends on the
// preconditioned residual M^-1 (b - J x), over the smallest eigenvalue of M^-1 J that the directions have met.

#include "solver/linear/krylov.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

namespace tiretherm::solver {

namespace {

constexpr int most_iterations = 500;
/// A residual this small beside the right-hand side is round-off: no further solve is spent on looking at it.
constexpr double round_off = 1e-13;

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

ConstVector view(std::span<const double> v) { return {v.data(), static_cast<Eigen::Index>(v.size())}; }

double dot(std::span<const double> a, std::span<const double> b) { return view(a).dot(view(b)); }

double largest(std::span<const double> a) { return view(a).lpNorm<Eigen::Infinity>(); }

/// y += s x
void add(double s, std::span<const double> x, std::span<double> y) {
    Vector(y.data(), static_cast<Eigen::Index>(y.size())) += s * view(x);
}

}  // namespace

Krylov::Krylov(int n) : past_(directions + 1), z_(static_cast<std::size_t>(n)) {
    for (Direction& direction : past_) {
        direction.p.resize(z_.size());
        direction.Jp.resize(z_.size());
        direction.s.resize(z_.size());
    }
}

Krylov::Result Krylov::solve(const Matrix& J, Factor& factor, std::span<const double> b, std::span<double> x,
                             std::span<double> residual, double tolerance, double relative_tolerance) {
    const std::span<double> r = residual;
    std::copy(b.begin(), b.end(), r.begin());
    std::fill(x.begin(), x.end(), 0.0);
    Result result;
    const double tiny = round_off * largest(b);
    if (tiny == 0.0) {
        result.converged = true;
        return result;
    }
    // One direction is enough for a symmetric matrix: the others would only repeat round-off.
    const std::size_t memory = J.symmetric && J.outer.empty() ? 1 : directions;
    factor.solve(r, z_);
    result.solves = 1;
    double smallest = 1.0;
    const double wanted = std::max(tolerance, relative_tolerance * largest(z_));
    for (std::size_t k = 0; k < most_iterations; ++k) {
        Direction& now = past_[k % past_.size()];
        std::copy(z_.begin(), z_.end(), now.p.begin());
        J.multiply(now.p, now.Jp);
        if (k == 0) {
            // An exact factor is done here: looking at the residual saves the second solve.
            add(-1.0, now.Jp, r);
            if (largest(r) <= tiny) {
                std::copy(now.p.begin(), now.p.end(), x.begin());
                result.converged = true;
                return result;
            }
            std::copy(b.begin(), b.end(), r.begin());
        }
        factor.solve(now.Jp, now.s);
        ++result.solves;
        for (std::size_t back = 1; back <= std::min(k, memory); ++back) {
            const Direction& old = past_[(k - back) % past_.size()];
            const double overlap = dot(now.Jp, old.s) / old.length2;
            add(-overlap, old.p, now.p);
            add(-overlap, old.Jp, now.Jp);
            add(-overlap, old.s, now.s);
        }
        now.length2 = dot(now.Jp, now.s);
        if (!(now.length2 > 0.0) || !std::isfinite(now.length2)) {
            return result;
        }
        if (const double energy = dot(now.p, now.Jp); energy > 0.0) {
            smallest = std::min(smallest, now.length2 / energy);
        }
        const double step = dot(r, now.s) / now.length2;
        add(step, now.p, x);
        add(-step, now.Jp, r);
        add(-step, now.s, z_);
        if (largest(z_) <= wanted * smallest || largest(r) <= tiny) {
            result.converged = true;
            return result;
        }
    }
    return result;
}

}  // namespace tiretherm::solver
