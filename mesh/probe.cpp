// SPDX-License-Identifier: BSD-3-Clause
// Linear interpolation on a tensor product, with even parabolas at planes of symmetry, and exact overlaps of discs and
// Gaussian spots with rectangular or ring-shaped faces.

#include "mesh/probe.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/column_probe.hpp"
#include "mesh/index.hpp"

namespace tiretherm::mesh {

namespace {

/// Positions of an axis with their weights at a coordinate. Index -1 and n stand for the surface nodes at either end.
struct Stencil {
    std::vector<int> index;
    std::vector<double> weight;
};

/// @param low, high whether surface nodes may be used at the ends of this axis
Stencil stencil(const Grid& grid, int axis, double x, bool low, bool high) {
    const std::vector<double>& centre = grid.centre[at(axis)];
    const std::vector<double>& edge = grid.edge[at(axis)];
    const int n = grid.size(axis);
    if (n == 1 && !low && !high) {
        return {{0}, {1.0}};
    }
    if (grid.mirror[at(axis)] && n > 1 && x < centre[0]) {
        // Even about the lower end: T = a + b s^2 through the first two centres.
        const double s0 = centre[0] - edge[0];
        const double s1 = centre[1] - edge[0];
        const double s = x - edge[0];
        const double w = (s * s - s0 * s0) / (s1 * s1 - s0 * s0);
        return {{0, 1}, {1.0 - w, w}};
    }
    // The centres are numbered from 0; an end that has a surface is -1 below them, n above.
    const auto position = [&](int i) { return i < 0 ? edge.front() : i < n ? centre[at(i)] : edge.back(); };
    int next = static_cast<int>(std::upper_bound(centre.begin(), centre.end(), x) - centre.begin());
    next = std::clamp(next, low ? 0 : 1, high ? n : n - 1);
    const double left = position(next - 1);
    const double w = (x - left) / (position(next) - left);
    return {{next - 1, next}, {1.0 - w, w}};
}

/// Area of the disc of radius a about the origin inside [0, x] x [0, y]; x, y >= 0.
double quadrant_overlap(double x, double y, double a) {
    x = std::min(x, a);
    y = std::min(y, a);
    const double reach = std::sqrt(std::max(0.0, a * a - y * y));
    if (x <= reach) {
        return x * y;
    }
    const auto primitive = [a](double u) {
        return 0.5 * (u * std::sqrt(std::max(0.0, a * a - u * u)) + a * a * std::asin(std::clamp(u / a, -1.0, 1.0)));
    };
    return y * reach + primitive(x) - primitive(reach);
}

double signed_overlap(double x, double y, double a) {
    const double sign = (x < 0.0) == (y < 0.0) ? 1.0 : -1.0;
    return sign * quadrant_overlap(std::abs(x), std::abs(y), a);
}

/// Over the faces of a patch: `ring` of the radii, or `primitive` by inclusion and exclusion of the corners.
template <typename Ring, typename Primitive>
std::vector<double> integrate(const Mesh& mesh, int patch, Ring ring, Primitive primitive) {
    std::vector<double> result;
    const bool round = mesh.grid && mesh.grid->metric == Metric::axisymmetric;
    for (const PatchFace& face : mesh.patches[at(patch)].faces) {
        const auto [x0, x1, y0, y1] = face.extent;
        result.push_back(round ? ring(x1) - ring(x0)
                               : primitive(x1, y1) - primitive(x0, y1) - primitive(x1, y0) + primitive(x0, y0));
    }
    return result;
}

}  // namespace

bool contains(const Mesh& mesh, const Point& point) {
    if (!mesh.columns.empty()) {
        return in_columns(mesh, point);
    }
    if (!mesh.grid) {
        return false;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double>& edge = mesh.grid->edge[axis];
        const double slack = 1e-9 * (edge.back() - edge.front());
        if (point[axis] < edge.front() - slack || point[axis] > edge.back() + slack) {
            return false;
        }
    }
    return true;
}

Functional at_point(const Mesh& mesh, const Point& point) {
    if (!mesh.columns.empty()) {
        return at_column_point(mesh, point);
    }
    const Grid& grid = *mesh.grid;
    const bool top = !grid.surface[static_cast<std::size_t>(Side::z_min)].empty();
    const bool bottom = !grid.surface[static_cast<std::size_t>(Side::z_max)].empty();
    const Stencil z = stencil(grid, 2, point[2], top, bottom);
    Functional result;
    for (std::size_t c = 0; c < z.index.size(); ++c) {
        if (z.weight[c] == 0.0) {
            continue;
        }
        const int k = z.index[c];
        const bool on_surface = k < 0 || k == grid.size(2);
        // There is no node where two sides meet: along a surface the outermost faces are extrapolated instead.
        const auto has = [&](Side side) {
            return !on_surface && !grid.surface[static_cast<std::size_t>(side)].empty();
        };
        const Stencil x = stencil(grid, 0, point[0], has(Side::x_min), has(Side::x_max));
        for (std::size_t a = 0; a < x.index.size(); ++a) {
            const int i = x.index[a];
            const bool on_side = i < 0 || i == grid.size(0);
            const Stencil y = stencil(grid, 1, point[1], !on_side && has(Side::y_min), !on_side && has(Side::y_max));
            for (std::size_t b = 0; b < y.index.size(); ++b) {
                const int j = y.index[b];
                int node = 0;
                if (k < 0 || k == grid.size(2)) {
                    node = grid.surface_node(k < 0 ? Side::z_min : Side::z_max, i, j, 0);
                } else if (on_side) {
                    node = grid.surface_node(i < 0 ? Side::x_min : Side::x_max, 0, j, k);
                } else if (j < 0 || j == grid.size(1)) {
                    node = grid.surface_node(j < 0 ? Side::y_min : Side::y_max, i, 0, k);
                } else {
                    node = grid.cell(i, j, k);
                }
                if (const double w = z.weight[c] * x.weight[a] * y.weight[b]; w != 0.0) {
                    result.add(node, w);
                }
            }
        }
    }
    return result;
}

std::vector<double> disc_overlap(const Mesh& mesh, int patch, double radius) {
    const double pi = std::acos(-1.0);
    return integrate(
        mesh, patch, [&](double r) { return pi * std::min(r, radius) * std::min(r, radius); },
        [&](double x, double y) { return signed_overlap(x, y, radius); });
}

std::vector<double> gaussian_overlap(const Mesh& mesh, int patch, double waist) {
    const double s = std::sqrt(2.0) / waist;
    return integrate(
        mesh, patch, [&](double r) { return -std::expm1(-s * s * r * r); },
        [&](double x, double y) { return 0.25 * std::erf(s * x) * std::erf(s * y); });
}

Functional over_disc(const Mesh& mesh, int patch, double radius) {
    const std::vector<double> overlap = disc_overlap(mesh, patch, radius);
    Functional mean;
    for (std::size_t i = 0; i < overlap.size(); ++i) {
        if (overlap[i] > 0.0) {
            mean.nodes.push_back(mesh.patches[at(patch)].faces[i].node);
            mean.weights.push_back(overlap[i]);
        }
    }
    mean.normalise();
    return mean;
}

Functional over_patch(const Mesh& mesh, int patch) {
    Functional mean;
    for (const PatchFace& face : mesh.patches[at(patch)].faces) {
        mean.nodes.push_back(face.node);
        mean.weights.push_back(face.area);
    }
    mean.normalise();
    return mean;
}

Functional over_cells(const Mesh& mesh, int layer, int zone) {
    Functional mean;
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        if ((layer < 0 || mesh.layer[at(cell)] == layer) && (zone < 0 || mesh.zone[at(cell)] == zone)) {
            mean.nodes.push_back(cell);
            mean.weights.push_back(mesh.volume[at(cell)]);
        }
    }
    mean.normalise();
    return mean;
}

}  // namespace tiretherm::mesh
