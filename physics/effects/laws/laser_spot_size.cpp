// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: laser spot wider or narrower than stated, radius = scale radius of the laser effect (1 cm2 in
// thesis III.1.1).

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { scale };

constexpr std::array parameters{
    ParameterSpec{"scale", "1", 1.0, 0.01, 100.0, "true radius of the spot over that of the laser effect", false, 1.0},
};
constexpr std::array plausible{
    PlausibleRange{"scale", 0.7, 1.4, "beam radius by camera or knife edge 5 to 10 %, by eye 30 %; recalled",
                   "the spot can be seen: measure it"},
};
constexpr std::array<std::string_view, 1> reads{"laser_power"};

/// The laser effect finds the scale among the properties when it places its light.
void modify_properties(const ActiveEffect& active, const mesh::Mesh& /*mesh*/, MaterialModel& material_model) {
    material_model.laser_spot_scale *= active[scale];
}

}  // namespace

extern const Effect laser_spot_size;
const Effect laser_spot_size{
    .id = "laser_spot_size",
    .kind = EffectKind::input,
    .equation = "radius = scale radius of the laser effect",
    .source = "definition; thesis III.1.1 states a spot of 1 cm2",
    .valid = "spots of 0.5 to 2 times the stated radius",
    .meaning =
        "A spot that is wider or narrower than stated, at the same power. The laser effect reads it when it places "
        "its light: the front shows it, the back hardly.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = PropertyModifier{.modify_properties = modify_properties},
};

}  // namespace tiretherm::physics::effects
