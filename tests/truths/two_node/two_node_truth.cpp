// SPDX-License-Identifier: BSD-3-Clause
// Integrates the bench between samples and switches with step size control.

#include "two_node/two_node_truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "two_node/bench_equations_truth.hpp"

namespace hidden_effects {

namespace {

/// Dormand and Prince, RK5(4)7.
constexpr std::array<double, 7> node_time{0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1, 1};
constexpr double stage[7][6] = {{},
                                {1.0 / 5},
                                {3.0 / 40, 9.0 / 40},
                                {44.0 / 45, -56.0 / 15, 32.0 / 9},
                                {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                                {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
                                {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}};
constexpr std::array<double, 7> order_four{5179.0 / 57600, 0,       7571.0 / 16695, 393.0 / 640, -92097.0 / 339200,
                                           187.0 / 2100,   1.0 / 40};

/// From t to `end` without a switch between; dt is the step to try, and afterwards the next one.
void integrate(const BenchEquations& equations, std::size_t i, double t, double end, double tolerance, double& dt,
               BenchState& y) {
    while (t < end) {
        const bool last = t + dt >= end;
        const double h = last ? end - t : dt;
        std::array<BenchState, 7> k;
        BenchState at_stage = y;
        for (std::size_t s = 0; s < 7; ++s) {
            at_stage = y;
            for (std::size_t j = 0; j < s; ++j) {
                for (std::size_t n = 0; n < n_bench_states; ++n) {
                    at_stage[n] += h * stage[s][j] * k[j][n];
                }
            }
            k[s] = equations.rate(i, t + node_time[s] * h, at_stage);
        }
        double error = 0.0;
        for (std::size_t n = 0; n < n_bench_states; ++n) {
            double fourth = 0.0;
            for (std::size_t s = 0; s < 7; ++s) {
                fourth += order_four[s] * k[s][n];
            }
            error = std::max(error, std::abs(y[n] + h * fourth - at_stage[n]) / tolerance);
        }
        if (error <= 1.0) {
            y = at_stage;
            t = last ? end : t + h;
        }
        const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-10), -0.2), 0.2, 5.0);
        dt = error <= 1.0 && last ? std::max(dt, h * factor) : h * factor;
    }
}

}  // namespace

BenchTrace drive_bench(const Bench& bench, const Programme& programme, double tolerance) {
    const BenchEquations equations(bench, programme);
    BenchState y = equations.start();
    BenchTrace trace;
    const auto read = [&](std::size_t i) {
        trace.surface.push_back(equations.surface_reading(i, y));
        trace.bulk.push_back(equations.bulk_reading(y));
    };
    read(0);
    double dt = 0.1;
    for (std::size_t i = 0; i + 1 < programme.time.size(); ++i) {
        double from = programme.time[i];
        for (const double stop : equations.stops(i)) {
            integrate(equations, i, from, stop, tolerance, dt, y);
            from = stop;
        }
        read(i + 1);
    }
    return trace;
}

}  // namespace hidden_effects
