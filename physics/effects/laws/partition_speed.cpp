// SPDX-License-Identifier: BSD-3-Clause
// Property modifier: partition' = partition (1 + slope v_s), v_s = sqrt((V s)^2 + (V tan alpha)^2), a straight line
// through the partition of moving heat sources (Jaeger 1942; Blok 1937).

#include <array>
#include <cmath>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { slope };

constexpr std::array parameters{
    ParameterSpec{
        "slope", "s m-1", 0.0, -10.0, 10.0,
        "change of the tire's share with the sliding speed, relative to the share at none; the road takes more "
        "(slope < 0) where fresh road comes in",
        false, 0.0},
};
constexpr std::array confounded{
    ConfoundedGroup{{"partition_speed", "slip_input_gain"}, "the same slip angle at several speeds"}};
constexpr std::array plausible{
    PlausibleRange{"slope", -0.3, 0.3,
                   "shares of 0.3 to 0.9 in the place of 0.6 over the 1.5 to 2 m/s of sliding of a corner (6 deg at 60 "
                   "km/h); recalled",
                   "the share would leave 0.3 to 0.85 at usual sliding speeds"},
};
constexpr std::array<std::string_view, 1> reads{"speed"};
constexpr std::array<std::string_view, 3> may_read{"slip_angle", "slip_ratio", "slip_speed"};

void modify_laws(const ActiveEffect& active, const Tire& /*tire*/, const Inputs& inputs, Laws& laws) {
    const double along = longitudinal_slip_speed(inputs);
    const double across = inputs.speed * std::tan(inputs.slip_angle);
    laws.partition *= 1.0 + active[slope] * std::hypot(along, across);
}

}  // namespace

extern const Effect partition_speed;
const Effect partition_speed{
    .id = "partition_speed",
    .kind = EffectKind::source,
    .equation = "partition' = partition (1 + slope v_s), v_s = sqrt(v_sx^2 + (V tan alpha)^2)",
    .source =
        "a straight line through the partition of moving heat sources: Jaeger, Proc. R. Soc. N.S.W. 76, 1942; Blok, "
        "Proc. Inst. Mech. Eng. 2, 1937",
    .valid = "sliding speeds up to some m/s, over which a straight line stands for the root of the Peclet number",
    .meaning =
        "The tire's share of the friction heat changes with the sliding speed. The line is not clamped above: a share "
        "beyond 1 says that a term is missing. Without a slope it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .confounded = confounded,
    .reads = reads,
    .may_read = may_read,
    .model = PropertyModifier{.modify_laws = modify_laws},
};

}  // namespace tiretherm::physics::effects
