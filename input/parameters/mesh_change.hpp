// SPDX-License-Identifier: BSD-3-Clause
// Changes of a case's [mesh] by the program: finer cells, or the crown of two nodes as layers.
#pragma once

#include <optional>

#include "input/toml/document.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// How the mesh of a case is changed before it is read.
struct MeshChange {
    int finer = 1;        ///< every row of cells has this many times as many
    double layers = 0.0;  ///< m: a crown of two nodes becomes cells through this thickness; 0: it stays
};

/// Changes a table [mesh]. Of two nodes the material stays, and the mass where the thickness is that of
/// `thickness_as_layers`.
void change_mesh(TomlValue& mesh, const MeshChange& change);

/// The thickness through which a crown of two nodes has its mass over its outer area: volume over area. @returns m; nothing
/// of any other mesh
[[nodiscard]] std::optional<double> thickness_as_layers(const solver::Problem& problem);

}  // namespace tiretherm::input
