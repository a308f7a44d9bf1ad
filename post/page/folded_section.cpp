// SPDX-License-Identifier: BSD-3-Clause
// Blends the corners of a cell and adds the arc's rise over its chord.

#include "post/page/folded_section.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::post {

namespace {

using Place = FoldedSection::Place;

Place minus(const Place& a, const Place& b) { return {a[0] - b[0], a[1] - b[1]}; }
double length(const Place& a) { return std::hypot(a[0], a[1]); }
Place between(const Place& a, const Place& b, double share) {
    return {a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
}

/// Nodes of the columns: all but lumped ones.
std::vector<int> nodes_of_columns(const mesh::Mesh& mesh) {
    std::vector<int> nodes;
    for (const mesh::Column& column : mesh.columns) {
        nodes.insert(nodes.end(), {column.outer, column.inner});
        for (int k = 0; k < column.cells(); ++k) {
            nodes.push_back(column.first_cell + k);
        }
    }
    std::ranges::sort(nodes);
    return nodes;
}

}  // namespace

FoldedSection::FoldedSection(const mesh::Mesh& mesh) : mesh_(&mesh), finder_(mesh, nodes_of_columns(mesh)) {
    for (std::size_t i = 0; i < mesh.columns.size(); ++i) {
        const mesh::Column& column = mesh.columns[i];
        for (int k = 0; k + 1 < column.cells(); ++k) {
            const int cell = column.first_cell + k;
            if (mesh.layer[static_cast<std::size_t>(cell)] != mesh.layer[static_cast<std::size_t>(cell) + 1]) {
                Border border;
                for (int piece = 0; piece <= pieces; ++piece) {
                    border.line.push_back(in_cell(cell, static_cast<double>(piece) / pieces, 0.0));
                }
                borders_.push_back(std::move(border));
            }
        }
        if (i + 1 < mesh.columns.size() && mesh.columns[i + 1].zone != column.zone) {
            borders_.push_back({.line = {in_cell(column.first_cell, 1.0, 1.0),
                                         in_cell(column.first_cell + column.cells() - 1, 1.0, 0.0)},
                                .of_zones = true});
        }
    }
}

std::size_t FoldedSection::corner(int cell, std::size_t i) const {
    return static_cast<std::size_t>(mesh_->drawing.corners[4 * static_cast<std::size_t>(cell) + i]);
}

std::optional<Place> FoldedSection::below_zone(std::size_t zone) const {
    std::vector<const mesh::Column*> own;
    for (const mesh::Column& column : mesh_->columns) {
        if (column.zone == static_cast<int>(zone)) {
            own.push_back(&column);
        }
    }
    return own.empty()
               ? std::nullopt
               : std::optional(in_cell(own[own.size() / 2]->first_cell + own[own.size() / 2]->cells() - 1, 0.0, 0.0));
}

Place FoldedSection::in_cell(int cell, double u, double v) const {
    std::array<Place, 4> at{};
    for (std::size_t i = 0; i < 4; ++i) {
        const mesh::Point& p = mesh_->drawing.points[corner(cell, i)];
        at[i] = {p[0], p[2]};
    }
    const Place begin = between(at[0], at[3], v);
    const Place end = between(at[1], at[2], v);
    Place place = between(begin, end, u);
    const Place outboard = minus(at[3], at[0]);
    const Place inboard = minus(at[2], at[1]);
    // Both sides point outwards, so that they turn from one to the other as the arc does.
    const double sides = length(outboard) * length(inboard);
    const double turn = std::asin(std::clamp((inboard[0] * outboard[1] - inboard[1] * outboard[0]) / sides, -1.0, 1.0));
    const double rise = 0.5 * length(minus(end, begin)) * std::tan(0.25 * turn) * 4.0 * u * (1.0 - u);
    const Place outwards{outboard[0] / length(outboard) + inboard[0] / length(inboard),
                         outboard[1] / length(outboard) + inboard[1] / length(inboard)};
    place[0] += rise * outwards[0] / length(outwards);
    place[1] += rise * outwards[1] / length(outwards);
    return place;
}

std::optional<Place> FoldedSection::place(double along, double depth) const {
    for (const mesh::Column& column : mesh_->columns) {
        if (along < column.from || along > column.to) {
            continue;
        }
        int k = 0;
        while (k + 1 < column.cells() && depth > column.edge[static_cast<std::size_t>(k) + 1]) {
            ++k;
        }
        const double top = column.edge[static_cast<std::size_t>(k)];
        const double bottom = column.edge[static_cast<std::size_t>(k) + 1];
        return in_cell(column.first_cell + k, (along - column.from) / (column.to - column.from),
                       std::clamp((bottom - depth) / (bottom - top), 0.0, 1.0));
    }
    return std::nullopt;
}

}  // namespace tiretherm::post
