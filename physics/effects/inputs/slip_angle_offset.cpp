// SPDX-License-Identifier: BSD-3-Clause
// Input correction: slip angle with a zero error, slip angle = logged + offset. The heat of sliding of thesis (31) follows
// its magnitude.

#include <array>
#include <numbers>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { offset };

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array parameters{
    ParameterSpec{"offset", "rad", 0.0, -0.35, 0.35, "true slip angle less that of the log", false, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"offset", -1.0 * degree, 1.0 * degree,
                   "toe 0.1 to 0.3 degrees, an optical slip sensor mounted by eye up to 1 degree; assumed",
                   "no alignment is that far off: the slip angle has another zero, sign or unit"},
};
constexpr std::array<std::string_view, 1> reads{"slip_angle"};

void transform(const ActiveEffect& active, Inputs& inputs) { inputs.slip_angle += active[offset]; }

}  // namespace

extern const Effect slip_angle_offset;
const Effect slip_angle_offset{
    .id = "slip_angle_offset",
    .kind = EffectKind::input,
    .equation = "slip angle = logged + offset",
    .source = "definition; thesis (31): the friction heat follows |Fy| V tan|alpha|",
    .valid = "errors of the zero that stay the same through a run; the lateral force is as logged",
    .meaning =
        "A slip angle whose zero is off, by toe or by a sensor that is mounted askew: left corners heat more and right "
        "ones less than the log says, and sliding between them is missed. Without an offset it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .reads = reads,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
