// SPDX-License-Identifier: BSD-3-Clause
// How a total heat or conductance is distributed over the nodes of a mesh: the weights that distributed effects start
// from.
#pragma once

#include <cstddef>

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// How the contact is loaded across the tread: the table of every effect that acts in it.
inline constexpr Table contact_profile{"profile", "m", "1",
                                       "weight along the meridian, against the arc length from the centre plane "
                                       "(negative outboard); without it the contact "
                                       "is as wide as the tread and evenly loaded"};

/// Arc length along the meridian of a node of a section, negative outboard; 0 on any other mesh. @returns m
[[nodiscard]] double along_meridian(const mesh::Mesh& mesh, int node);

/// How far a place of the meridian lies towards the outside shoulder: 1 at its middle and beyond, -1 at the middle of the
/// inside shoulder, straight between; 0 where the mesh has no shoulders.
[[nodiscard]] double towards_outside(const mesh::Mesh& mesh, int node);

/// Half the width of the tread along the meridian. @returns m
[[nodiscard]] double half_tread(const mesh::Mesh& mesh);

/// Fills nodes and weights of an effect with the faces of its patches, by area and, on a section, by a profile of weights
/// against arc length where one is given; with those of a field of a structural code where it has one. The weights sum to
/// 1.
void spread_over_patches(const PlacementContext& context, ActiveEffect& active,
                         const std::optional<Curve>& profile = {});

/// The same for the cells below the surface layer in the zones of the tread (all cells of a mesh of one layer), by mass.
void spread_over_bulk(const PlacementContext& context, ActiveEffect& active);

/// Couples every face of an effect's patches to its lumped node. @returns the coupling faces
[[nodiscard]] std::vector<int> couple_patches(mesh::Mesh& mesh, const ActiveEffect& active, int lumped_node);

/// Area of an effect's coupling faces. @returns m2
[[nodiscard]] double coupling_area(const mesh::Mesh& mesh, const ActiveEffect& active);

/// Couples the nodes "gas" and "rim" when both are there and not coupled yet, whichever came first.
void couple_gas_and_rim(mesh::Mesh& mesh);
/// The face between them, or -1.
[[nodiscard]] int face_between_gas_and_rim(const mesh::Mesh& mesh);

/// Makes the weights sum to 1.
void normalise(ActiveEffect& active);

/// Adds an effect whose first coefficient is a conductance [W/K] to surroundings and whose second is that times their
/// temperature [W]: shares it out by the weights.
void exchange_by_weights(const EvaluationState& state, Terms& terms);

}  // namespace tiretherm::physics
