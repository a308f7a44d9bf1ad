// SPDX-License-Identifier: BSD-3-Clause
// Band matrix with LU factors without pivoting, for the truths.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace hidden_effects {

/// A square matrix whose entries lie within `reach` of the diagonal, and its factors L U without pivoting (it is
/// dominated by the heat capacity and by conduction, which are positive definite).
class BandMatrix {
public:
    BandMatrix(std::size_t n_rows, std::size_t reach)
        : n_(n_rows), reach_(reach), width_(2 * reach + 1), entry_(n_rows * width_) {}

    double& at(std::size_t row, std::size_t column) { return entry_[row * width_ + reach_ + column - row]; }
    [[nodiscard]] double at(std::size_t row, std::size_t column) const {
        return entry_[row * width_ + reach_ + column - row];
    }
    void set_zero() { entry_.assign(entry_.size(), 0.0); }
    /// This += factor other, of the same size and reach.
    void add(double factor, const BandMatrix& other);
    /// out = A x
    void multiply(std::span<const double> x, std::span<double> out) const;
    /// Replaces the matrix by its factors.
    void factorise();
    /// Solves A x = b with the factors, in place.
    void solve(std::span<double> x) const;

private:
    std::size_t n_;
    std::size_t reach_;
    std::size_t width_;
    std::vector<double> entry_;
};

}  // namespace hidden_effects
