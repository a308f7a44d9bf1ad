// SPDX-License-Identifier: BSD-3-Clause
// Checks that a case has what its effects need, and warns of unused signals and of heat that is counted twice.
#pragma once

#include "input/effects/effects.hpp"

namespace tiretherm::input {

/// Whether an effect has what it needs: a tire, patches, cells. @param place of what switched it on
/// @param chosen whether the case names its patches
void check_requirements(TomlTable& root, const physics::ActiveEffect& active, const SourceLocation& place, bool chosen,
                        bool has_tire, const mesh::Mesh& mesh);

/// Weights that are all zero leave nowhere for an effect to act.
void check_weights(TomlTable& root, const solver::Problem& problem);

/// A warning about effects that are on beside the one that they stand for.
void warn_of_doubles(TomlTable& root, const solver::Problem& problem);

/// Signals that the active effects need and [drive] lacks.
void check_signals(TomlTable& root, const EffectSurroundings& in, const solver::Problem& problem);

/// Whether what the case says of its road agrees: a drum that the tire heats, a drum on which the loss was measured, a car
/// that drives on a flat road, sensors that read the flash against the given road.
void check_road(TomlTable& root, const solver::Problem& problem);

/// A warning about heat of sliding of which both its partition and a contact that is resolved give the road a share.
void warn_of_two_shares(TomlTable& root, const GivenSignals& given, const solver::Problem& problem);

/// Warnings about signals that no effect uses, or none but sensors.
void warn_of_unread_signals(TomlTable& root, const GivenSignals& given, const std::vector<std::string>& followed,
                            const solver::Problem& problem);

}  // namespace tiretherm::input
