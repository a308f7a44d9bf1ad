// SPDX-License-Identifier: BSD-3-Clause
// In-place LU factorisation of a band matrix, products and solutions.

#include "numerics/band_truth.hpp"

#include <algorithm>

#include <Eigen/Core>

namespace hidden_effects {

void BandMatrix::add(double factor, const BandMatrix& other) {
    for (std::size_t i = 0; i < entry_.size(); ++i) {
        entry_[i] += factor * other.entry_[i];
    }
}

void BandMatrix::multiply(std::span<const double> x, std::span<double> out) const {
    for (std::size_t row = 0; row < n_; ++row) {
        const std::size_t from = row > reach_ ? row - reach_ : 0;
        const std::size_t to = std::min(n_, row + reach_ + 1);
        double sum = 0.0;
        for (std::size_t column = from; column < to; ++column) {
            sum += at(row, column) * x[column];
        }
        out[row] = sum;
    }
}

void BandMatrix::factorise() {
    for (std::size_t pivot = 0; pivot < n_; ++pivot) {
        const std::size_t end = std::min(n_, pivot + reach_ + 1);
        const double inverse = 1.0 / at(pivot, pivot);
        for (std::size_t row = pivot + 1; row < end; ++row) {
            const double factor = at(row, pivot) * inverse;
            at(row, pivot) = factor;
            const auto count = static_cast<Eigen::Index>(end - pivot - 1);
            const Eigen::Map<const Eigen::ArrayXd> from(entry_.data() + pivot * width_ + reach_ + 1, count);
            Eigen::Map<Eigen::ArrayXd>(&at(row, pivot) + 1, count) -= factor * from;
        }
    }
}

void BandMatrix::solve(std::span<double> x) const {
    for (std::size_t row = 1; row < n_; ++row) {
        double sum = x[row];
        for (std::size_t column = row > reach_ ? row - reach_ : 0; column < row; ++column) {
            sum -= at(row, column) * x[column];
        }
        x[row] = sum;
    }
    for (std::size_t row = n_; row-- > 0;) {
        double sum = x[row];
        const std::size_t end = std::min(n_, row + reach_ + 1);
        for (std::size_t column = row + 1; column < end; ++column) {
            sum -= at(row, column) * x[column];
        }
        x[row] = sum / at(row, row);
    }
}

}  // namespace hidden_effects
