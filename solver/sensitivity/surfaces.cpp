// SPDX-License-Identifier: BSD-3-Clause
// Jacobi iteration over the surfaces.

#include "solver/sensitivity/surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/index.hpp"

namespace tiretherm::solver {

Status settle_surfaces(const System& system, const Matrix& J, std::span<const double> right, double scale,
                       double tolerance, std::span<double> x, std::span<double> product) {
    constexpr int most_iterations = 60;  // round-off is reached in 10 to 20
    const std::size_t n = J.pattern->diagonal.size();
    const auto apart = [] {
        return Status{Outcome::not_converged, "the sensitivities of the surfaces did not converge"};
    };
    double worst = 0.0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        J.multiply_block(x, product, x.size() / n);
        worst = 0.0;
        for (std::size_t first = 0; first < x.size(); first += n) {
            double change = 0.0;
            double largest = 0.0;
            for (std::size_t i = 0; i < n; ++i) {
                if (!system.has_capacity(i)) {
                    const double by =
                        (scale * right[first + i] - product[first + i]) / J.value[at(J.pattern->diagonal[i])];
                    if (!std::isfinite(by)) {  // which no maximum would show
                        return apart();
                    }
                    x[first + i] += by;
                    change = std::max(change, std::abs(by));
                }
                largest = std::max(largest, std::abs(x[first + i]));
            }
            worst = std::max(worst, largest > 0.0 ? change / largest : 0.0);
        }
        if (worst <= tolerance) {
            return {};
        }
    }
    constexpr double enough = 1e-9;
    return worst <= enough ? Status{} : apart();
}

}  // namespace tiretherm::solver
