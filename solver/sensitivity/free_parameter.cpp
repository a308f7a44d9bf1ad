// SPDX-License-Identifier: BSD-3-Clause
// Reads and moves a parameter. A law k(T) or c(T) with one knot is scaled; with two or three the Lagrange polynomial of
// the knots is added.

#include "solver/sensitivity/free_parameter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/index.hpp"

namespace tiretherm::solver {

namespace {

/// A law after the value at one of its knots has moved: scaled with one knot, otherwise by the polynomial that is 1 at
/// this knot and 0 at the others.
physics::Curve moved(const physics::Curve& law, const FreeParameter& parameter, double from, double to) {
    const std::vector<double>& x = parameter.knots;
    if (x.size() == 1) {
        return law.scaled(to / from);
    }
    const double here = x[parameter.knot];
    double by = to - from;
    double slope = 0.0;      // of the basis at its knot
    double curvature = 1.0;  // coefficient of (T - here)^2
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (k != parameter.knot) {
            slope += 1.0 / (here - x[k]);
            curvature /= here - x[k];
        }
    }
    return law.plus_quadratic(here, by, by * slope, x.size() == 3 ? by * curvature : 0.0);
}

/// Every law that a parameter moves: of a conductivity all axes that have the same law as that through the thickness.
std::vector<physics::Curve*> laws_of(Problem& problem, const FreeParameter& parameter) {
    using Kind = FreeParameter::Kind;
    std::vector<physics::Curve*> laws;
    for (const int layer : parameter.layers) {
        physics::Material& material = problem.materials[at(layer)];
        if (parameter.kind == Kind::heat_capacity) {
            laws.push_back(&material.heat_capacity);
            continue;
        }
        const physics::Curve& through = material.along(mesh::Axis::through);
        for (physics::Curve& law : material.conductivity) {
            if (law == through) {
                laws.push_back(&law);
            }
        }
    }
    if (parameter.kind == Kind::link_conductivity) {
        for (physics::Curve& law : problem.link_laws) {
            laws.push_back(&law);
        }
    }
    return laws;
}

void move_parameter(physics::ActiveEffect& active, const FreeParameter& parameter, double to) {
    for (const FreeParameter::Companion& companion : parameter.companions) {
        active.parameters[companion.parameter] = companion.factor * to;
    }
    if (parameter.everywhere) {
        active.parameters[parameter.parameter] = to;
        return;
    }
    const auto found = std::find_if(active.overrides.begin(), active.overrides.end(), [&](const auto& other) {
        return other.scope == parameter.scope && other.index == parameter.place &&
               other.parameter == parameter.parameter;
    });
    if (found != active.overrides.end()) {
        found->value = to;
        return;
    }
    active.overrides.push_back(
        {.scope = parameter.scope, .index = parameter.place, .parameter = parameter.parameter, .value = to});
}

void move_input_number(Problem& problem, std::size_t number, double to) {
    double& value = problem.input_numbers[number];
    if (value != to && problem.input_model) {
        value = to;
        problem.input_model->apply(problem.input_numbers, problem.input_signals);
    }
    value = to;
}

}  // namespace

const physics::Curve* law_of(const Problem& problem, const FreeParameter& parameter) {
    using Kind = FreeParameter::Kind;
    switch (parameter.kind) {
        case Kind::conductivity:
            return &problem.materials[at(parameter.layers.front())].along(mesh::Axis::through);
        case Kind::heat_capacity:
            return &problem.materials[at(parameter.layers.front())].heat_capacity;
        case Kind::link_conductivity:
            return problem.link_laws.empty() ? nullptr : &problem.link_laws.front();
        case Kind::effect:
        case Kind::initial:
        case Kind::input:
            return nullptr;
    }
    return nullptr;
}

double value_of(const Problem& problem, const FreeParameter& parameter) {
    if (const physics::Curve* law = law_of(problem, parameter)) {
        return law->value(parameter.knots[parameter.knot]);
    }
    if (parameter.kind == FreeParameter::Kind::input) {
        return problem.input_numbers[parameter.parameter];
    }
    if (parameter.kind != FreeParameter::Kind::effect) {
        return 0.0;
    }
    const physics::ActiveEffect& active = problem.effects[parameter.effect];
    return parameter.everywhere ? active[parameter.parameter]
                                : active.at(parameter.parameter, parameter.scope, parameter.place);
}

void move(Problem& problem, const FreeParameter& parameter, double from, double to) {
    using Kind = FreeParameter::Kind;
    if (parameter.kind == Kind::effect) {
        move_parameter(problem.effects[parameter.effect], parameter, to);
    }
    if (parameter.kind == Kind::input) {
        move_input_number(problem, parameter.parameter, to);
    }
    for (const int node : parameter.nodes) {
        problem.initial[at(node)] += to - from;
    }
    for (physics::Curve* law : laws_of(problem, parameter)) {
        *law = moved(*law, parameter, from, to);
    }
}

double typical_step(const FreeParameter& parameter, double value) {
    double size = std::max(std::abs(value), std::abs(parameter.prior));
    if (std::isfinite(parameter.standard_deviation)) {
        size = std::max(size, parameter.standard_deviation);
    }
    if (parameter.kind == FreeParameter::Kind::initial) {
        size = std::max(size, 1.0);
    }
    if (size == 0.0 && std::isfinite(parameter.high) && std::isfinite(parameter.low)) {
        size = 1e-3 * (parameter.high - parameter.low);
    }
    return 1e-4 * (size > 0.0 ? size : 1.0);
}

}  // namespace tiretherm::solver
