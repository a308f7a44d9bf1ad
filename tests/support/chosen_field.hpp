// SPDX-License-Identifier: BSD-3-Clause
// Method of manufactured solutions: a field chosen beforehand in an orthotropic block with k(T) and c(T), and the
// source that makes it exact.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "physics/effect.hpp"

/// A field chosen beforehand, in a block of 30 x 20 x 12 mm whose conductivity differs in the three directions and,
/// like its heat capacity, is a quadratic of temperature:
///
///     T(x, y, z, t) = 320 + 60 s(t) X(x) Y(y) Z(z),   X = cos(40 x + 0.3), Y = cos(70 y - 0.2), Z = exp(-90 z),
///     s(t) = 1 - exp(-t/tau)/2.
///
/// The source that makes it a solution is rho c(T) dT/dt - sum over axes of d/dx(k_x dT/dx), with
/// d/dx(k T_x) = k T_xx + k' T_x^2; on the sides an exchange with h = 200 W/m2K towards T + k T_n / h lets exactly the
/// flux of the field pass.
namespace tiretherm::support::chosen {

inline constexpr double tau = 40.0;        // s
inline constexpr double density = 1100.0;  // kg/m3
inline constexpr double h = 200.0;         // W/(m2 K)

// k in W/(m K) and c in J/(kg K), quadratics of T - 300 K.
inline constexpr std::array<std::array<double, 3>, 3> k{
    {{0.40, 2.0e-3, 1.0e-5}, {0.80, -1.0e-3, 2.0e-5}, {0.25, 1.0e-3, -4.0e-6}}};
inline constexpr std::array<double, 3> c{1700.0, 4.0, -0.01};

inline double quadratic(const std::array<double, 3>& p, double T) {
    return p[0] + (T - 300.0) * (p[1] + (T - 300.0) * p[2]);
}
inline double slope(const std::array<double, 3>& p, double T) { return p[1] + 2.0 * p[2] * (T - 300.0); }

struct Point {
    double T;
    double by_time;
    std::array<double, 3> first;  // dT/dx, dT/dy, dT/dz
    std::array<double, 3> second;
};

inline Point field(const mesh::Point& at, double t) {
    const double s = 60.0 * (1.0 - 0.5 * std::exp(-t / tau));
    const double rate = 30.0 / tau * std::exp(-t / tau);
    const double a = 40.0 * at[0] + 0.3;
    const double b = 70.0 * at[1] - 0.2;
    const double X = std::cos(a);
    const double Y = std::cos(b);
    const double Z = std::exp(-90.0 * at[2]);
    return {.T = 320.0 + s * X * Y * Z,
            .by_time = rate * X * Y * Z,
            .first = {-40.0 * s * std::sin(a) * Y * Z, -70.0 * s * X * std::sin(b) * Z, -90.0 * s * X * Y * Z},
            .second = {-1600.0 * s * X * Y * Z, -4900.0 * s * X * Y * Z, 8100.0 * s * X * Y * Z}};
}

/// W/m3
inline double source(const Point& p) {
    double q = density * quadratic(c, p.T) * p.by_time;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        q -= quadratic(k[axis], p.T) * p.second[axis] + slope(k[axis], p.T) * p.first[axis] * p.first[axis];
    }
    return q;
}

// The time travels in a signal: a straight series is exact at every stage.
inline constexpr std::array<std::string_view, 1> reads{"inflation_pressure"};

inline void evaluate_coefficients(const physics::ActiveEffect& /*active*/, const physics::OperatingPoint& point,
                                  std::span<double> out) {
    out[0] = point.inputs.inflation_pressure;
}

inline void add_terms_of_source(const physics::EvaluationState& m, physics::Terms& terms) {
    for (int cell = 0; cell < m.mesh.n_cells; ++cell) {
        const auto i = static_cast<std::size_t>(cell);
        terms.heat(cell, m.mesh.volume[i] * source(field(m.mesh.centre[i], m.coefficients[0])));
    }
}

inline void add_terms_of_sides(const physics::EvaluationState& m, physics::Terms& terms) {
    const std::array<std::string_view, 6> sides{"left", "right", "front", "back", "top", "bottom"};
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const double outward = side % 2 == 0 ? -1.0 : 1.0;
        for (const mesh::PatchFace& face :
             m.mesh.patches[static_cast<std::size_t>(m.mesh.find_patch(sides[side]))].faces) {
            const Point p = field(face.centre, m.coefficients[0]);
            const double flux = outward * quadratic(k[side / 2], p.T) * p.first[side / 2];  // k dT/dn
            terms.exchange(face.node, h * face.area, p.T + flux / h);
        }
    }
}

inline physics::Effect effect(std::string_view id,
                              void (*add_terms)(const physics::EvaluationState&, physics::Terms&)) {
    return {.id = id,
            .kind = physics::EffectKind::source,
            .equation = "chosen field",
            .source = "this test",
            .meaning = "what a chosen field needs to be a solution",
            .reads = reads,
            .model = physics::HeatEffect{
                .n_coefficients = 1, .evaluate_coefficients = evaluate_coefficients, .add_terms = add_terms}};
}

inline const physics::Effect inside = effect("chosen_source", add_terms_of_source);
inline const physics::Effect sides = effect("chosen_sides", add_terms_of_sides);

}  // namespace tiretherm::support::chosen
