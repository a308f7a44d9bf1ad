// SPDX-License-Identifier: BSD-3-Clause
// Matrices of Newton's method, A = C + s K and J = C - s dq/dT, and the relaxation of surface nodes without capacity to
// q = 0.

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"
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
    if (terms_.nonlinear) {
        // A loss that grows with temperature keeps A positive definite and makes it the better preconditioner.
        over_nodes(at(pattern_.n), [&](std::size_t i) {
            A.value[at(pattern_.diagonal[i])] -= std::min(s * terms_.node_slope[i], 0.0);
        });
    }
}

/// C + s times the conductances.
void System::find_symmetric_part(double s, bool steady, Matrix& A) const {
    const Pattern& p = pattern_;
    const physics::Terms& said = terms_;
    A.pattern = &p;
    A.value.resize(p.nonzeros());
    over_nodes(at(p.n), [&](std::size_t i) {
        double diagonal = s * said.node_G[i];
        if (!steady) {
            diagonal += capacity(i, said.temperature[i]);
        }
        for (std::size_t e = at(p.start[i]); e < at(p.start[i + 1]); ++e) {
            if (const int f = face_of_[e]; f >= 0) {
                const double G = s * said.face_G[at(f)];
                diagonal += G;
                A.value[e] = -G;
            }
        }
        A.value[at(p.diagonal[i])] = diagonal;
    });
    for (const std::size_t f : second_faces_) {
        const double G = s * said.face_G[f];
        A.value[at(p.diagonal[at(problem_->mesh.faces[f].a)])] += G;
        A.value[at(p.diagonal[at(problem_->mesh.faces[f].b)])] += G;
        A.value[at(p.ab[f])] -= G;
        A.value[at(p.ba[f])] -= G;
    }
    over_nodes(at(p.n), [&](std::size_t i) {  // a surface that nothing touches keeps its temperature
        double& diagonal = A.value[at(p.diagonal[i])];
        diagonal = diagonal == 0.0 ? 1.0 : diagonal;
    });
}

void System::matrices(double s, bool steady, Matrix& A, Matrix& J) const {
    const Pattern& p = pattern_;
    const mesh::Mesh& mesh = problem_->mesh;
    const physics::Terms& said = terms_;
    find_symmetric_part(s, steady, A);
    J.pattern = &p;
    J.value.resize(A.value.size());
    copy_nodes(A.value, J.value);
    J.symmetric = true;
    J.outer.clear();
    if (!said.nonlinear) {
        return;
    }
    over_nodes(at(p.n), [&](std::size_t i) {
        const double slope = s * said.node_slope[i];
        J.value[at(p.diagonal[i])] -= slope;
        A.value[at(p.diagonal[i])] -= std::min(slope, 0.0);
    });
    if (said.faces_vary) {
        J.symmetric = !add_slopes_of_faces(s, J);
    }
    for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
        if (said.region_used[r] != 0) {
            J.outer.push_back({.row = std::span(said.region_slope).subspan(r * at(p.n), at(p.n)),
                               .mean = &mesh.regions[r].mean,
                               .scale = -s});
        }
    }
}

/// Takes s times the derivatives of the faces' conductances off J. @returns whether there are any
bool System::add_slopes_of_faces(double s, Matrix& J) const {
    const Pattern& p = pattern_;
    const std::vector<double>& of_a = terms_.face_dq_dTa;
    const std::vector<double>& of_b = terms_.face_dq_dTb;
    const double slopes = sum_over_nodes(at(p.n), [&](std::size_t i) {
        double diagonal = 0.0;
        double any = 0.0;
        for (std::size_t e = at(p.start[i]); e < at(p.start[i + 1]); ++e) {
            if (const int face = face_of_[e]; face >= 0) {
                const std::size_t f = at(face);
                const bool is_a = at(p.ab[f]) == e;
                diagonal += s * (is_a ? -of_a[f] : of_b[f]);
                J.value[e] += s * (is_a ? -of_b[f] : of_a[f]);
                any = of_a[f] != 0.0 || of_b[f] != 0.0 ? 1.0 : any;
            }
        }
        J.value[at(p.diagonal[i])] += diagonal;
        return any;
    });
    for (const std::size_t f : second_faces_) {
        J.value[at(p.diagonal[at(problem_->mesh.faces[f].a)])] -= s * of_a[f];
        J.value[at(p.ab[f])] -= s * of_b[f];
        J.value[at(p.ba[f])] += s * of_a[f];
        J.value[at(p.diagonal[at(problem_->mesh.faces[f].b)])] += s * of_b[f];
    }
    return slopes > 0.0;
}

void System::make_consistent(std::span<double> T, std::span<const double> coefficients) {
    // Surface nodes touch no other surface node, so that each Newton correction is a division.
    for (Surface& surface : surfaces_) {
        surface.too_cold = 0.0;
        surface.too_hot = std::numeric_limits<double>::infinity();
    }
    for (int iteration = 0;; ++iteration) {
        evaluate(T, coefficients);
        if (surfaces_.empty() || iteration == 50) {
            return;
        }
        find_stiffness_of_surfaces();
        double largest = 0.0;
        for (const Surface& surface : surfaces_) {
            if (surface.stiffness != 0.0) {
                largest = std::max(largest, std::abs(flow_[surface.node] / surface.stiffness));
            }
        }
        if (!(largest > surface_tolerance)) {
            return;
        }
        for (Surface& surface : surfaces_) {
            if (surface.stiffness == 0.0) {
                continue;
            }
            // A surface that is colder than it will be takes heat up: what was found of either kind bounds it.
            double& t = T[surface.node];
            const double flow = flow_[surface.node];
            (flow > 0.0 ? surface.too_cold : surface.too_hot) = t;
            const double next = t + flow / surface.stiffness;
            const bool bisect = iteration > tangent_surfaces && iteration % 2 == 1 && std::isfinite(surface.too_hot);
            t = !bisect && next >= surface.too_cold && next <= std::min(surface.too_hot, 2.0 * t)
                    ? next
                    : std::min(0.5 * (surface.too_cold + surface.too_hot), 2.0 * t);
        }
    }
}

void System::find_stiffness_of_surfaces() {
    for (Surface& surface : surfaces_) {
        surface.stiffness = terms_.node_G[surface.node] - terms_.node_slope[surface.node];
    }
    for (const SurfaceFace& at_surface : surface_faces_) {
        const std::size_t f = at_surface.face;
        surfaces_[at_surface.surface].stiffness +=
            terms_.face_G[f] + (at_surface.is_a ? -terms_.face_dq_dTa[f] : terms_.face_dq_dTb[f]);
    }
}

}  // namespace tiretherm::solver
