// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: cords that conduct along the belt, k_meridian' = meridian k_meridian, k_circumference' =
// circumference k_circumference (rule of mixtures).

#include <array>
#include <utility>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { meridian, circumference };

// Steel cords at +-22 degrees to the circumference with 5 W/mK along and 0.7 across them, 0.4 through the belt:
// 5 cos^2 + 0.7 sin^2 = 4.4 and 5 sin^2 + 0.7 cos^2 = 1.3 W/mK, 11 and 3 times the conductivity through.
constexpr std::array parameters{
    ParameterSpec{"meridian", "1", 3.0, 1e-3, 1e3, "factor on the conductivity along the meridian; recalled", false,
                  1.0},
    ParameterSpec{"circumference", "1", 10.0, 1e-3, 1e3, "factor on that along the circumference; recalled", false,
                  1.0},
};
constexpr std::array plausible{
    PlausibleRange{
        "meridian", 1.0, 10.0,
        "steel belts across their cords 0.4 to 1 over 0.3 to 0.45 W/(m K) through, along them up to 10; recalled",
        "no layer of cords conducts along the meridian that much better than through"},
    PlausibleRange{"circumference", 1.0, 33.0,
                   "steel belts along their cords 1 to 10 over 0.3 to 0.45 W/(m K) through; recalled",
                   "no layer of cords conducts along them that much better than through"},
};
constexpr std::array scopes{Scope::layer};

void modify_properties(const ActiveEffect& active, const mesh::Mesh& /*mesh*/, MaterialModel& material_model) {
    for (const int layer : active.layers) {
        auto& k = material_model.materials[static_cast<std::size_t>(layer)].conductivity;
        for (const auto& [axis, factor] :
             {std::pair(mesh::Axis::meridian, meridian), std::pair(mesh::Axis::circumference, circumference)}) {
            Curve& along = k[static_cast<std::size_t>(axis)];
            along = along.scaled(active.at(factor, Scope::layer, layer));
        }
    }
}

}  // namespace

extern const Effect belt_anisotropy;
const Effect belt_anisotropy{
    .id = "belt_anisotropy",
    .kind = EffectKind::property,
    .equation = "k_meridian' = meridian k_meridian, k_circumference' = circumference k_circumference",
    .source = "rule of mixtures for steel cords in rubber; the numbers are recalled",
    .valid = "layers of cords that lie in one plane; 1.5 to 5 times along steel cords (recalled)",
    .meaning =
        "Cords carry heat along the belt better than through it: name the belt in `layers`. A laser spot turns oval on "
        "the back, and peaks across the tread are blunted. A material with `[material.cord_rubber]` has its cords "
        "already.",
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .needs_grid = true,
    .on_layers = true,
    .model = PropertyModifier{.modify_properties = modify_properties},
};

}  // namespace tiretherm::physics::effects
