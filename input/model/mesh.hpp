// SPDX-License-Identifier: BSD-3-Clause
// The table [mesh] as it was read, and its readers by kind.
#pragma once

#include <vector>

#include "input/model/materials.hpp"
#include "input/model/size_limits.hpp"
#include "input/model/tire.hpp"
#include "mesh/builders.hpp"

namespace tiretherm::input {

/// The mesh and what its parts are made of. Without nodes after an error: names of patches and layers are then unknown.
struct MeshTable {
    mesh::Mesh mesh{};
    std::vector<physics::Material> materials{};  ///< [n_layers]
    std::vector<physics::Curve> link_laws{};     ///< [n_links]
    double symmetry = 1.0;                       ///< as Problem::symmetry
};

/// What a mesh is made from.
struct MeshSource {
    TireTable& tire;            ///< takes the density of a lump's material
    std::vector<Stock>& stock;  ///< of which layers use some
    const SizeLimits& limits;
};

[[nodiscard]] MeshTable read_mesh(TomlTable& root, const MeshSource& from);

/// Parts of [mesh], by kind. @returns false after an error
[[nodiscard]] bool read_two_node(TomlTable& mesh, const MeshSource& from, MeshTable& into);
[[nodiscard]] bool read_layers(TomlTable& mesh, const MeshSource& from, MeshTable& into);
[[nodiscard]] bool read_cylinder(TomlTable& mesh, const MeshSource& from, MeshTable& into);
[[nodiscard]] bool read_block(TomlTable& mesh, const MeshSource& from, MeshTable& into);
[[nodiscard]] bool read_axisymmetric(TomlTable& mesh, const MeshSource& from, MeshTable& into);
[[nodiscard]] bool read_section(TomlTable& mesh, const MeshSource& from, MeshTable& into);

/// The list [[mesh.layer]]: name, thickness, cells, ratio, material; fills the materials.
/// @param zones out, the words of each layer's key `zones`; null where a mesh has none
[[nodiscard]] std::vector<mesh::Layer> read_stack(TomlTable& mesh, const MeshSource& from, MeshTable& into,
                                                  std::vector<std::vector<LocatedString>>* zones = nullptr);

}  // namespace tiretherm::input
