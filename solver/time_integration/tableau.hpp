// SPDX-License-Identifier: BSD-3-Clause
// Coefficients of the time integration methods: TR-BDF2 with a third-order companion (Hosea and Shampine 1996) and
// backward Euler.
#pragma once

#include <array>
#include <numbers>

#include "solver/problem.hpp"

namespace tiretherm::solver {

/// A diagonally implicit Runge-Kutta method whose first stage is explicit and whose last is the result (stiffly
/// accurate, L-stable). H_i = H_n + dt sum_j a_ij q_j, and every implicit stage has the same diagonal coefficient.
struct Tableau {
    static constexpr int most_stages = 3;
    int stages;
    int order;
    std::array<std::array<double, most_stages>, most_stages> a;
    std::array<double, most_stages> c;      ///< time of a stage, in steps
    std::array<double, most_stages> error;  ///< b_i - b^_i: weights of the error estimate
    double diagonal;

    /// Weight of a stage's heat in the heat since the start of the step, at the share x of the step: a continuous
    /// extension of the method's own order that ends in weight(stage).
    [[nodiscard]] double weight_at(int stage, double x) const {
        if (order == 1) {
            return x * weight(stage);
        }
        return stage == 0 ? x + (weight(0) - 1.0) * x * x : weight(stage) * x * x;
    }

    [[nodiscard]] double weight(int stage) const {
        return a[static_cast<std::size_t>(stages) - 1][static_cast<std::size_t>(stage)];
    }
};

/// Trapezoidal rule to t + gamma dt, then BDF2, with a third-order companion: Hosea and Shampine, Applied Numerical
/// Mathematics 20 (1996) 21-37, gamma = 2 - sqrt 2.
inline constexpr Tableau tr_bdf2 = [] {
    constexpr double root = std::numbers::sqrt2;
    constexpr double d = 1.0 - 0.5 * root;
    constexpr double w = 0.25 * root;
    return Tableau{.stages = 3,
                   .order = 2,
                   .a = {{{0.0, 0.0, 0.0}, {d, d, 0.0}, {w, w, d}}},
                   .c = {0.0, 2.0 - root, 1.0},
                   .error = {w - (1.0 - w) / 3.0, w - (3.0 * w + 1.0) / 3.0, d - d / 3.0},
                   .diagonal = d};
}();

/// Backward Euler, with the trapezoidal rule as companion.
inline constexpr Tableau backward_euler{.stages = 2,
                                        .order = 1,
                                        .a = {{{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {}}},
                                        .c = {0.0, 1.0, 1.0},
                                        .error = {-0.5, 0.5, 0.0},
                                        .diagonal = 1.0};

[[nodiscard]] constexpr const Tableau& tableau(Method method) {
    switch (method) {
        case Method::tr_bdf2:
            return tr_bdf2;
        case Method::backward_euler:
            return backward_euler;
    }
    return tr_bdf2;
}

}  // namespace tiretherm::solver
