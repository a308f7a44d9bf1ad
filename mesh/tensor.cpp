// SPDX-License-Identifier: BSD-3-Clause
// Builds layers, cylinders, blocks and discs. Half distances in a cylinder are r |ln(r/r_c)|, r of the face and r_c of
// the cell centre, so that the steady profile T ~ ln r is exact.

#include "mesh/tensor.hpp"

#include <cmath>
#include <numbers>

#include "mesh/index.hpp"

namespace tiretherm::mesh {

namespace {

/// Lengths, areas and volumes of one cell of the tensor product, for either metric.
struct Metrics {
    const Grid& grid;

    [[nodiscard]] double low(int axis, int i) const { return grid.edge[at(axis)][at(i)]; }
    [[nodiscard]] double high(int axis, int i) const { return grid.edge[at(axis)][at(i + 1)]; }
    [[nodiscard]] double width(int axis, int i) const { return high(axis, i) - low(axis, i); }

    /// Area of the cell's base normal to the depth: a rectangle, or a ring; about an axis below it shrinks with the depth.
    [[nodiscard]] double base(int i, int j, double depth) const {
        switch (grid.metric) {
            case Metric::cartesian:
                break;
            case Metric::axisymmetric:
                return std::numbers::pi * (high(0, i) + low(0, i)) * width(0, i);
            case Metric::cylindrical:
                return width(0, i) * width(1, j) * (1.0 - depth / grid.outer_radius);
        }
        return width(0, i) * width(1, j);
    }

    [[nodiscard]] double volume(int i, int j, int k) const { return base(i, j, grid.centre[2][at(k)]) * width(2, k); }

    /// Area of the face at the upper end of `axis`.
    [[nodiscard]] double face(int axis, int i, int j, int k, double position) const {
        if (axis == 2) {
            return base(i, j, position);
        }
        if (axis == 1) {
            return width(0, i) * width(2, k);
        }
        const double breadth = grid.metric == Metric::axisymmetric ? 2.0 * std::numbers::pi * position : width(1, j);
        return breadth * width(2, k);
    }

