// SPDX-License-Identifier: BSD-3-Clause
// Extracts the plane from a mesh, adds interface temperatures from equal heat flux on both sides, and crops a uniform
// rim.

#include "post/pictures/section_plane.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/probe.hpp"

namespace tiretherm::post {

namespace {

/// A position between two columns (or rows): the lower one's index and the upper one's share.
struct Between {
    std::size_t index = 0;
    double share = 0.0;
};

Between between(const std::vector<double>& positions, double at, Shading shading) {
    const auto above = std::upper_bound(positions.begin(), positions.end(), at) - positions.begin();
    const auto index = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(positions) - 2));
    if (shading == Shading::cells) {
        return {index, 0.0};
    }
    return {index, std::clamp((at - positions[index]) / (positions[index + 1] - positions[index]), 0.0, 1.0)};
}

/// Both ends and all centres of the cells along an axis.
std::vector<double> node_positions(const mesh::Grid& grid, std::size_t axis) {
    std::vector<double> positions{grid.edge[axis].front()};
    positions.insert(positions.end(), grid.centre[axis].begin(), grid.centre[axis].end());
    positions.push_back(grid.edge[axis].back());
    return positions;
}

/// The middle of the specimen along y: the plane of symmetry, the axis, or y = 0.
double middle(const mesh::Grid& grid) {
    const std::vector<double>& edge = grid.edge[1];
    return grid.mirror[1] ? edge.front() : 0.5 * (edge.front() + edge.back());
}

/// Adds a row where two materials meet. The flux through both halves is the same there, which gives the interface a
/// temperature; a straight line between the cells would move the bend of the isotherms into one of the layers.
void add_interfaces(SectionPlane& plane, const solver::Problem& problem) {
    const mesh::Grid& grid = *problem.mesh.grid;
    const std::size_t width = plane.x.size();
    const auto material = [&](int k) -> const physics::Material& {
        return problem
            .materials[static_cast<std::size_t>(problem.mesh.layer[static_cast<std::size_t>(grid.cell(0, 0, k))])];
    };
    // From below, so that the rows above keep their numbers: row k + 1 holds the cells k.
    for (int k = grid.size(2) - 2; k >= 0 && problem.mesh.links.empty(); --k) {
        if (material(k) == material(k + 1)) {
            continue;
        }
        const auto row = static_cast<std::size_t>(k + 1);
        const double depth = grid.edge[2][row];
        std::vector<double> between;
        for (std::size_t i = 0; i < width; ++i) {
            const double above = plane.kelvin[row * width + i];
            const double below = plane.kelvin[(row + 1) * width + i];
            const double G_above = material(k).along(mesh::Axis::through).value(above) / (depth - plane.depth[row]);
            const double G_below =
                material(k + 1).along(mesh::Axis::through).value(below) / (plane.depth[row + 1] - depth);
            between.push_back((G_above * above + G_below * below) / (G_above + G_below));
        }
        const auto at = static_cast<std::ptrdiff_t>(row + 1);
        plane.depth.insert(plane.depth.begin() + at, depth);
        plane.kelvin.insert(plane.kelvin.begin() + at * std::ssize(plane.x), between.begin(), between.end());
    }
}

}  // namespace

bool has_section(const mesh::Mesh& mesh) { return mesh.grid && mesh.grid->size(0) > 1; }

SectionPlane section_plane(const solver::Problem& problem, std::span<const double> temperature, Shading shading) {
    const mesh::Mesh& mesh = problem.mesh;
    const mesh::Grid& grid = *mesh.grid;
    SectionPlane plane{.shading = shading, .x = {}, .depth = {}, .kelvin = {}, .mirrored = grid.mirror[0]};
    const double y = middle(grid);
    if (shading == Shading::smooth) {
        plane.x = node_positions(grid, 0);
        plane.depth = node_positions(grid, 2);
        for (const double depth : plane.depth) {
            for (const double x : plane.x) {
                plane.kelvin.push_back(mesh::at_point(mesh, {x, y, depth})(temperature));
            }
        }
        add_interfaces(plane, problem);
        return plane;
    }
    plane.x = grid.edge[0];
    plane.depth = grid.edge[2];
    const int j = static_cast<int>(between(grid.edge[1], y, Shading::cells).index);
    for (int k = 0; k < grid.size(2); ++k) {
        for (int i = 0; i < grid.size(0); ++i) {
            plane.kelvin.push_back(temperature[static_cast<std::size_t>(grid.cell(i, j, k))]);
        }
    }
    return plane;
}

void crop_uniform_rim(SectionPlane& plane) {
    if (!plane.mirrored || plane.shading == Shading::cells) {
        return;
    }
    const auto [low, high] = std::minmax_element(plane.kelvin.begin(), plane.kelvin.end());
    const double slight = 0.05 * (*high - *low);
    const std::size_t width = plane.x.size();
    const double deep = plane.depth.back() - plane.depth.front();
    const auto wide = std::lower_bound(plane.x.begin(), plane.x.end(), deep) - plane.x.begin();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < plane.kelvin.size(); ++i) {
        const double at_end = plane.kelvin[i / width * width + width - 1];
        if (std::abs(plane.kelvin[i] - at_end) >= slight) {
            kept = std::max(kept, i % width + 2);
        }
    }
    if (kept == 0) {
        return;  // nothing changes along x, so no part is quieter than another
    }
    kept = std::max(kept, static_cast<std::size_t>(wide) + 1);
    if (kept >= width || plane.x[kept - 1] > 2.0 / 3.0 * plane.x.back()) {
        return;
    }
    std::vector<double> kelvin;
    for (std::size_t row = 0; row < plane.depth.size(); ++row) {
        const auto begin = plane.kelvin.begin() + static_cast<std::ptrdiff_t>(row * width);
        kelvin.insert(kelvin.end(), begin, begin + static_cast<std::ptrdiff_t>(kept));
    }
    plane.x.resize(kept);
    plane.kelvin = std::move(kelvin);
}

std::vector<double> SectionPlane::sample(std::span<const double> at_x, std::span<const double> at_depth) const {
    std::vector<Between> columns;
    for (const double position : at_x) {
        columns.push_back(between(x, mirrored ? std::abs(position) : position, shading));
    }
    const std::size_t row = shading == Shading::cells ? x.size() - 1 : x.size();
    const std::size_t next_row = shading == Shading::cells ? 0 : row;
    const std::size_t next = shading == Shading::cells ? 0 : 1;
    std::vector<double> result;
    result.reserve(at_x.size() * at_depth.size());
    for (const double position : at_depth) {
        const Between k = between(depth, position, shading);
        for (const Between& i : columns) {
            const double* corner = &kelvin[k.index * row + i.index];
            const double upper = (1.0 - i.share) * corner[0] + i.share * corner[next];
            const double lower = (1.0 - i.share) * corner[next_row] + i.share * corner[next_row + next];
            result.push_back((1.0 - k.share) * upper + k.share * lower);
        }
    }
    return result;
}

}  // namespace tiretherm::post
