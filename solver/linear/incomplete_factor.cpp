// SPDX-License-Identifier: BSD-3-Clause
// Incomplete Cholesky preconditioner by Eigen (limited memory, Lin and More 1999) in the natural order of the nodes.

#include <algorithm>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "solver/linear/factor.hpp"

namespace tiretherm::solver {

namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

class IncompleteFactor final : public Factor {
public:
    explicit IncompleteFactor(const Pattern& pattern) : pattern_(&pattern) {
        std::vector<Eigen::Triplet<double>> entries;
        for (int i = 0; i < pattern.n; ++i) {
            const auto at = static_cast<std::size_t>(i);
            for (int e = pattern.diagonal[at]; e < pattern.start[at + 1]; ++e) {
                entries.emplace_back(pattern.column[static_cast<std::size_t>(e)], i, 1.0);
                source_.push_back(e);
            }
        }
        lower_.resize(pattern.n, pattern.n);
        lower_.setFromTriplets(entries.begin(), entries.end());
        lower_.makeCompressed();
        factor_.analyzePattern(lower_);
    }

    std::string factorise(const Matrix& matrix) override {
        double* value = lower_.valuePtr();
        for (std::size_t e = 0; e < source_.size(); ++e) {
            value[e] = matrix.value[static_cast<std::size_t>(source_[e])];
        }
        return factorise_values();
    }

    [[nodiscard]] std::span<const double> values() const override { return {lower_.valuePtr(), source_.size()}; }

    std::string factorise_again(std::span<const double> values) override {
        std::copy(values.begin(), values.end(), lower_.valuePtr());
        return factorise_values();
    }

    void solve(std::span<const double> b, std::span<double> x) override {
        const Eigen::Map<const Eigen::VectorXd> right(b.data(), static_cast<Eigen::Index>(b.size()));
        Eigen::Map<Eigen::VectorXd> result(x.data(), static_cast<Eigen::Index>(x.size()));
        result = factor_.scalingS().cwiseProduct(right);
        factor_.matrixL().triangularView<Eigen::Lower>().solveInPlace(result);
        factor_.matrixL().adjoint().triangularView<Eigen::Upper>().solveInPlace(result);
        result = factor_.scalingS().cwiseProduct(result);
    }

    [[nodiscard]] double factor_cost() const override { return 20.0; }

    [[nodiscard]] bool is_exact() const override { return false; }
    [[nodiscard]] std::string description() const override {
        return "conjugate gradients, incomplete Cholesky (Eigen)";
    }

private:
    std::string factorise_values() {
        factor_.factorize(lower_);
        return factor_.info() == Eigen::Success
                   ? std::string{}
                   : "the incomplete Cholesky factor broke down: the matrix is not positive definite";
    }

    const Pattern* pattern_;
    Sparse lower_;
    std::vector<int> source_;
    // The natural order of a structured block needs fewer iterations than a fill-reducing one.
    Eigen::IncompleteCholesky<double, Eigen::Lower, Eigen::NaturalOrdering<int>> factor_;
};

}  // namespace

std::unique_ptr<Factor> make_incomplete_cholesky(const Pattern& pattern) {
    return std::make_unique<IncompleteFactor>(pattern);
}

}  // namespace tiretherm::solver
