#include "solver/krylov.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::solver {

namespace {

constexpr int most_iterations = 500;
/// A residual this small beside the right-hand side is round-off: no further solve is spent on looking at it.
constexpr double round_off = 1e-13;

double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

double largest(std::span<const double> a) {
    double most = 0.0;
    for (const double v : a) {
        most = std::max(most, std::abs(v));
    }
    return most;
}

/// y += s x
void add(double s, std::span<const double> x, std::span<double> y) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        y[i] += s * x[i];
    }
}

}  // namespace

Krylov::Krylov(int n) {
    for (std::vector<double>& w : work_) {
        w.resize(static_cast<std::size_t>(n));
    }
}

Krylov::Result Krylov::solve(const Matrix& J, Factor& factor, std::span<const double> b, std::span<double> x,
                             std::span<double> residual, double tolerance, double relative_tolerance) {
    std::copy(b.begin(), b.end(), residual.begin());
    std::fill(x.begin(), x.end(), 0.0);
    if (largest(b) == 0.0) {
        return {.converged = true, .solves = 0};
    }
    if (J.symmetric && J.outer.empty()) {
        const Result result = conjugate_gradients(J, factor, x, residual, tolerance, relative_tolerance);
        if (result.converged) {
            return result;
        }
        // Indefinite after all (heat that grows with temperature faster than it is carried away): start over.
        std::copy(b.begin(), b.end(), residual.begin());
        std::fill(x.begin(), x.end(), 0.0);
    }
    return bicgstab(J, factor, x, residual, tolerance, relative_tolerance);
}

Krylov::Result Krylov::conjugate_gradients(const Matrix& J, Factor& factor, std::span<double> x, std::span<double> r,
                                           double tolerance, double relative_tolerance) {
    std::vector<double>& z = work_[0];
    std::vector<double>& p = work_[1];
    std::vector<double>& Jp = work_[2];
    Result result;
    const double tiny = round_off * largest(r);
    factor.solve(r, z);
    result.solves = 1;
    p = z;
    double rz = dot(r, z);
    const double wanted = std::max(tolerance, relative_tolerance * largest(z));
    for (int k = 0; k < most_iterations; ++k) {
        J.multiply(p, Jp);
        const double curvature = dot(p, Jp);
        if (!(curvature > 0.0)) {
            return result;
        }
        const double step = rz / curvature;
        add(step, p, x);
        add(-step, Jp, r);
        if (largest(r) <= tiny) {
            result.converged = true;
            return result;
        }
        factor.solve(r, z);
        ++result.solves;
        if (largest(z) <= wanted) {
            result.converged = true;
            return result;
        }
        const double rz_next = dot(r, z);
        const double beta = rz_next / rz;
        rz = rz_next;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p[i] = z[i] + beta * p[i];
        }
    }
    return result;
}

/// On the left-preconditioned system M^-1 J x = M^-1 b, so that residuals are in the units of x.
Krylov::Result Krylov::bicgstab(const Matrix& J, Factor& factor, std::span<double> x, std::span<double> r,
                                double tolerance, double relative_tolerance) {
    std::vector<double>& s = work_[0];       // preconditioned residual
    std::vector<double>& shadow = work_[1];
    std::vector<double>& p = work_[2];
    std::vector<double>& v = work_[3];
    std::vector<double>& t = work_[4];
    std::vector<double>& product = work_[5];
    Result result;
    const double tiny = round_off * largest(r);
    factor.solve(r, s);
    result.solves = 1;
    shadow = s;
    p = s;
    double rho = dot(shadow, s);
    const double wanted = std::max(tolerance, relative_tolerance * largest(s));
    for (int k = 0; k < most_iterations; ++k) {
        J.multiply(p, product);
        factor.solve(product, v);
        ++result.solves;
        const double projection = dot(shadow, v);
        if (projection == 0.0 || !std::isfinite(projection)) {
            return result;
        }
        const double alpha = rho / projection;
        add(alpha, p, x);
        add(-alpha, product, r);
        add(-alpha, v, s);
        if (largest(s) <= wanted || largest(r) <= tiny) {
            result.converged = true;
            return result;
        }
        J.multiply(s, product);
        factor.solve(product, t);
        ++result.solves;
        const double length = dot(t, t);
        const double omega = length > 0.0 ? dot(t, s) / length : 0.0;
        add(omega, s, x);
        add(-omega, product, r);
        add(-omega, t, s);
        if (largest(s) <= wanted || largest(r) <= tiny) {
            result.converged = true;
            return result;
        }
        const double rho_next = dot(shadow, s);
        if (omega == 0.0 || rho_next == 0.0) {
            return result;
        }
        const double beta = rho_next / rho * alpha / omega;
        rho = rho_next;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p[i] = s[i] + beta * (p[i] - omega * v[i]);
        }
    }
    return result;
}

}  // namespace tiretherm::solver
