// SPDX-License-Identifier: BSD-3-Clause
// Incomplete Cholesky preconditioner without fill that keeps row sums (MIC(0)), in the natural order of the nodes, and
// conjugate gradients on it that need no product with the matrix (Eisenstat).

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "solver/linear/factor.hpp"

namespace tiretherm::solver {

namespace {

/// The share of the fill left out that the diagonal takes over: all of it keeps the row sums of the matrix, so that
/// smooth errors are seen as they are; a little less keeps the diagonal away from zero in a steady state.
constexpr double fill_to_diagonal = 0.98;
/// A pivot below this share of its diagonal is round-off.
constexpr double smallest_pivot = 1e-12;
constexpr int most_iterations = 2000;

/// M = (D + L) D^-1 (D + L'), L being the lower triangle of the matrix, with D such that M has the matrix' diagonal and
/// nearly its row sums: Gustafsson, BIT 18 (1978) 142-156. Kept scaled by D^-1/2 on both sides, M is (I + L)(I + L').
/// In that scale conjugate gradients need one backward and one forward sweep an iteration, and no product with the
/// matrix: Eisenstat, SIAM J. Sci. Stat. Comput. 2 (1981) 1-4.
class IncompleteFactor final : public Factor {
public:
    explicit IncompleteFactor(const Pattern& pattern) : start_(1, 0) {
        const auto n = static_cast<std::size_t>(pattern.n);
        for (std::size_t i = 0; i < n; ++i) {
            for (int e = pattern.start[i]; e < pattern.diagonal[i]; ++e) {
                column_.push_back(pattern.column[static_cast<std::size_t>(e)]);
                source_.push_back(e);
            }
            start_.push_back(static_cast<int>(column_.size()));
        }
        diagonal_of_ = pattern.diagonal;
        values_.resize(column_.size() + n);
        lower_.resize(column_.size());
        for (std::vector<double>* v : {&scale_, &excess_, &x_, &r_, &p_, &t_, &w_}) {
            v->resize(n);
        }
    }

    std::string factorise(const Matrix& matrix) override {
        for (std::size_t e = 0; e < source_.size(); ++e) {
            values_[e] = matrix.value[static_cast<std::size_t>(source_[e])];
        }
        for (std::size_t i = 0; i < scale_.size(); ++i) {
            values_[source_.size() + i] = matrix.value[static_cast<std::size_t>(diagonal_of_[i])];
        }
        return factorise_values();
    }

    [[nodiscard]] std::span<const double> values() const override { return values_; }

    std::string factorise_again(std::span<const double> values) override {
        std::ranges::copy(values, values_.begin());
        return factorise_values();
    }

    void solve(std::span<const double> b, std::span<double> x) override {
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] = scale_[i] * b[i];
        }
        sweep_forward(x);
        sweep_backward(x);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] *= scale_[i];
        }
    }

    /// Conjugate gradients on (I + L)^-1 A (I + L')^-1.
    int solve_to(double accuracy, std::span<const double> b, std::span<double> x) override {
        const std::size_t n = x.size();
        for (std::size_t i = 0; i < n; ++i) {
            r_[i] = scale_[i] * b[i];
        }
        sweep_forward(r_);
        std::ranges::copy(r_, p_.begin());
        std::ranges::fill(x_, 0.0);
        double length2 = squared(r_);
        const double wanted2 = accuracy * accuracy * length2;
        int iterations = 0;
        while (length2 > wanted2 && iterations < most_iterations) {
            ++iterations;
            const double energy = multiply();
            const double step = length2 / energy;
            double next = 0.0;
            for (std::size_t i = 0; i < n; ++i) {
                x_[i] += step * p_[i];
                r_[i] -= step * w_[i];
                next += r_[i] * r_[i];
            }
            if (!std::isfinite(next) || !(energy > 0.0)) {
                return -1;
            }
            const double share = next / length2;
            length2 = next;
            for (std::size_t i = 0; i < n; ++i) {
                p_[i] = r_[i] + share * p_[i];
            }
        }
        sweep_backward(x_);
        for (std::size_t i = 0; i < n; ++i) {
            x[i] = scale_[i] * x_[i];
        }
        return length2 <= wanted2 ? iterations : -1;
    }

    [[nodiscard]] double factor_cost() const override { return 1.0; }
    [[nodiscard]] bool is_exact() const override { return false; }
    [[nodiscard]] std::string description() const override {
        return "conjugate gradients, modified incomplete Cholesky";
    }

