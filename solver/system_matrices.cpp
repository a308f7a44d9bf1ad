// SPDX-License-Identifier: BSD-3-Clause
// Matrices of Newton's method, A = C + s K and J = C - s dq/dT, and the relaxation of surface nodes without capacity to
// q = 0.

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/index.hpp"
#include "solver/system.hpp"

namespace tiretherm::solver {

namespace {

/// How nearly a surface without capacity follows the inputs; Newton's next correction would be the square of it. K
constexpr double surface_tolerance = 1e-8;

/// Corrections of a surface after which every other one halves the range in which it must lie: an exponential film, met from
/// far above, lets Newton's method come down by some kelvin only.
constexpr int tangent_surfaces = 8;

}  // namespace

void System::symmetric_matrix(double s, bool steady, Matrix& A) const {
    find_symmetric_part(s, steady, A);
    for (std::size_t i = 0; i < at(pattern_.n) && terms_.nonlinear; ++i) {
        // A loss that grows with temperature keeps A positive definite and makes it the better preconditioner.
        A.value[at(pattern_.diagonal[i])] -= std::min(s * terms_.node_slope[i], 0.0);
    }
}

/// C + s times the conductances.
void System::find_symmetric_part(double s, bool steady, Matrix& A) const {
    const Pattern& p = pattern_;
    const physics::Terms& said = terms_;
    A.pattern = &p;
    A.value.assign(p.nonzeros(), 0.0);
    for (std::size_t i = 0; i < at(p.n); ++i) {
        double diagonal = s * said.node_G[i];
        if (!steady) {
            diagonal += capacity(i, said.temperature[i]);
        }
        A.value[at(p.diagonal[i])] = diagonal;
    }
    for (std::size_t f = 0; f < ends_.size(); ++f) {
        const double G = s * said.face_G[f];
        const auto [a, b] = ends_[f];
        A.value[at(p.diagonal[at(a)])] += G;
        A.value[at(p.diagonal[at(b)])] += G;
        A.value[at(p.ab[f])] -= G;
        A.value[at(p.ba[f])] -= G;
    }
    for (std::size_t i = 0; i < at(p.n); ++i) {  // a surface that nothing touches keeps its temperature
        double& diagonal = A.value[at(p.diagonal[i])];
        diagonal = diagonal == 0.0 ? 1.0 : diagonal;
    }
}

void System::matrices(double s, bool steady, Matrix& A, Matrix& J) const {
    const Pattern& p = pattern_;
    const mesh::Mesh& mesh = problem_->mesh;
    const physics::Terms& said = terms_;
    find_symmetric_part(s, steady, A);
    J.pattern = &p;
    J.value = A.value;
    J.symmetric = true;
    J.outer.clear();
    if (!said.nonlinear) {
        return;
    }
    for (std::size_t i = 0; i < at(p.n); ++i) {
        const double slope = s * said.node_slope[i];
        J.value[at(p.diagonal[i])] -= slope;
        A.value[at(p.diagonal[i])] -= std::min(slope, 0.0);
    }
    for (std::size_t f = 0; f < ends_.size(); ++f) {
        const double dq_dTa = s * said.face_dq_dTa[f];
        const double dq_dTb = s * said.face_dq_dTb[f];
        if (dq_dTa != 0.0 || dq_dTb != 0.0) {
            J.symmetric = false;
            J.value[at(p.diagonal[at(ends_[f][0])])] -= dq_dTa;
            J.value[at(p.ab[f])] -= dq_dTb;
            J.value[at(p.ba[f])] += dq_dTa;
            J.value[at(p.diagonal[at(ends_[f][1])])] += dq_dTb;
        }
    }
    for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
        if (said.region_used[r] != 0) {
            J.outer.push_back({.row = std::span(said.region_slope).subspan(r * at(p.n), at(p.n)),
                               .mean = &mesh.regions[r].mean,
                               .scale = -s});
        }
    }
}

void System::make_consistent(std::span<double> T, std::span<const double> coefficients) {
    const mesh::Mesh& mesh = problem_->mesh;
    // Surface nodes touch no other surface node, so that each Newton correction is a division.
    std::ranges::fill(too_cold_, 0.0);
    std::ranges::fill(too_hot_, std::numeric_limits<double>::infinity());
    for (int iteration = 0;; ++iteration) {
        evaluate(T, coefficients);
        if (mesh.n_cells + std::ssize(mesh.lumped_nodes) == mesh.n_nodes || iteration == 50) {
            return;
        }
        std::vector<double>& stiffness = shifted_;
        for (std::size_t i = 0; i < T.size(); ++i) {
            stiffness[i] = terms_.node_G[i] - terms_.node_slope[i];
        }
        for (std::size_t f = 0; f < ends_.size(); ++f) {
            stiffness[at(ends_[f][0])] += terms_.face_G[f] - terms_.face_dq_dTa[f];
            stiffness[at(ends_[f][1])] += terms_.face_G[f] + terms_.face_dq_dTb[f];
        }
        double largest = 0.0;
        for (std::size_t i = 0; i < T.size(); ++i) {
            if (!has_capacity(i) && stiffness[i] != 0.0) {
                largest = std::max(largest, std::abs(flow_[i] / stiffness[i]));
            }
        }
        if (!(largest > surface_tolerance)) {
            return;
        }
        for (std::size_t i = 0; i < T.size(); ++i) {
            if (has_capacity(i) || stiffness[i] == 0.0) {
                continue;
            }
            // A surface that is colder than it will be takes heat up: what was found of either kind bounds it.
            (flow_[i] > 0.0 ? too_cold_[i] : too_hot_[i]) = T[i];
            const double next = T[i] + flow_[i] / stiffness[i];
            const bool bisect = iteration > tangent_surfaces && iteration % 2 == 1 && std::isfinite(too_hot_[i]);
            T[i] = !bisect && next >= too_cold_[i] && next <= std::min(too_hot_[i], 2.0 * T[i])
                       ? next
                       : std::min(0.5 * (too_cold_[i] + too_hot_[i]), 2.0 * T[i]);
        }
    }
}

}  // namespace tiretherm::solver
