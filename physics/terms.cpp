// SPDX-License-Identifier: BSD-3-Clause
// Storage that is sized once and cleared before each evaluation; difference quotients for effects without derivatives
// of their own.

#include "physics/terms.hpp"

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::physics {

Terms::Terms(const mesh::Mesh& mesh, std::size_t n_effects)
    : face_G(mesh.faces.size()),
      face_dq_dTa(mesh.faces.size()),
      face_dq_dTb(mesh.faces.size()),
      node_G(at(mesh.n_nodes)),
      node_q(at(mesh.n_nodes)),
      node_slope(at(mesh.n_nodes)),
      region_slope(mesh.regions.size() * at(mesh.n_nodes)),
      region_used(mesh.regions.size()),
      watts(n_effects),
      mesh_(&mesh) {}

void Terms::begin(std::span<const double> at_temperature) {
    temperature = at_temperature;
    for (std::vector<double>* values : {&node_G, &node_q, &node_slope, &watts}) {
        clear_nodes(*values);
    }
    if (faces_used) {
        clear_nodes(face_G);
        faces_used = false;
    }
    if (faces_vary) {
        clear_nodes(face_dq_dTa);
        clear_nodes(face_dq_dTb);
        faces_vary = false;
    }
    const auto n = at(mesh_->n_nodes);
    for (std::size_t region = 0; region < region_used.size(); ++region) {
        if (region_used[region] != 0) {
            clear_nodes(std::span(region_slope).subspan(region * n, n));
            region_used[region] = 0;
        }
    }
    nonlinear = false;
    negative_node = negative_effect = -1;
}

void Terms::add_conductance_derivative(int face, int region, double dG_dT_mean) {
    const mesh::Face& ends = mesh_->faces[at(face)];
    const double change = dG_dT_mean * drop_across(face);
    add_source_derivative(ends.a, region, change);
    add_source_derivative(ends.b, region, -change);
}

void Terms::add_difference(const Terms& here, const Terms& there, double step) {
    over_nodes(node_q.size(), [&](std::size_t n) {
        node_G[n] += here.node_G[n];
        node_q[n] += here.node_q[n];
        node_slope[n] += (there.node_q[n] - here.node_q[n]) / step + here.node_G[n];
    });
    for (std::size_t e = 0; e < watts.size(); ++e) {
        watts[e] += here.watts[e];
    }
    if (here.negative_effect >= 0 && negative_effect < 0) {
        negative_node = here.negative_node;
        negative_effect = here.negative_effect;
    }
    nonlinear = true;
}

}  // namespace tiretherm::physics
