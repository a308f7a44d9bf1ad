// SPDX-License-Identifier: BSD-3-Clause
// Reads one table [effects.NAME] into an active effect; values that the table leaves out keep their defaults.
#pragma once

#include "input/cameras/camera.hpp"
#include "physics/effect.hpp"

namespace tiretherm::input {

/// An effect with the numbers, words and patches of its table, standard where the table says nothing:
///     [effects.still_air]
///     h = "10 W/m2K"
///     patches = ["top", "bottom"]
///     h_by_patch = { top = "60 W/m2K" }
[[nodiscard]] physics::ActiveEffect read_active(TomlTable& table, const physics::Effect& effect,
                                                const mesh::Mesh& mesh);

/// The channels of a sensor model, when the sensors are known:
///     [effects.sensor_lag]
///     channels = ["bulk_temperature"]
///     tau_by_channel = { bulk_temperature = "12 s" }
void bind_channels(TomlTable& table, const std::vector<Camera>& cameras, const solver::Problem& problem,
                   physics::ActiveEffect& active);

}  // namespace tiretherm::input
