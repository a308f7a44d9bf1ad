#pragma once

#include <cstddef>

#include "physics/effect.hpp"

/// How a total is shared out over a mesh: the weights that every distributed effect starts from.
namespace tiretherm::physics {

/// Arc length along the meridian of a node of a section, negative outboard; 0 on any other mesh. @returns m
[[nodiscard]] double along_meridian(const mesh::Mesh& mesh, int node);

/// How far a place of the meridian lies towards the outside shoulder: 1 at its middle and beyond, -1 at the middle of the
/// inside shoulder, straight between; 0 where the mesh has no shoulders.
[[nodiscard]] double towards_outside(const mesh::Mesh& mesh, int node);

/// Fills nodes and weights of an effect with the faces of its patches, by area and, on a section, by a profile of weights
/// against arc length where one is given. The weights sum to 1.
void spread_over_patches(const Setting& setting, ActiveEffect& active, const std::optional<Curve>& profile = {});

/// The same for the cells below the surface layer in the zones of the tread (all cells of a mesh of one layer), by mass.
void spread_over_bulk(const Setting& setting, ActiveEffect& active);

/// Makes the weights sum to 1.
void normalise(ActiveEffect& active);

}  // namespace tiretherm::physics
