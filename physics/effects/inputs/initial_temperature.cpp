// SPDX-License-Identifier: BSD-3-Clause
// Correction of the initial state: T(0) = stated + offset in the named layers.

#include <algorithm>
#include <array>

#include "physics/effect.hpp"

namespace tiretherm::physics::effects {

namespace {

enum : std::size_t { offset };

constexpr std::array parameters{
    ParameterSpec{"offset", "K", 0.0, -200.0, 200.0, "true temperature at the start less the stated one", true, 0.0},
};
constexpr std::array plausible{
    PlausibleRange{"offset", -15.0, 15.0, "from a warm garage or the last run, some K to 15 K; recalled",
                   "the run began before the log, or the first readings are not of this tire"},
};
constexpr std::array scopes{Scope::layer};

/// Surface nodes belong to their cell's layer, lumped nodes to none.
void start(const ActiveEffect& active, const mesh::Mesh& mesh, std::span<double> temperature) {
    for (std::size_t node = 0; node < temperature.size(); ++node) {
        const int layer = mesh.layer[node];
        if (std::find(active.layers.begin(), active.layers.end(), layer) != active.layers.end()) {
            temperature[node] += active.at(offset, Scope::layer, layer);
        }
    }
}

}  // namespace

extern const Effect initial_temperature;
const Effect initial_temperature{
    .id = "initial_temperature",
    .kind = EffectKind::state,
    .equation = "T(0) = stated + offset in the layers named",
    .source = "definition",
    .valid = "layers that start even",
    .meaning =
        "Layers that start elsewhere than stated, such as a tire that soaked in the sun. What it changes decays with "
        "the time constants and leaves nothing. Without an offset it does nothing.",
    .parameters = parameters,
    .plausible = plausible,
    .scopes = scopes,
    .on_layers = true,
    .model = InputCorrection{.start = start},
};

}  // namespace tiretherm::physics::effects
