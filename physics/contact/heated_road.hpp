// SPDX-License-Identifier: BSD-3-Clause
// A road that the contact heats: the node of drum_heating, which takes a share of what the road takes; the rest meets the
// input's road_temperature.
#pragma once

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// Fills coupling_faces and share_of_drum of an effect in the contact: a face from each of its nodes to the drum, and none
/// where no drum is heated or the drum meets other patches. @pre nodes are placed
void place_heated_road(const PlacementContext& context, ActiveEffect& active);

/// The node of the drum. @pre the effect has coupling faces
[[nodiscard]] inline int drum_of(const EvaluationState& state) {
    return state.mesh.faces[static_cast<std::size_t>(state.active.coupling_faces.front())].b;
}

/// Exchange of an effect's node with the road. @param i position of the node  @param G W/K, >= 0, and its derivative
/// dG_dT [W/K2] with the node's temperature  @param T_road K, of a road that is not heated
void exchange_with_road(const EvaluationState& state, std::size_t i, double G, double T_road, double dG_dT,
                        Terms& terms);

/// Heat W [W] that goes from the drum into an effect's i-th node, and its derivatives [W/K] with the temperatures of the
/// node and of the drum. @pre the effect has coupling faces
void take_from_drum(const EvaluationState& state, std::size_t i, double W, double dW_dT, double dW_dT_drum,
                    Terms& terms);

}  // namespace tiretherm::physics
