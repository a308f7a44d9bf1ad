// SPDX-License-Identifier: BSD-3-Clause
// A new direction is made orthogonal to two past ones, or to one when J is symmetric; the iteration ends on the
// preconditioned residual M^-1 (b - J x), over the smallest eigenvalue of M^-1 J that the directions have met.

#include "solver/linear/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <Eigen/Core>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

constexpr int most_searches = 500;
/// A residual this small beside the right-hand side is round-off: no further solve is spent on looking at it.
constexpr double round_off = 1e-13;

using Vector = Eigen::Map<Eigen::VectorXd>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;

/// A range of nodes.
struct Nodes {
    std::size_t begin;
    std::size_t end;

    template <typename Row>
    [[nodiscard]] auto of(Row&& row) const {
        constexpr bool is_fixed = std::is_const_v<std::remove_pointer_t<decltype(row.data())>>;
        return std::conditional_t<is_fixed, ConstVector, Vector>(row.data() + begin, count());
    }
    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(end - begin); }
};

double dot(std::span<const double> a, std::span<const double> b) {
    return sum_over_ranges(a.size(), [&](std::size_t begin, std::size_t end) {
        const Nodes nodes{begin, end};
        return nodes.of(a).dot(nodes.of(b));
    });
}

double largest(std::span<const double> a) {
    return joined_over_ranges(
        a.size(),
        [&](std::size_t begin, std::size_t end) {
            return Nodes{begin, end}.of(a).lpNorm<Eigen::Infinity>();
        },
        [](double one, double other) { return std::max(one, other); });
}

/// y += s x
void add(double s, std::span<const double> x, std::span<double> y) {
    over_ranges(x.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        const Nodes nodes{begin, end};
        nodes.of(y) += s * nodes.of(x);
    });
}

}  // namespace

Krylov::Krylov(int n) : past_(directions + 1) {
    if (at(n) < least_shared) {
        take_memory(at(n));
    }
}

void Krylov::take_memory(std::size_t n) {
    z_.resize(n);
    for (Direction& direction : past_) {
        direction.p.resize(n);
        direction.Jp.resize(n);
        direction.s.resize(n);
    }
}

Krylov::Result Krylov::solve(const Matrix& J, Factor& factor, std::span<const double> b, std::span<double> x,
                             std::span<double> residual, double tolerance, double relative_tolerance) {
    const std::span<double> r = residual;
    take_memory(r.size());
    copy_nodes(b, r);
    clear_nodes(x);
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
    for (std::size_t k = 0; k < most_searches; ++k) {
        Direction& now = past_[k % past_.size()];
        copy_nodes(z_, now.p);
        J.multiply(now.p, now.Jp);
        if (k == 0) {
            // An exact factor is done here: looking at the residual saves the second solve.
            add(-1.0, now.Jp, r);
            if (largest(r) <= tiny) {
                copy_nodes(now.p, x);
                result.converged = true;
                return result;
            }
            copy_nodes(b, r);
        }
        factor.solve(now.Jp, now.s);
        ++result.solves;
        for (std::size_t back = 1; back <= std::min(k, memory); ++back) {
            make_orthogonal(now, past_[(k - back) % past_.size()]);
        }
        now.length2 = dot(now.Jp, now.s);
        if (!(now.length2 > 0.0) || !std::isfinite(now.length2)) {
            return result;
        }
        if (const double energy = dot(now.p, now.Jp); energy > 0.0) {
            smallest = std::min(smallest, now.length2 / energy);
        }
        const double step = dot(r, now.s) / now.length2;
        over_ranges(r.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
            const Nodes nodes{begin, end};
            nodes.of(x) += step * nodes.of(now.p);
            nodes.of(r) -= step * nodes.of(now.Jp);
            nodes.of(z_) -= step * nodes.of(now.s);
        });
        if (largest(z_) <= wanted * smallest || largest(r) <= tiny) {
            result.converged = true;
            return result;
        }
    }
    return result;
}

void Krylov::make_orthogonal(Direction& now, const Direction& old) {
    const double overlap = dot(now.Jp, old.s) / old.length2;
    over_ranges(now.p.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        const Nodes nodes{begin, end};
        nodes.of(now.p) -= overlap * nodes.of(old.p);
        nodes.of(now.Jp) -= overlap * nodes.of(old.Jp);
        nodes.of(now.s) -= overlap * nodes.of(old.s);
    });
}

}  // namespace tiretherm::solver
