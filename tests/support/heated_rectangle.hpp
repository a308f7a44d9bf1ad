// SPDX-License-Identifier: BSD-3-Clause
// Exact temperature of a rectangle with uniform source and Robin sides as a double series: Carslaw and Jaeger (2nd ed.
// 1959), chapter V.
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "tests/support/layered_slab.hpp"

namespace tiretherm::support {

/// A rectangle that makes S [W/m3] everywhere from t = 0 on and exchanges heat through its four sides. With X_i of the
/// width and Z_j of the depth (each a LayeredSlab of one layer) the uniform source S has the
/// coefficients S/C a_i b_j, a = int X / int X^2, b = int Z / int Z^2, and every product decays on its own:
///
///     T = sum_ij S/C a_i b_j X_i(x) Z_j(z) (1 - exp(-(mu_i + mu_j) t)) / (mu_i + mu_j).
///
/// Carslaw and Jaeger, Conduction of Heat in Solids (2nd ed. 1959), chapter V (products of one-dimensional modes).
class HeatedRectangle {
public:
    /// @param across, through of one layer each, of the same material  @param source W/m3
    HeatedRectangle(LayeredSlab across, LayeredSlab through, double source)
        : capacity_(across.layers.front().capacity),
          source_(source),
          across_slab_(std::move(across)),
          through_slab_(std::move(through)) {
        // The corner converges last: 800 x 240 terms leave 5e-6 K there, 200 x 60 still 3e-4 K.
        for (int i = 0; i < 800; ++i) {
            across_.push_back(across_slab_.mode(i));
        }
        for (int j = 0; j < 240; ++j) {
            through_.push_back(through_slab_.mode(j));
        }
    }

    /// Excess over the surroundings. x from one side, z from the top.
    [[nodiscard]] double at(double x, double z, double t) const {
        std::vector<double> X;
        std::vector<double> Z;
        for (const auto& i : across_) {
            X.push_back(across_slab_.value(i, x));
        }
        for (const auto& j : through_) {
            Z.push_back(through_slab_.value(j, z));
        }
        return sum(t, X, Z);
    }
    /// @returns J per metre of length
    [[nodiscard]] double stored(double t) const {
        std::vector<double> X;
        std::vector<double> Z;
        for (const auto& i : across_) {
            X.push_back(i.integral);
        }
        for (const auto& j : through_) {
            Z.push_back(j.integral);
        }
        return capacity_ * sum(t, X, Z);
    }

private:
    [[nodiscard]] double sum(double t, const std::vector<double>& X, const std::vector<double>& Z) const {
        double result = 0.0;
        for (std::size_t i = 0; i < across_.size(); ++i) {
            // moment / norm = int X / int X^2, as C is the same everywhere.
            const double of_x = across_[i].moment / across_[i].norm * X[i];
            for (std::size_t j = 0; j < through_.size(); ++j) {
                const double mu = across_[i].mu + through_[j].mu;
                result += of_x * through_[j].moment / through_[j].norm * Z[j] * -std::expm1(-mu * t) / mu;
            }
        }
        return source_ / capacity_ * result;
    }

    double capacity_;
    double source_;
    LayeredSlab across_slab_;
    LayeredSlab through_slab_;
    std::vector<LayeredSlab::Mode> across_;
    std::vector<LayeredSlab::Mode> through_;
};

}  // namespace tiretherm::support
