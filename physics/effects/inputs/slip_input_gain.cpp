// SPDX-License-Identifier: BSD-3-Clause
// Input correction: slip that is off by a factor, slip ratio = gain logged, tan(alpha) = gain tan(logged). The friction
// heat of thesis (31) is proportional to both.

#include <array>
#include <cmath>
#include <numbers>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { gain };

constexpr std::array parameters{
    ParameterSpec{"gain", "1", 1.0, 0.0, 10.0, "true sliding speed over that of the log", false, 1.0},
};
constexpr std::array plausible{
    PlausibleRange{"gain", 0.7, 1.4,
                   "wheel alignment, yaw and rolling radius leave slip uncertain by 10 to 30 %; recalled",
                   "slip is logged in another unit or late, or a slow sensor flattens what sliding makes"},
};
constexpr std::array<std::string_view, 3> may_read{"slip_angle", "slip_ratio", "slip_speed"};

/// On the tangent, not on the angle: the lateral sliding speed V tan(alpha), and with it the heat, take the gain exactly.
void transform(const ActiveEffect& active, Inputs& inputs) {
    inputs.slip_ratio *= active[gain];
    inputs.slip_speed *= active[gain];
    inputs.slip_angle = std::atan(active[gain] * std::tan(inputs.slip_angle));
}

/// The tangent is nearly straight up to there (this file's own bound).
constexpr std::array compared{ComparedRange{"slip_angle", 0.0, 25.0 * std::numbers::pi / 180.0, "stated"}};

}  // namespace

extern const Effect slip_input_gain;
const Effect slip_input_gain{
    .id = "slip_input_gain",
    .kind = EffectKind::input,
    .equation = "slip ratio = gain logged, tan(alpha) = gain tan(logged)",
    .source = "definition; thesis (31): the friction heat is proportional to both",
    .valid = "errors in proportion to the slip; slip angles below 25 degrees",
    .meaning =
        "Slip that was logged too small or too large by a factor: the heat of sliding takes the same factor, forces "
        "and all other heat are as logged. From temperatures it cannot be told from the partition or lambda_y.",
    .compared = compared,
    .parameters = parameters,
    .plausible = plausible,
    .may_read = may_read,
    .model = InputCorrection{.transform = transform},
};

}  // namespace tiretherm::physics::effects