    /// Distance from a cell's centre to a face at `position`. Plain also along the radius of a disc: a field that is
    /// regular on the axis goes with r^2, for which the flux through r = (r1 + r2)/2 is exactly (T2 - T1)/(r2 - r1); the
    /// logarithm of a tube would spoil the order there. A cylinder is hollow: its half distances make the steady profile,
    /// T ~ ln r, exact, for the face's radius times the logarithm is what the face's area is to be divided by.
    [[nodiscard]] double half(int axis, int i, double position) const {
        const double centre = grid.centre[at(axis)][at(i)];
        if (axis == 2 && grid.metric == Metric::cylindrical) {
            const double radius = grid.outer_radius - position;
            return radius * std::abs(std::log(radius / (grid.outer_radius - centre)));
        }
        return std::abs(position - centre);
    }
};

void add_cells(Mesh& mesh, const Tensor& d, const Metrics& metrics) {
    const Grid& g = *mesh.grid;
    for (int k = 0; k < g.size(2); ++k) {
        for (int j = 0; j < g.size(1); ++j) {
            for (int i = 0; i < g.size(0); ++i) {
                mesh.add_cell(metrics.volume(i, j, k), {g.centre[0][at(i)], g.centre[1][at(j)], g.centre[2][at(k)]},
                              d.layer_of_k[at(k)]);
            }
        }
    }
}

void add_inner_faces(Mesh& mesh, const Tensor& d, const Metrics& metrics) {
    const Grid& g = *mesh.grid;
    const int sides = 2 * mesh.n_cells / g.size(0) + 2 * mesh.n_cells / g.size(1) + 2 * mesh.n_cells / g.size(2);
    mesh.faces.reserve(at(3 * mesh.n_cells + sides));
    for (int k = 0; k < g.size(2); ++k) {
        for (int j = 0; j < g.size(1); ++j) {
            for (int i = 0; i < g.size(0); ++i) {
                const std::array<int, 3> index{i, j, k};
                for (int axis = 0; axis < 3; ++axis) {
                    std::array<int, 3> next = index;
                    if (++next[at(axis)] == g.size(axis)) {
                        continue;
                    }
                    const double position = metrics.high(axis, index[at(axis)]);
                    const bool linked =
                        axis == 2 && d.layer_of_k[at(k)] == d.link_below && d.layer_of_k[at(k + 1)] != d.link_below;
                    mesh.faces.push_back({.a = g.cell(i, j, k),
                                          .b = g.cell(next[0], next[1], next[2]),
                                          .area = metrics.face(axis, i, j, k, position),
                                          .half_a = metrics.half(axis, index[at(axis)], position),
                                          .half_b = metrics.half(axis, next[at(axis)], position),
                                          .link = linked ? 0 : -1,
                                          .axis = static_cast<Axis>(axis)});
                }
            }
        }
    }
}

void add_side(Mesh& mesh, const std::string& name, Side side, const Metrics& metrics) {
    Grid& g = *mesh.grid;
    const int axis = static_cast<int>(side) / 2;
    const bool upper = static_cast<int>(side) % 2 == 1;
    const int patch = mesh.add_patch(name);
    std::array<int, 3> size{g.size(0), g.size(1), g.size(2)};
    size[at(axis)] = 1;
    const int end = upper ? g.size(axis) - 1 : 0;
    const double position = upper ? metrics.high(axis, end) : metrics.low(axis, end);
    for (int k = 0; k < size[2]; ++k) {
        for (int j = 0; j < size[1]; ++j) {
            for (int i = 0; i < size[0]; ++i) {
                std::array<int, 3> index{i, j, k};
                index[at(axis)] = end;
                const int cell = g.cell(index[0], index[1], index[2]);
                Point place = mesh.centre[at(cell)];
                place[at(axis)] = position;
                const double area = metrics.face(axis, index[0], index[1], index[2], position);
                const int node = mesh.add_patch_face(patch, cell, area, metrics.half(axis, end, position), place,
                                                     static_cast<Axis>(axis));
                g.surface[static_cast<std::size_t>(side)].push_back(node);
                if (axis == 2) {
                    mesh.patches[at(patch)].faces.back().extent = {metrics.low(0, i), metrics.high(0, i),
                                                                   metrics.low(1, j), metrics.high(1, j)};
                }
            }
        }
    }
}

/// Points of a plane of x and depth (one cell across), a line of depth, or the full block.
void draw(Mesh& mesh) {
    const Grid& g = *mesh.grid;
    const bool flat = g.size(1) == 1;
    const bool line = flat && g.size(0) == 1;
    const int nx = line ? 1 : g.size(0) + 1;
    const int ny = flat ? 1 : g.size(1) + 1;
    const int nz = g.size(2) + 1;
    const auto point = [&](int i, int j, int k) { return i + nx * (j + ny * k); };
    for (int k = 0; k < nz; ++k) {
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const double x = line ? g.centre[0][0] : g.edge[0][at(i)];
                const double y = flat ? g.centre[1][0] : g.edge[1][at(j)];
                // Depth points down, so that the outer surface is on top in a viewer.
                mesh.drawing.points.push_back({x, y, -g.edge[2][at(k)]});
            }
        }
    }
    mesh.drawing.shape = line ? CellShape::line : flat ? CellShape::quadrilateral : CellShape::hexahedron;
    std::vector<int>& c = mesh.drawing.corners;
    for (int k = 0; k < g.size(2); ++k) {
        for (int j = 0; j < g.size(1); ++j) {
            for (int i = 0; i < g.size(0); ++i) {
                if (line) {
                    c.insert(c.end(), {point(0, 0, k), point(0, 0, k + 1)});
                } else if (flat) {
                    c.insert(c.end(), {point(i, 0, k + 1), point(i + 1, 0, k + 1), point(i + 1, 0, k), point(i, 0, k)});
                } else {
                    for (const int layer : {k + 1, k}) {
                        c.insert(c.end(), {point(i, j, layer), point(i + 1, j, layer), point(i + 1, j + 1, layer),
                                           point(i, j + 1, layer)});
                    }
                }
            }
        }
    }
}

}  // namespace

StackEdges stack_edges(const std::vector<Layer>& stack) {
    StackEdges result;
    std::vector<Segment> segments;
    double depth = 0.0;
    for (std::size_t i = 0; i < stack.size(); ++i) {
        depth += stack[i].thickness;
        segments.push_back({.to = depth, .cells = stack[i].cells, .ratio = stack[i].ratio});
        result.layer_of_cell.insert(result.layer_of_cell.end(), at(stack[i].cells), static_cast<int>(i));
        result.names.push_back(stack[i].name);
    }
    result.edge = edges(0.0, segments);
    return result;
}

