// SPDX-License-Identifier: BSD-3-Clause
// Searches the materials of a contact's nodes for the extremes of their effusivity; Lagrange's parabola in e/(e + e_road).

#include "physics/contact/tread_effusivity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tiretherm::physics {

namespace {

/// Temperatures between which a tread is resolved; beyond them it keeps the effusivity of the end. K
constexpr double coldest = 233.15;
constexpr double hottest = 473.15;

double share(double effusivity, double of_road) { return effusivity / (effusivity + of_road); }

}  // namespace

TreadEffusivity effusivity(const Material& material, double T) {
    const Curve& k = material.along(mesh::Axis::through);
    const double value = std::sqrt(k.value(T) * material.density * material.heat_capacity.value(T));
    const double log_slope =
        k.slope(T) / k.value(T) + material.heat_capacity.slope(T) / material.heat_capacity.value(T);
    return {.value = value, .slope = 0.5 * value * log_slope};
}

void place_effusivities(const PlacementContext& context, double of_road, ActiveEffect& active) {
    constexpr int steps = 48;  // of 5 K
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    std::vector<char> seen(context.material_model.materials.size());
    for (const int node : active.nodes) {
        const auto layer = static_cast<std::size_t>(context.mesh.layer[static_cast<std::size_t>(node)]);
        if (seen[layer] != 0) {
            continue;
        }
        seen[layer] = 1;
        for (int i = 0; i <= steps; ++i) {
            const double T = coldest + (hottest - coldest) * i / steps;
            const double e = effusivity(context.material_model.materials[layer], T).value;
            if (std::isfinite(e) && e > 0.0) {  // a law that turns negative is refused or warned of elsewhere
                least = std::min(least, e);
                most = std::max(most, e);
            }
        }
    }
    active.effusivity_of_road = of_road;
    active.effusivities = {least};
    if (most > least * (1.0 + 1e-9)) {
        const double middle = 0.5 * (share(least, of_road) + share(most, of_road));
        active.effusivities = {least, of_road * middle / (1.0 - middle), most};
    }
}

EffusivityInterpolation::EffusivityInterpolation(std::span<const double> effusivities, double of_road,
                                                 const TreadEffusivity& at) {
    if (effusivities.size() < most_effusivities) {
        return;
    }
    const double e = std::clamp(at.value, effusivities.front(), effusivities.back());
    const double x = share(e, of_road);
    const double dx = e == at.value ? of_road / ((e + of_road) * (e + of_road)) * at.slope : 0.0;
    for (std::size_t i = 0; i < most_effusivities; ++i) {
        const double a = share(effusivities[(i + 1) % most_effusivities], of_road);
        const double b = share(effusivities[(i + 2) % most_effusivities], of_road);
        const double here = share(effusivities[i], of_road);
        const double scale = 1.0 / ((here - a) * (here - b));
        weight_[i] = (x - a) * (x - b) * scale;
        slope_[i] = (2.0 * x - a - b) * scale * dx;
    }
}

EffusivityInterpolation::EffusivityInterpolation(const EvaluationState& state, int node)
    : EffusivityInterpolation(
          state.active.effusivities, state.active.effusivity_of_road,
          state.active.effusivities.size() < most_effusivities
              ? TreadEffusivity{}
              : effusivity(state.material_at(node), state.temperature[static_cast<std::size_t>(node)])) {}

}  // namespace tiretherm::physics
