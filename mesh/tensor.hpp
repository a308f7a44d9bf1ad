// SPDX-License-Identifier: BSD-3-Clause
// Common description of all tensor-product meshes (edges on three axes, layer of each cell, named sides) and the
// function that builds them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "mesh/builders.hpp"

namespace tiretherm::mesh {

/// What the tensor-product builders share: edges on three axes, the layer of each cell through the thickness.
struct Tensor {
    std::string kind;
    bool stack = false;  ///< one cell across: a place is a depth
    Metric metric = Metric::cartesian;
    double outer_radius = 0.0;  ///< m, of a cylinder
    std::array<std::vector<double>, 3> edge;
    std::vector<int> layer_of_k;  ///< [n_z]
    std::vector<std::string> layers;
    std::array<bool, 3> mirror{};
    std::array<std::string, 6> patch;  ///< name for each Side; empty: adiabatic
    int link_below = -1;               ///< layer below which faces carry link 0, or -1
    double link_length = 0.0;
};

/// Edges and the layer of each cell of a stack. Outer surface at depth 0.
struct StackEdges {
    std::vector<double> edge;
    std::vector<int> layer_of_cell;
    std::vector<std::string> names;
};
[[nodiscard]] StackEdges stack_edges(const std::vector<Layer>& stack);

[[nodiscard]] Mesh build(const Tensor& description);

}  // namespace tiretherm::mesh
