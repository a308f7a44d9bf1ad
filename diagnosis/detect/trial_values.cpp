// SPDX-License-Identifier: BSD-3-Clause
// The table of trial values: gas conductances from slow to quick, critical speeds of a standing wave.

#include "diagnosis/detect/trial_values.hpp"

#include <algorithm>

namespace tiretherm::diagnosis {

namespace {

// A little gas conductance is slow, much of it is quick: four signatures. A wave's signature begins at its speed.
constexpr std::array all{
    TrialValues{.effect = "inner_gas",
                .parameter = "liner",
                .other = "rim",
                .factor = 4.0 / 9.0,
                .trials = {0.3, 1.0, 3.0, 9.0}},
    TrialValues{.effect = "inner_gas", .parameter = "rim", .left_out = true},
    TrialValues{.effect = "sidewall_convection", .parameter = "h", .left_out = true},
    TrialValues{.effect = "standing_wave",
                .parameter = "gain",
                .other = "critical_speed",
                .held = {80.0, 95.0, 110.0, 125.0, 140.0, 155.0, 170.0, 190.0, 215.0, 245.0}},
};

}  // namespace

std::span<const TrialValues> trial_values() { return all; }

const TrialValues* trial_values_of(const physics::Effect& effect, const physics::ParameterSpec& parameter) {
    const auto found = std::ranges::find_if(
        all, [&](const TrialValues& one) { return one.effect == effect.id && one.parameter == parameter.key; });
    return found == all.end() ? nullptr : &*found;
}

}  // namespace tiretherm::diagnosis
