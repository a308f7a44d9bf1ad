// SPDX-License-Identifier: BSD-3-Clause
// The readers of [effects], [[source]] and [[exchange]].
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/cameras/camera.hpp"
#include "input/drive/drive.hpp"

namespace tiretherm::input {

/// What else of a run the readers of effects ask for.
struct EffectSurroundings {
    bool has_tire = false;
    const DrivenSignals& signals;    ///< but for their inputs, which the problem has
    const RunInputs* run = nullptr;  ///< that is measured; null: none
};

/// What to do about a name that no effect has. @param known names beside those of the catalogue
[[nodiscard]] std::string unknown_effect_remedy(std::string_view id, std::vector<std::string> known = {});

/// The effects of the catalogue, but for what follows the run's times and the sensors. @returns whether all are sound
[[nodiscard]] bool read_effects(TomlTable& root, const EffectSurroundings& in, solver::Problem& problem);
/// Fields of structural codes and measured totals of the effects that are on, when the run's times are known.
/// @returns inputs over which a total was measured
[[nodiscard]] std::vector<std::string> read_fields(TomlTable& root, const GivenSignals& given,
                                                   solver::Problem& problem);
/// The wheel's angle and the moments of contact, where an effect goes round the tire.
void read_travelling(TomlTable& root, bool has_tire, solver::Problem& problem);
/// The lists [[source]] and [[exchange]], when the run's times are known.
void read_user_effects(TomlTable& root, const EffectSurroundings& in, solver::Problem& problem);
/// The channels of the sensor models; what else they say has been read.
void bind_readings(TomlTable& root, const std::vector<Camera>& cameras, solver::Problem& problem);
/// Warnings about effects that say the same, and about signals that none follows, of effects that are sound.
/// @param followed signals that user effects, [vehicle] and measured totals follow
void check_effects(TomlTable& root, const GivenSignals& given, const std::vector<std::string>& followed,
                   const solver::Problem& problem);

}  // namespace tiretherm::input
