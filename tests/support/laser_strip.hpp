// SPDX-License-Identifier: BSD-3-Clause
// A one-dimensional specimen under a laser, and logged series with their exact integrals.
#pragma once

#include <cmath>
#include <vector>

#include "tests/support/problem.hpp"

namespace tiretherm::support {

/// A straight-line series and its exact integrals, by the trapezoidal rule between its points.
struct Samples {
    std::vector<double> time;
    std::vector<double> value;

    [[nodiscard]] double integral() const {
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < time.size(); ++i) {
            sum += 0.5 * (value[i] + value[i + 1]) * (time[i + 1] - time[i]);
        }
        return sum;
    }
    /// Of (t - middle) f(t), by Simpson's rule: exact for the product of two straight lines.
    [[nodiscard]] double moment(double middle) const {
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < time.size(); ++i) {
            const double dt = time[i + 1] - time[i];
            const double centre = 0.5 * (time[i] + time[i + 1]) - middle;
            const double mean = 0.5 * (value[i] + value[i + 1]);
            sum += dt / 6.0 *
                   ((time[i] - middle) * value[i] + 4.0 * centre * mean + (time[i + 1] - middle) * value[i + 1]);
        }
        return sum;
    }
};

/// f at equal intervals.
inline Samples sampled(double end, double interval, const auto& f) {
    Samples s;
    const auto n = std::lround(end / interval);
    for (long i = 0; i <= n; ++i) {
        s.time.push_back(end * static_cast<double>(i) / static_cast<double>(n));
        s.value.push_back(f(s.time.back()));
    }
    return s;
}

/// A disc of rubber as wide as the laser's spot, cooled in front: a strip that takes the laser's whole power.
inline solver::Problem laser_strip() {
    solver::Problem problem;
    problem.title = "strip under a laser";
    problem.mesh = mesh::build(mesh::Axisymmetric{.radius = {{5.6e-3, 1, 1.0}}, .stack = {{"rubber", 0.012, 12, 4.0}}});
    problem.materials = {material(0.29, 1100.0, 1800.0)};
    switch_on(problem, "conduction");
    switch_on(problem, "laser", {{"radius", 5.6e-3}});
    switch_on(problem, "still_air", {{"h", 40.0}}, {"top"});
    hold(problem, "air_temperature", 296.15);
    start_at(problem, 296.15);
    read(problem, "top", mesh::over_patch(problem.mesh, 0));
    read(problem, "bottom", mesh::over_patch(problem.mesh, 1));
    problem.settings.end = 600.0;
    problem.settings.output_interval = 600.0;
    return problem;
}

/// Places of its effects.
namespace strip {
enum : std::size_t { conduction, laser, still_air };
}

}  // namespace tiretherm::support
