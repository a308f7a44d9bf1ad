// SPDX-License-Identifier: BSD-3-Clause
// Interpolates linearly in depth within a column and along the meridian between columns of equal thickness; where the
// thickness jumps, nothing is interpolated.

#include "mesh/column_probe.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/index.hpp"
#include "mesh/ring.hpp"

namespace tiretherm::mesh {

namespace {

double thickness(const Column& column) { return column.edge.back(); }

/// Columns of one thickness continue each other; across a step nothing is interpolated.
bool continues(const Column& a, const Column& b) { return std::abs(thickness(a) - thickness(b)) < 1e-9; }

/// Adds a column's temperature at a depth, straight between its surface nodes and the centres of its cells.
void add_depth(const Column& column, double depth, double weight, Functional& result) {
    int lower = column.outer;
    double from = 0.0;
    for (int k = 0; k <= column.cells(); ++k) {
        const bool last = k == column.cells();
        const int node = last ? column.inner : column.first_cell + k;
        const double to = last ? thickness(column) : 0.5 * (column.edge[at(k)] + column.edge[at(k + 1)]);
        if (depth <= to || last) {
            const double share = (depth - from) / (to - from);
            result.add(lower, weight * (1.0 - share));
            result.add(node, weight * share);
            return;
        }
        lower = node;
        from = to;
    }
}

/// In a section, or in the first sector of a ring.
Functional in_section(const Mesh& mesh, std::ptrdiff_t i, const Point& point) {
    const Column& here = mesh.columns[static_cast<std::size_t>(i)];
    // The neighbour beyond the point; where there is none, the one on the other side, and the line goes on.
    const std::ptrdiff_t towards = point[0] >= here.middle() ? 1 : -1;
    Functional result;
    for (const std::ptrdiff_t j : {i + towards, i - towards}) {
        if (j < 0 || j >= std::ssize(mesh.columns) || !continues(here, mesh.columns[static_cast<std::size_t>(j)])) {
            continue;
        }
        const Column& there = mesh.columns[static_cast<std::size_t>(j)];
        const double share = (point[0] - here.middle()) / (there.middle() - here.middle());
        add_depth(here, point[2], 1.0 - share, result);
        add_depth(there, point[2], share, result);
        return result;
    }
    add_depth(here, point[2], 1.0, result);
    return result;
}

}  // namespace

std::ptrdiff_t column_at(const Mesh& mesh, double s) {
    const auto found = std::find_if(mesh.columns.begin(), mesh.columns.end(),
                                    [&](const Column& column) { return s >= column.from && s <= column.to; });
    return found == mesh.columns.end() ? -1 : found - mesh.columns.begin();
}

bool in_columns(const Mesh& mesh, const Point& point) {
    const std::ptrdiff_t i = column_at(mesh, point[0]);
    return i >= 0 && point[2] >= 0.0 && point[2] <= thickness(mesh.columns[static_cast<std::size_t>(i)]) + 1e-12;
}

Functional at_column_point(const Mesh& mesh, const Point& point) {
    const std::ptrdiff_t i = column_at(mesh, point[0]);
    const Column& here = mesh.columns[static_cast<std::size_t>(i)];
    Functional result = in_section(mesh, i, point);
    return mesh.sectors == 1 ? result : at_angle(mesh, result, point[1] / here.radius);
}

Functional over_strip(const Mesh& mesh, double from, double to) {
    Functional mean;
    for (const Column& column : mesh.columns) {
        const double begin = std::max(from, column.from);
        const double end = std::min(to, column.to);
        if (end <= begin) {
            continue;
        }
        const Functional middle = at_column_point(mesh, {0.5 * (begin + end), 0.0, 0.0});
        for (std::size_t i = 0; i < middle.nodes.size(); ++i) {
            mean.add(middle.nodes[i], middle.weights[i] * (end - begin) * column.radius);
        }
    }
    mean.normalise();
    return mean;
}

}  // namespace tiretherm::mesh
