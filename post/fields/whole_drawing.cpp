// SPDX-License-Identifier: BSD-3-Clause
// Mirrors a drawing about each plane of symmetry that it shows; finds the border lines from the faces that cells share.

#include "post/fields/whole_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <span>

#include "mesh/index.hpp"

namespace tiretherm::post {

namespace {

using mesh::CellShape;
using mesh::Point;

/// Corners of a mirrored cell in the order that keeps its inside inside.
std::span<const int> mirrored_order(CellShape shape) {
    static constexpr std::array quadrilateral{1, 0, 3, 2};
    static constexpr std::array hexahedron{1, 0, 3, 2, 5, 4, 7, 6};
    static constexpr std::array same{0, 1};
    switch (shape) {
        case CellShape::quadrilateral:
            return quadrilateral;
        case CellShape::hexahedron:
            return hexahedron;
        case CellShape::line:
            return same;
        case CellShape::vertex:
            break;
    }
    return std::span(same).first(1);
}

/// Adds the mirror image about a plane; points on the plane are shared.
void mirror(WholeDrawing& drawing, std::size_t axis, double plane) {
    const std::size_t n_points = drawing.points.size();
    const std::size_t n_cells = drawing.cell.size();
    const std::span<const int> order = mirrored_order(drawing.shape);
    std::vector<int> image;
    for (std::size_t i = 0; i < n_points; ++i) {
        Point place = drawing.points[i];
        if (place[axis] == plane) {
            image.push_back(static_cast<int>(i));
            continue;
        }
        image.push_back(static_cast<int>(drawing.points.size()));
        place[axis] = 2.0 * plane - place[axis];
        drawing.points.push_back(place);
        drawing.point.push_back(drawing.point[i]);
    }
    for (std::size_t c = 0; c < n_cells; ++c) {
        for (const int corner : order) {
            drawing.corners.push_back(image[at(drawing.corners[c * order.size() + at(corner)])]);
        }
        drawing.cell.push_back(drawing.cell[c]);
    }
}

/// Faces of a cell as corners of it: its sides where it is flat.
std::span<const std::array<int, 4>> faces_of(CellShape shape) {
    static constexpr std::array<std::array<int, 4>, 4> flat{
        {{0, 1, -1, -1}, {1, 2, -1, -1}, {2, 3, -1, -1}, {3, 0, -1, -1}}};
    static constexpr std::array<std::array<int, 4>, 6> solid{
        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
    if (shape == CellShape::quadrilateral) {
        return flat;
    }
    return shape == CellShape::hexahedron ? std::span<const std::array<int, 4>>(solid)
                                          : std::span<const std::array<int, 4>>();
}

/// Of a face of four corners, from its diagonals; of length 1.
Point normal(const WholeDrawing& drawing, const std::array<int, 4>& face) {
    const auto difference = [&](int a, int b) {
        Point d{};
        for (std::size_t i = 0; i < 3; ++i) {
            d[i] = drawing.points[at(a)][i] - drawing.points[at(b)][i];
        }
        return d;
    };
    const Point u = difference(face[2], face[0]);
    const Point v = difference(face[3], face[1]);
    const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    return {n[0] / length, n[1] / length, n[2] / length};
}

/// A face on the outer surface of the cells, or a flat cell.
struct Face {
    int cell = 0;
    Point normal{};
};

using Edge = std::array<int, 2>;

Edge edge_of(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Each edge with the faces that meet in it.
std::map<Edge, std::vector<Face>> edges_of(const WholeDrawing& drawing) {
    const auto n = at(mesh::corners_per_cell(drawing.shape));
    std::map<Edge, std::vector<Face>> edges;
    if (drawing.shape == CellShape::quadrilateral) {
        for (std::size_t c = 0; c < drawing.cell.size(); ++c) {
            for (const auto& side : faces_of(drawing.shape)) {
                edges[edge_of(drawing.corners[c * n + at(side[0])], drawing.corners[c * n + at(side[1])])].push_back(
                    {.cell = drawing.cell[c]});
            }
        }
        return edges;
    }
    std::map<std::array<int, 4>, std::pair<int, std::array<int, 4>>> outer;  // by sorted corners: cell, corners
    for (std::size_t c = 0; c < drawing.cell.size(); ++c) {
        for (std::array<int, 4> face : faces_of(drawing.shape)) {
            std::ranges::transform(face, face.begin(), [&](int corner) { return drawing.corners[c * n + at(corner)]; });
            std::array<int, 4> key = face;
            std::ranges::sort(key);
            if (const auto [found, fresh] = outer.try_emplace(key, drawing.cell[c], face); !fresh) {
                outer.erase(found);
            }
        }
    }
    for (const auto& [key, face] : outer) {
        const Face one{.cell = face.first, .normal = normal(drawing, face.second)};
        for (std::size_t i = 0; i < 4; ++i) {
            edges[edge_of(face.second[i], face.second[(i + 1) % 4])].push_back(one);
        }
    }
    return edges;
}

}  // namespace

WholeDrawing whole_drawing(const mesh::Mesh& mesh) {
    const mesh::Drawing& drawn = mesh.drawing;
    WholeDrawing whole{
        .shape = drawn.shape, .points = drawn.points, .point = {}, .corners = drawn.corners, .cell = {}, .volume = {}};
    whole.point.resize(drawn.points.size());
    std::iota(whole.point.begin(), whole.point.end(), 0);
    whole.cell.resize(at(mesh.n_cells));
    std::iota(whole.cell.begin(), whole.cell.end(), 0);
    double copies = 1.0;   // of a cell in the drawing
    double of_mesh = 1.0;  // the whole over the mesh, as volumes
    if (mesh.grid) {
        const bool flat = drawn.shape == CellShape::quadrilateral;
        for (Point& place : whole.points) {
            // One cell across is drawn in the middle of the whole, which is the plane of symmetry; about an axis it is y = 0.
            place[1] = mesh.is_axisymmetric()         ? 0.0
                       : flat && mesh.grid->mirror[1] ? mesh.grid->edge[1].front()
                                                      : place[1];
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (!mesh.grid->mirror[axis]) {
                continue;
            }
            of_mesh *= mesh.is_axisymmetric() ? 1.0 : 2.0;
            if (drawn.shape == CellShape::hexahedron || (flat && axis == 0)) {
                mirror(whole, axis, mesh.grid->edge[axis].front());
                copies *= 2.0;
            }
        }
    }
    for (const int cell : whole.cell) {
        whole.volume.push_back(mesh.volume[at(cell)] * of_mesh / copies);
    }
    return whole;
}

std::vector<std::array<int, 2>> borders(const WholeDrawing& drawing, const mesh::Mesh& mesh) {
    constexpr double smooth = 0.866;  // cosine of 30 degrees
    std::vector<std::array<int, 2>> lines;
    for (const auto& [edge, faces] : edges_of(drawing)) {
        const Face& a = faces.front();
        const Face& b = faces.back();
        const double cosine = a.normal[0] * b.normal[0] + a.normal[1] * b.normal[1] + a.normal[2] * b.normal[2];
        const bool sharp = drawing.shape == CellShape::hexahedron && cosine < smooth;
        if (faces.size() == 1 || sharp || mesh.layer[at(a.cell)] != mesh.layer[at(b.cell)] ||
            (!mesh.zones.empty() && mesh.zone[at(a.cell)] != mesh.zone[at(b.cell)])) {
            lines.push_back(edge);
        }
    }
    return lines;
}

}  // namespace tiretherm::post
