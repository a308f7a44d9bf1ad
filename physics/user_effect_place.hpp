// SPDX-License-Identifier: BSD-3-Clause
// Where a user effect acts: the nodes of a named part of the mesh and the share of each node.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// Whether an effect of the catalogue is the pattern of user effects.
[[nodiscard]] bool is_user_effect(const Effect& effect);

/// Nodes of a part of the mesh: a region, or else a layer, a zone, a patch. @returns none when no part has the name
[[nodiscard]] std::vector<int> nodes_of_place(const mesh::Mesh& mesh, std::string_view name);
/// All names that `nodes_of_place` knows, each once.
[[nodiscard]] std::vector<std::string> names_of_places(const mesh::Mesh& mesh);

/// How the nodes share what is given to them all: cells by heat capacity, surface nodes by area, a node beside the cells
/// takes it alone. @returns [nodes] J/K or m2; empty when the nodes are of several sorts and cannot share
[[nodiscard]] std::vector<double> shares_of_nodes(const mesh::Mesh& mesh, std::span<const Material> materials,
                                                  std::span<const int> nodes);

/// `place` of a user effect: it acts on the nodes with which it was switched on.
void place_user_effect(const PlacementContext& context, ActiveEffect& active);

/// `invalid_on_mesh` of a user effect: it needs a signal to follow and a place.
[[nodiscard]] std::string user_effect_invalid_on_mesh(const ActiveEffect& active, const mesh::Mesh& mesh);

}  // namespace tiretherm::physics