private:
    std::string factorise_values() {
        const std::size_t n = scale_.size();
        const double* const diagonal = values_.data() + source_.size();
        std::vector<double>& after = w_;  // sum of the entries of a row beyond its diagonal
        std::ranges::fill(after, 0.0);
        for (std::size_t e = 0; e < column_.size(); ++e) {
            after[static_cast<std::size_t>(column_[e])] += values_[e];
        }
        for (std::size_t i = 0; i < n; ++i) {
            double pivot = diagonal[i];
            for (int e = start_[i]; e < start_[i + 1]; ++e) {
                const auto at = static_cast<std::size_t>(e);
                const auto j = static_cast<std::size_t>(column_[at]);
                const double value = values_[at];
                // scale_ holds 1 / D up to here
                pivot -= value * scale_[j] * (value + fill_to_diagonal * (after[j] - value));
            }
            if (!(pivot > smallest_pivot * diagonal[i]) || !std::isfinite(pivot)) {
                return "the incomplete Cholesky factor broke down: the matrix is not positive definite";
            }
            scale_[i] = 1.0 / pivot;
        }
        for (double& scale : scale_) {
            scale = std::sqrt(scale);
        }
        for (std::size_t i = 0; i < n; ++i) {
            for (int e = start_[i]; e < start_[i + 1]; ++e) {
                const auto at = static_cast<std::size_t>(e);
                lower_[at] = values_[at] * scale_[i] * scale_[static_cast<std::size_t>(column_[at])];
            }
            excess_[i] = diagonal[i] * scale_[i] * scale_[i] - 2.0;
        }
        return {};
    }

    /// x <- (I + L)^-1 x
    void sweep_forward(std::span<double> x) const {
        const int* const column = column_.data();
        const double* const lower = lower_.data();
        for (std::size_t i = 0; i < x.size(); ++i) {
            double sum = x[i];
            for (int e = start_[i]; e < start_[i + 1]; ++e) {
                sum -= lower[e] * x[static_cast<std::size_t>(column[e])];
            }
            x[i] = sum;
        }
    }

    /// x <- (I + L')^-1 x
    void sweep_backward(std::span<double> x) const {
        const int* const column = column_.data();
        const double* const lower = lower_.data();
        for (std::size_t i = x.size(); i-- > 0;) {
            const double here = x[i];
            for (int e = start_[i]; e < start_[i + 1]; ++e) {
                x[static_cast<std::size_t>(column[e])] -= lower[e] * here;
            }
        }
    }

    /// w = (I + L)^-1 A (I + L')^-1 p = t + (I + L)^-1 (p + (diag A - 2) t), t = (I + L')^-1 p. @returns p' w
    double multiply() {
        std::ranges::copy(p_, t_.begin());
        sweep_backward(t_);
        for (std::size_t i = 0; i < w_.size(); ++i) {
            w_[i] = p_[i] + excess_[i] * t_[i];
        }
        sweep_forward(w_);
        double energy = 0.0;
        for (std::size_t i = 0; i < w_.size(); ++i) {
            w_[i] += t_[i];
            energy += p_[i] * w_[i];
        }
        return energy;
    }

    static double squared(std::span<const double> v) { return std::inner_product(v.begin(), v.end(), v.begin(), 0.0); }

    std::vector<int> start_;        ///< [n + 1] of the rows of the lower triangle, without the diagonal
    std::vector<int> column_;       ///< [n_lower]
    std::vector<int> source_;       ///< [n_lower] place in the pattern
    std::vector<int> diagonal_of_;  ///< [n] place in the pattern
    std::vector<double> values_;    ///< [n_lower + n] of the matrix, its diagonal last
    std::vector<double> lower_;     ///< [n_lower] L, scaled
    std::vector<double> scale_;     ///< [n] D^-1/2
    std::vector<double> excess_;    ///< [n] scaled diagonal of the matrix less 2
    std::vector<double> x_, r_, p_, t_, w_;
};

}  // namespace

std::unique_ptr<Factor> make_incomplete_cholesky(const Pattern& pattern) {
    return std::make_unique<IncompleteFactor>(pattern);
}

}  // namespace tiretherm::solver