Mesh build(const Tensor& description) {
    Mesh mesh;
    mesh.kind = description.kind;
    mesh.layers = description.layers;
    Grid grid{.metric = description.metric,
              .outer_radius = description.outer_radius,
              .edge = description.edge,
              .centre = {},
              .mirror = description.mirror,
              .surface = {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i + 1 < grid.edge[axis].size(); ++i) {
            grid.centre[axis].push_back(0.5 * (grid.edge[axis][i] + grid.edge[axis][i + 1]));
        }
    }
    mesh.grid = std::move(grid);
    mesh.stack = description.stack;
    const Metrics metrics{*mesh.grid};
    add_cells(mesh, description, metrics);
    add_inner_faces(mesh, description, metrics);
    for (std::size_t side = 0; side < 6; ++side) {
        if (!description.patch[side].empty()) {
            add_side(mesh, description.patch[side], static_cast<Side>(side), metrics);
        }
    }
    draw(mesh);

    Functional surface;
    const std::string& outside = description.patch[static_cast<std::size_t>(Side::z_min)];
    for (const PatchFace& face : mesh.patches[at(mesh.find_patch(outside))].faces) {
        surface.nodes.push_back(face.node);
        surface.weights.push_back(face.area);
    }
    Functional bulk;
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        if (mesh.layers.size() == 1 || mesh.layer[at(cell)] > 0) {
            bulk.nodes.push_back(cell);
            bulk.weights.push_back(mesh.volume[at(cell)]);
        }
    }
    surface.normalise();
    bulk.normalise();
    mesh.regions = {{.name = "surface", .mean = std::move(surface)}, {.name = "bulk", .mean = std::move(bulk)}};
    if (description.link_below >= 0) {
        mesh.links = {{.name = "bulk_to_surface", .length = description.link_length, .region = 1}};
    }
    return mesh;
}

Mesh build(const Layers& description) {
    const StackEdges stack = stack_edges(description.stack);
    Tensor tensor{.kind = "layers",
                  .stack = true,
                  .metric = Metric::cartesian,
                  .edge = {},
                  .layer_of_k = stack.layer_of_cell,
                  .layers = stack.names,
                  .mirror = {},
                  .patch = {},
                  .link_below = description.link_below,
                  .link_length = description.link_length};
    tensor.edge = {std::vector<double>{0.0, description.area}, std::vector<double>{0.0, 1.0}, stack.edge};
    tensor.patch[static_cast<std::size_t>(Side::z_min)] = "outside";
    tensor.patch[static_cast<std::size_t>(Side::z_max)] = "inside";
    return build(tensor);
}

Mesh build(const Cylinder& description) {
    const StackEdges stack = stack_edges(description.stack);
    const double outer_radius = description.inner_radius + stack.edge.back();
    Tensor tensor{.kind = "cylinder",
                  .stack = true,
                  .metric = Metric::cylindrical,
                  .outer_radius = outer_radius,
                  .edge = {},
                  .layer_of_k = stack.layer_of_cell,
                  .layers = stack.names,
                  .mirror = {},
                  .patch = {}};
    tensor.edge = {std::vector<double>{0.0, description.length},
                   std::vector<double>{0.0, 2.0 * std::numbers::pi * outer_radius}, stack.edge};
    tensor.patch[static_cast<std::size_t>(Side::z_min)] = "outside";
    tensor.patch[static_cast<std::size_t>(Side::z_max)] = "inside";
    return build(tensor);
}

Mesh build(const Block& description) {
    const StackEdges stack = stack_edges(description.stack);
    const auto start = [&](const std::vector<Segment>& s) { return description.quarter ? 0.0 : -s.back().to; };
    Tensor tensor{.kind = "patch",
                  .metric = Metric::cartesian,
                  .edge = {},
                  .layer_of_k = stack.layer_of_cell,
                  .layers = stack.names,
                  .mirror = {description.quarter, description.quarter, false},
                  .patch = {}};
    tensor.edge = {edges(start(description.x), description.x), edges(start(description.y), description.y), stack.edge};
    tensor.patch = {"", "", "", "", "top", "bottom"};
    if (description.side_patches) {
        // A plane, one cell across, is adiabatic in that direction.
        const bool plane = tensor.edge[1].size() == 2;
        const bool low = !description.quarter;
        tensor.patch = {low ? "left" : "", "right", low && !plane ? "front" : "", plane ? "" : "back", "top", "bottom"};
    }
    return build(tensor);
}

Mesh build(const Axisymmetric& description) {
    const StackEdges stack = stack_edges(description.stack);
    Tensor tensor{.kind = "patch",
                  .metric = Metric::axisymmetric,
                  .edge = {},
                  .layer_of_k = stack.layer_of_cell,
                  .layers = stack.names,
                  .mirror = {true, false, false},
                  .patch = {}};
    tensor.edge = {edges(0.0, description.radius), std::vector<double>{0.0, 1.0}, stack.edge};
    tensor.patch = {"", description.side_patches ? "rim" : "", "", "", "top", "bottom"};
    return build(tensor);
}

}  // namespace tiretherm::mesh
