#include "solver/sensitivity/adjustable.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tiretherm::solver {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A law after the value at one of its knots has moved: scaled with one knot, otherwise by the polynomial that is 1 at
/// this knot and 0 at the others.
physics::Curve moved(const physics::Curve& law, const Adjustable& adjustable, double from, double to) {
    const std::vector<double>& x = adjustable.knots;
    if (x.size() == 1) {
        return law.scaled(to / from);
    }
    const double here = x[adjustable.knot];
    double by = to - from;
    double slope = 0.0;      // of the basis at its knot
    double curvature = 1.0;  // coefficient of (T - here)^2
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (k != adjustable.knot) {
            slope += 1.0 / (here - x[k]);
            curvature /= here - x[k];
        }
    }
    return law.plus_quadratic(here, by, by * slope, x.size() == 3 ? by * curvature : 0.0);
}

/// All conductivities of a material that are the same law as that through its thickness.
void move_conductivity(physics::Material& material, const Adjustable& adjustable, double from, double to) {
    const physics::Curve before = material.along(mesh::Axis::through);
    const physics::Curve after = moved(before, adjustable, from, to);
    for (physics::Curve& law : material.conductivity) {
        if (law == before) {
            law = after;
        }
    }
}

void move_parameter(physics::ActiveEffect& active, const Adjustable& adjustable, double to) {
    for (const Adjustable::Companion& companion : adjustable.companions) {
        active.parameters[companion.parameter] = companion.factor * to;
    }
    if (adjustable.everywhere) {
        active.parameters[adjustable.parameter] = to;
        return;
    }
    const auto found = std::find_if(active.overrides.begin(), active.overrides.end(), [&](const auto& other) {
        return other.scope == adjustable.scope && other.index == adjustable.place &&
               other.parameter == adjustable.parameter;
    });
    if (found != active.overrides.end()) {
        found->value = to;
        return;
    }
    active.overrides.push_back(
        {.scope = adjustable.scope, .index = adjustable.place, .parameter = adjustable.parameter, .value = to});
}

}  // namespace

double value_of(const Problem& problem, const Adjustable& adjustable) {
    using Kind = Adjustable::Kind;
    switch (adjustable.kind) {
        case Kind::effect: {
            const physics::ActiveEffect& active = problem.effects[adjustable.effect];
            return adjustable.everywhere ? active[adjustable.parameter]
                                         : active.at(adjustable.parameter, adjustable.scope, adjustable.place);
        }
        case Kind::conductivity:
            return problem.materials[at(adjustable.layers.front())]
                .along(mesh::Axis::through)
                .value(adjustable.knots[adjustable.knot]);
        case Kind::heat_capacity:
            return problem.materials[at(adjustable.layers.front())].heat_capacity.value(
                adjustable.knots[adjustable.knot]);
        case Kind::link_conductivity:
            return problem.link_laws.front().value(adjustable.knots[adjustable.knot]);
        case Kind::initial:
            return 0.0;
    }
    return 0.0;
}

void move(Problem& problem, const Adjustable& adjustable, double from, double to) {
    using Kind = Adjustable::Kind;
    switch (adjustable.kind) {
        case Kind::effect:
            move_parameter(problem.effects[adjustable.effect], adjustable, to);
            return;
        case Kind::conductivity:
            for (const int layer : adjustable.layers) {
                move_conductivity(problem.materials[at(layer)], adjustable, from, to);
            }
            return;
        case Kind::heat_capacity:
            for (const int layer : adjustable.layers) {
                physics::Curve& law = problem.materials[at(layer)].heat_capacity;
                law = moved(law, adjustable, from, to);
            }
            return;
        case Kind::link_conductivity:
            for (physics::Curve& law : problem.link_laws) {
                law = moved(law, adjustable, from, to);
            }
            return;
        case Kind::initial:
            for (const int node : adjustable.nodes) {
                problem.initial[at(node)] += to - from;
            }
            return;
    }
}

double typical_step(const Adjustable& adjustable, double value) {
    double size = std::max(std::abs(value), std::abs(adjustable.prior));
    if (std::isfinite(adjustable.standard_deviation)) {
        size = std::max(size, adjustable.standard_deviation);
    }
    if (adjustable.kind == Adjustable::Kind::initial) {
        size = std::max(size, 1.0);
    }
    if (size == 0.0 && std::isfinite(adjustable.high) && std::isfinite(adjustable.low)) {
        size = 1e-3 * (adjustable.high - adjustable.low);
    }
    return 1e-4 * (size > 0.0 ? size : 1.0);
}

}  // namespace tiretherm::solver
