// SPDX-License-Identifier: BSD-3-Clause
// Coefficients and stages of RODAS, step size control, and rank-one couplings by Woodbury's formula.

#include "numerics/rodas_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Dense>

namespace hidden_effects {

namespace {

// With u = sum of stages as unknowns:
//     (M/(gamma dt) - J) u_i = f(t + alpha_i dt, y + sum_j a_ij u_j) + M sum_j (c_ij/dt) u_j + d_i dt df/dt
// The last stage is the estimate of the error.
constexpr int n_stages = 6;
constexpr double gamma_of_rodas = 0.25;
constexpr double alpha[n_stages] = {0.0, 0.386, 0.21, 0.63, 1.0, 1.0};
constexpr double d[n_stages] = {0.25, -0.1043, 0.1035, -0.0362, 0.0, 0.0};
constexpr double a[n_stages][n_stages - 1] = {
    {0, 0, 0, 0, 0},
    {1.544, 0, 0, 0, 0},
    {0.9466785280815826, 0.2557011698983284, 0, 0, 0},
    {3.314825187068521, 2.896124015972201, 0.9986419139977817, 0, 0},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 0},
    {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}};
constexpr double c[n_stages][n_stages - 1] = {
    {0, 0, 0, 0, 0},
    {-5.6688, 0, 0, 0, 0},
    {-2.430093356833875, -0.2063599157091915, 0, 0, 0},
    {-0.1073529058151375, -9.594562251023355, -20.47028614809616, 0, 0},
    {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160, 0},
    {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136, -6.058818238834054}};

using Vector = std::vector<double>;

double inner(const Vector& x, const Vector& y) { return std::inner_product(x.begin(), x.end(), y.begin(), 0.0); }

}  // namespace

double hermite(double s, double dt, double y0, double rate0, double y1, double rate1) {
    const double rest = 1.0 - s;
    return rest * rest * (1.0 + 2.0 * s) * y0 + s * s * (3.0 - 2.0 * s) * y1 +
           s * rest * dt * (rest * rate0 - s * rate1);
}

Rodas::Rodas(const HeatSystem& system, Vector start, double time, double tolerance)
    : system_(system),
      tolerance_(tolerance),
      M_(system.capacity()),
      M_factor_(M_),
      J_(M_),
      A_(M_),
      T_(std::move(start)),
      f_(T_.size()),
      by_time_(T_.size()),
      time_(time) {
    M_factor_.factorise();
    couplings_.assign(system.n_couplings(), {Vector(T_.size()), Vector(T_.size())});
}

Vector Rodas::rate() {
    system_.heat(time_, T_, f_, nullptr, nullptr);
    Vector rate = f_;
    M_factor_.solve(rate);
    return rate;
}

void Rodas::prepare_couplings() {
    solved_.clear();
    const auto n = static_cast<Eigen::Index>(couplings_.size());
    for (const Coupling& coupling : couplings_) {
        solved_.push_back(coupling.u);
        A_.solve(solved_.back());
    }
    Eigen::MatrixXd small = Eigen::MatrixXd::Identity(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            small(i, j) -= inner(couplings_[static_cast<std::size_t>(i)].v, solved_[static_cast<std::size_t>(j)]);
        }
    }
    small = small.inverse().eval();
    small_.assign(small.data(), small.data() + small.size());  // columns first
}

/// (A - U V^T)^-1 x = A^-1 x + A^-1 U (1 - V^T A^-1 U)^-1 V^T A^-1 x
void Rodas::solve(Vector& x) const {
    A_.solve(x);
    const std::size_t n = couplings_.size();
    Vector seen;
    for (const Coupling& coupling : couplings_) {
        seen.push_back(inner(coupling.v, x));
    }
    for (std::size_t i = 0; i < n; ++i) {
        double share = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
            share += small_[j * n + i] * seen[j];
        }
        for (std::size_t m = 0; m < x.size() && share != 0.0; ++m) {
            x[m] += share * solved_[i][m];
        }
    }
}

void Rodas::step(double end) {
    J_.set_zero();
    for (Coupling& coupling : couplings_) {
        std::fill(coupling.u.begin(), coupling.u.end(), 0.0);
        std::fill(coupling.v.begin(), coupling.v.end(), 0.0);
    }
    system_.heat(time_, T_, f_, &J_, &couplings_);
    // A difference over a thousandth of what is left of the smooth piece.
    const double ahead = 1e-3 * (end - time_);
    system_.heat(time_ + ahead, T_, by_time_, nullptr, nullptr);
    for (std::size_t m = 0; m < f_.size(); ++m) {
        by_time_[m] = (by_time_[m] - f_[m]) / ahead;
    }
    for (bool accepted = false; !accepted;) {
        accepted = attempt(std::min(dt_, end - time_), end);
    }
    ++n_steps_;
}

bool Rodas::attempt(double dt, double end) {
    A_.set_zero();
    A_.add(1.0 / (gamma_of_rodas * dt), M_);
    A_.add(-1.0, J_);
    A_.factorise();
    prepare_couplings();
    const std::size_t n = T_.size();
    std::vector<Vector> u;
    Vector T = T_;
    Vector f = f_;
    Vector carried(n);
    for (int i = 0; i < n_stages; ++i) {
        if (i > 0) {
            T = T_;
            std::fill(carried.begin(), carried.end(), 0.0);
            for (int j = 0; j < i; ++j) {
                for (std::size_t m = 0; m < n; ++m) {
                    T[m] += a[i][j] * u[static_cast<std::size_t>(j)][m];
                    carried[m] += c[i][j] / dt * u[static_cast<std::size_t>(j)][m];
                }
            }
            system_.heat(time_ + alpha[i] * dt, T, f, nullptr, nullptr);
            Vector M_carried(n);
            M_.multiply(carried, M_carried);
            std::transform(f.begin(), f.end(), M_carried.begin(), f.begin(), std::plus<>{});
        }
        u.push_back(f);
        for (std::size_t m = 0; m < n; ++m) {
            u.back()[m] += d[i] * dt * by_time_[m];
        }
        solve(u.back());
    }
    // T now is the argument of the last stage; the step's end is that plus the last stage itself.
    double error = 0.0;
    for (std::size_t m = 0; m < n; ++m) {
        T[m] += u.back()[m];
        error = std::max(error, std::abs(u.back()[m]) / tolerance_);
    }
    const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-12), -0.25), 0.2, 5.0);
    const bool accepted = error <= 1.0;
    const bool last = dt == end - time_;
    if (accepted) {
        time_ = last ? end : time_ + dt;
        T_ = std::move(T);
    }
    dt_ = accepted && last ? std::max(dt_, dt * factor) : dt * factor;
    return accepted;
}

}  // namespace hidden_effects
