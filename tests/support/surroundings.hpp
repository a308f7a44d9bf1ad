// SPDX-License-Identifier: BSD-3-Clause
// Surroundings of a patch with a temperature of their own, as an effect for tests.
#pragma once

#include <array>

#include "physics/effect.hpp"

namespace tiretherm::support {

/// Surroundings of a patch with a temperature of their own, which still_air (one air for all) does not offer.
inline constexpr std::array surroundings_parameters{
    physics::ParameterSpec{"h", "W m-2 K-1", 10.0, 0.0, 1e9, "coefficient"},
    physics::ParameterSpec{"T", "K", 293.15, 0.0, 1e4, "temperature of the surroundings"},
};

inline void add_terms_of_surroundings(const physics::EvaluationState& m, physics::Terms& terms) {
    for (const int patch : m.active.patches) {
        for (const mesh::PatchFace& face : m.mesh.patches[static_cast<std::size_t>(patch)].faces) {
            terms.exchange(face.node, m.active[0] * face.area, m.active[1]);
        }
    }
}

inline const physics::Effect surroundings{.id = "surroundings",
                                          .kind = physics::EffectKind::loss,
                                          .on = false,
                                          .equation = "q = h A (T_env - T)",
                                          .source = "the tests",
                                          .meaning = "surroundings with their own temperature",
                                          .parameters = surroundings_parameters,
                                          .choices = {},
                                          .reads = {},
                                          .needs_tire = false,
                                          .patches = {},
                                          .model = physics::HeatEffect{.add_terms = add_terms_of_surroundings}};

}  // namespace tiretherm::support
