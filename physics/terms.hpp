// SPDX-License-Identifier: BSD-3-Clause
// What effects add to the heat balance q_i = sum G (T_j - T_i) + sum G (T_env - T_i) + sum W [W], with derivatives for
// the Jacobian and the watts of each effect.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::physics {

/// What the active effects add at one moment: conductances, exchanges and heat, with the heat budget: watts per effect.
///
///   q_i = sum over faces of G (T_j - T_i) + sum over exchanges of G (T_env - T_i) + sum of W            [W]
///
/// The three verbs are the only way in. Storage is sized once; filling it allocates nothing. Besides the conductances,
/// which make a symmetric positive definite matrix, it keeps what the Jacobian adds: the derivatives of the
/// conductances and of the heat with temperature.
class Terms {
public:
    Terms(const mesh::Mesh& mesh, std::size_t n_effects);

    /// Forgets everything; temperature [n_nodes] K is where the verbs will be called from now on.
    void begin(std::span<const double> temperature);
    /// Watts from now on are attributed to this effect.
    void attribute_to(std::size_t effect) { effect_ = effect; }

    /// Conductance G [W/K] >= 0 of a face, and its derivatives [W/K2] with the temperatures of its nodes a and b.
    void conduct(int face, double G, double dG_dTa = 0.0, double dG_dTb = 0.0) {
        const auto f = static_cast<std::size_t>(face);
        faces_used = true;
        face_G[f] += G;
        if (G < 0.0) {
            note_negative(mesh_->faces[f].a);
        }
        if (dG_dTa != 0.0 || dG_dTb != 0.0) {
            const double drop = drop_across(face);
            face_dq_dTa[f] += dG_dTa * drop;
            face_dq_dTb[f] += dG_dTb * drop;
            nonlinear = faces_vary = true;
        }
    }
    /// The same for one who has the drop T_b - T_a [K] at hand.
    void conduct(int face, double G, double dG_dTa, double dG_dTb, double drop) {
        const auto f = static_cast<std::size_t>(face);
        faces_used = true;
        face_G[f] += G;
        face_dq_dTa[f] += dG_dTa * drop;
        face_dq_dTb[f] += dG_dTb * drop;
        faces_vary = faces_vary || dG_dTa != 0.0 || dG_dTb != 0.0;
        nonlinear = nonlinear || faces_vary;
        if (G < 0.0) {
            note_negative(mesh_->faces[f].a);
        }
    }

    /// Notes the face's conductance where it is negative: for one who adds to `face_G` itself.
    void note_negative_face(int face) {
        if (face_G[static_cast<std::size_t>(face)] < 0.0) {
            note_negative(mesh_->faces[static_cast<std::size_t>(face)].a);
        }
    }

    /// Adds to a face the derivative dG_dT_mean [W/K2] of its conductance with a region's mean temperature.
    void add_conductance_derivative(int face, int region, double dG_dT_mean);

    /// Exchange with surroundings at T_env [K]: G [W/K] >= 0, and its derivative [W/K2] with the node's temperature.
    void exchange(int node, double G, double T_env, double dG_dT = 0.0) {
        const auto n = static_cast<std::size_t>(node);
        const double drop = T_env - temperature[n];
        node_G[n] += G;
        node_q[n] += G * drop;
        watts[effect_] += G * drop;
        if (dG_dT != 0.0) {
            node_slope[n] += dG_dT * drop;
            nonlinear = true;
        }
        if (G < 0.0) {
            note_negative(node);
        }
    }

    /// Heat W [W] into a node, and its derivative [W/K] with the node's temperature.
    void heat(int node, double W, double dW_dT = 0.0) {
        const auto n = static_cast<std::size_t>(node);
        node_q[n] += W;
        watts[effect_] += W;
        if (dW_dT != 0.0) {
            node_slope[n] += dW_dT;
            nonlinear = true;
        }
    }

    /// The same into many nodes, W [W] and dW_dT_mean [W/K], its derivative with a region's mean temperature, in parts.
    /// @param share part of the i-th node
    template <typename Share>
    void share_out(std::span<const int> nodes, Share share, double W, int region, double dW_dT_mean) {
        double* const slope = region_slope.data() + static_cast<std::size_t>(region) * node_q.size();
        double parts = 0.0;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const auto n = static_cast<std::size_t>(nodes[i]);
            const double part = share(i);
            node_q[n] += part * W;
            parts += part;
            slope[n] += part * dW_dT_mean;
        }
        watts[effect_] += parts * W;
        if (dW_dT_mean != 0.0) {
            region_used[static_cast<std::size_t>(region)] = 1;
            nonlinear = true;
        }
    }

    /// Counts watts in the heat budget of another effect instead of the present one's; their sum stays.
    void rebook(std::size_t to_effect, double W) {
        watts[effect_] -= W;
        watts[to_effect] += W;
    }

    /// Adds to a node the derivative dW_dT_mean [W/K] of its heat with a region's mean temperature.
    void add_source_derivative(int node, int region, double dW_dT_mean) {
        if (dW_dT_mean != 0.0) {
            region_slope[static_cast<std::size_t>(region) * node_q.size() + static_cast<std::size_t>(node)] +=
                dW_dT_mean;
            region_used[static_cast<std::size_t>(region)] = 1;
            nonlinear = true;
        }
    }

    /// Adds the terms of an effect without derivatives of its own, taken at T (`here`) and at T + step (`there`).
    void add_difference(const Terms& here, const Terms& there, double step);

    std::vector<double> face_G;           ///< [n_faces] W/K
    std::vector<double> face_dq_dTa;      ///< [n_faces] W/K: (dG/dT_a) (T_b - T_a)
    std::vector<double> face_dq_dTb;      ///< [n_faces] W/K
    std::vector<double> node_G;           ///< [n_nodes] W/K, sum of exchanges
    std::vector<double> node_q;           ///< [n_nodes] W, exchanges and heat, without the faces
    std::vector<double> node_slope;       ///< [n_nodes] W/K, derivative of node_q beyond -node_G
    std::vector<double> region_slope;     ///< [n_regions * n_nodes] W/K
    std::vector<char> region_used;        ///< [n_regions]
    std::vector<double> watts;            ///< [n_effects] W
    std::span<const double> temperature;  ///< [n_nodes] K
    bool faces_used = false;              ///< whether any face has a conductance
    bool faces_vary = false;              ///< whether any conductance follows a temperature at its ends
    bool nonlinear = false;
    int negative_node = -1;  ///< first node given a negative conductance, and by which effect
    int negative_effect = -1;

private:
    void note_negative(int node) {
        if (negative_effect < 0) {
            negative_node = node;
            negative_effect = static_cast<int>(effect_);
        }
    }
    [[nodiscard]] double drop_across(int face) const {
        const mesh::Face& ends = mesh_->faces[static_cast<std::size_t>(face)];
        return temperature[static_cast<std::size_t>(ends.b)] - temperature[static_cast<std::size_t>(ends.a)];
    }

    const mesh::Mesh* mesh_;
    std::size_t effect_ = 0;
};

}  // namespace tiretherm::physics
