// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: c'(T) = scale c(T) in the named layers (thesis (34)).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { scale };

constexpr std::array parameters{
    ParameterSpec{"scale", "1", 1.0, 1e-2, 1e2, "factor on c(T)", false, 1.0},
};
constexpr std::array plausible{
    PlausibleRange{"scale", 0.8, 1.25, "1500 to 2100 J/(kg K) about the thesis's 1800; mass by weighing",
                   "mass and specific heat are known better than that: a sensor is slow or gas, rim or belt take part"},
};
constexpr std::array scopes{Scope::layer};

void modify_properties(const ActiveEffect& active, const mesh::Mesh& /*mesh*/, MaterialModel& material_model) {
    for (const int layer : active.layers) {
        Curve& c = material_model.materials[static_cast<std::size_t>(layer)].heat_capacity;
        c = c.scaled(active.at(scale, Scope::layer, layer));
    }
}

}  // namespace

extern const Effect layer_heat_capacity;
const Effect layer_heat_capacity{
    .id = "layer_heat_capacity",
    .kind = EffectKind::property,
    .equation = "c'(T) = scale c(T)",
    .source = "definition; thesis (34)",
    .valid = "0.8 to 1.25 times 1800 J/kgK for filled rubber (recalled)",
    .meaning =
        "A layer that stores more or less heat than stated: every time constant in it changes, no steady state does.",
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .on_layers = true,
    .model = PropertyModifier{.modify_properties = modify_properties},
};

}  // namespace tiretherm::physics::effects
