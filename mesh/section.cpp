// SPDX-License-Identifier: BSD-3-Clause
// Builds the cross-section column by column: cells are rings of the column's mean radius; neighbouring columns share a
// face wherever the depths of two cells overlap.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "mesh/builders.hpp"
#include "mesh/index.hpp"
#include "mesh/tensor.hpp"

namespace tiretherm::mesh {

namespace {

constexpr double pi = std::numbers::pi;
/// Depths closer than this are the same. m
constexpr double same_depth = 1e-9;

/// A zone's stack of layers, and how far its outer surface lies below that of the thickest zone.
struct Stack {
    StackEdges edges;
    double offset = 0.0;  ///< m
};

std::vector<Stack> stacks_of(const Section& d) {
    std::vector<Stack> stacks;
    double thickest = 0.0;
    for (const Zone& zone : d.zones) {
        std::vector<Layer> layers;
        for (const int layer : zone.stack) {
            layers.push_back(d.layers[at(layer)]);
        }
        stacks.push_back({.edges = stack_edges(layers)});
        thickest = std::max(thickest, stacks.back().edges.edge.back());
    }
    for (Stack& stack : stacks) {
        stack.offset = thickest - stack.edges.edge.back();
    }
    return stacks;
}

class SectionBuilder {
public:
    explicit SectionBuilder(const Section& description) : d_(description), stacks_(stacks_of(description)) {}

    Mesh build() {
        mesh_.kind = "section";
        for (const Layer& layer : d_.layers) {
            mesh_.layers.push_back(layer.name);
        }
        for (const Zone& zone : d_.zones) {
            mesh_.zones.push_back(zone.name);
        }
        add_columns();
        for (std::size_t i = 0; i + 1 < mesh_.columns.size(); ++i) {
            join(mesh_.columns[i], mesh_.columns[i + 1]);
        }
        add_surfaces();
        add_beads();
        add_regions();
        draw();
        return std::move(mesh_);
    }

private:
    [[nodiscard]] const Stack& stack(const Column& column) const { return stacks_[at(column.zone)]; }
    /// Depth below the outer surface of the thickest zone, where neighbours compare.
    [[nodiscard]] double depth(const Column& column, int k) const { return stack(column).offset + column.edge[at(k)]; }

    void add_columns() {
        double length = 0.0;
        for (const Zone& zone : d_.zones) {
            length += zone.length;
        }
        double begin = -0.5 * length;
        for (std::size_t z = 0; z < d_.zones.size(); ++z) {
            const Zone& zone = d_.zones[z];
            const std::vector<double> edge =
                edges(begin, {{.to = begin + zone.length, .cells = zone.cells, .ratio = zone.ratio}});
            for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
                add_column(edge[i], edge[i + 1], static_cast<int>(z));
            }
            begin += zone.length;
        }
    }

    void add_column(double from, double to, int zone) {
        const Stack& stack = stacks_[at(zone)];
        Column column{.from = from,
                      .to = to,
                      .radius = d_.meridian.mean_radius(from, to),
                      .zone = zone,
                      .first_cell = mesh_.n_cells,
                      .edge = stack.edges.edge};
        const double base = 2.0 * pi * column.radius * (to - from);
        for (int k = 0; k < column.cells(); ++k) {
            const double thickness = column.edge[at(k + 1)] - column.edge[at(k)];
            const int layer = d_.zones[at(zone)].stack[at(stack.edges.layer_of_cell[at(k)])];
            mesh_.add_cell(base * thickness,
                           {column.middle(), 0.0, 0.5 * (column.edge[at(k)] + column.edge[at(k + 1)])}, layer, zone);
        }
        for (int k = 0; k + 1 < column.cells(); ++k) {
            mesh_.faces.push_back({.a = column.first_cell + k,
                                   .b = column.first_cell + k + 1,
                                   .area = base,
                                   .half_a = 0.5 * (column.edge[at(k + 1)] - column.edge[at(k)]),
                                   .half_b = 0.5 * (column.edge[at(k + 2)] - column.edge[at(k + 1)]),
                                   .axis = Axis::through});
        }
        mesh_.columns.push_back(std::move(column));
    }

    /// Faces between two neighbouring columns, one for every pair of cells whose depths overlap.
    void join(const Column& left, const Column& right) {
        const double around = 2.0 * pi * d_.meridian.at(left.to).radius;
        int k = 0;
        int m = 0;
        while (k < left.cells() && m < right.cells()) {
            const double low = std::max(depth(left, k), depth(right, m));
            const double high = std::min(depth(left, k + 1), depth(right, m + 1));
            if (high - low > same_depth) {
                mesh_.faces.push_back({.a = left.first_cell + k,
                                       .b = right.first_cell + m,
                                       .area = around * (high - low),
                                       .half_a = 0.5 * (left.to - left.from),
                                       .half_b = 0.5 * (right.to - right.from),
                                       .axis = Axis::meridian});
            }
            const bool left_ends = depth(left, k + 1) <= high + same_depth;
            const bool right_ends = depth(right, m + 1) <= high + same_depth;
            k += left_ends ? 1 : 0;
            m += right_ends ? 1 : 0;
        }
    }

    void add_surfaces() {
        const int outside = mesh_.add_patch("outside");
        const bool walls = std::any_of(d_.zones.begin(), d_.zones.end(), [](const Zone& zone) { return !zone.tread; });
        const int sidewalls = walls ? mesh_.add_patch("sidewalls") : -1;
        const int inside = mesh_.add_patch("inside");
        for (Column& column : mesh_.columns) {
            const double base = 2.0 * pi * column.radius * (column.to - column.from);
            const int n = column.cells();
            const bool tread = d_.zones[at(column.zone)].tread;
            const std::array<double, 4> extent{column.from, column.to, 0.0, 0.0};
            column.outer = mesh_.add_patch_face(tread ? outside : sidewalls, column.first_cell, base,
                                                0.5 * column.edge[1], {column.middle(), 0.0, 0.0}, Axis::through);
            mesh_.patches[at(tread ? outside : sidewalls)].faces.back().extent = extent;
            column.inner = mesh_.add_patch_face(inside, column.first_cell + n - 1, base,
                                                0.5 * (column.edge[at(n)] - column.edge[at(n - 1)]),
                                                {column.middle(), 0.0, column.edge[at(n)]}, Axis::through);
            mesh_.patches[at(inside)].faces.back().extent = extent;
        }
    }

    void add_beads() {
        const int beads = mesh_.add_patch("beads");
        for (const bool inboard : {false, true}) {
            const Column& column = inboard ? mesh_.columns.back() : mesh_.columns.front();
            const double s = inboard ? column.to : column.from;
            for (int k = 0; k < column.cells(); ++k) {
                const double area = 2.0 * pi * d_.meridian.at(s).radius * (column.edge[at(k + 1)] - column.edge[at(k)]);
                mesh_.add_patch_face(beads, column.first_cell + k, area, 0.5 * (column.to - column.from),
                                     {s, 0.0, mesh_.centre[at(column.first_cell + k)][2]}, Axis::meridian);
            }
        }
    }

    void add_regions() {
        Functional surface;
        for (const PatchFace& face : mesh_.patches[at(mesh_.find_patch("outside"))].faces) {
            surface.nodes.push_back(face.node);
            surface.weights.push_back(face.area);
        }
        Functional bulk;
        for (const Column& column : mesh_.columns) {
            const Zone& zone = d_.zones[at(column.zone)];
            for (int cell = column.first_cell; zone.tread && cell < column.first_cell + column.cells(); ++cell) {
                if (zone.stack.size() == 1 || mesh_.layer[at(cell)] != zone.stack.front()) {
                    bulk.nodes.push_back(cell);
                    bulk.weights.push_back(mesh_.volume[at(cell)]);
                }
            }
        }
        surface.normalise();
        bulk.normalise();
        mesh_.regions = {{.name = "surface", .mean = std::move(surface)}, {.name = "bulk", .mean = std::move(bulk)}};
    }

    /// The folded cross-section in the plane of the tire's axis (x) and its radius (z).
    void draw() {
        mesh_.drawing.shape = CellShape::quadrilateral;
        std::map<std::pair<long, long>, int> known;
        const auto point = [&](const Column& column, double s, double below) {
            const auto [found, fresh] = known.try_emplace(
                {std::lround(s / same_depth), std::lround(below / same_depth)}, std::ssize(mesh_.drawing.points));
            if (fresh) {
                const Meridian::ProfilePoint place = d_.meridian.inside(s, below);
                mesh_.drawing.points.push_back({place.lateral, 0.0, place.radius});
                // Just inside the column that draws it, whose depth it is.
                const double inward = s < column.middle() ? same_depth : -same_depth;
                mesh_.drawing.places.push_back({s + inward, 0.0, below - stack(column).offset});
            }
            return found->second;
        };
        for (const Column& column : mesh_.columns) {
            for (int k = 0; k < column.cells(); ++k) {
                for (const auto& [s, edge] : {std::pair(column.from, k + 1), std::pair(column.to, k + 1),
                                              std::pair(column.to, k), std::pair(column.from, k)}) {
                    mesh_.drawing.corners.push_back(point(column, s, depth(column, edge)));
                }
            }
        }
    }

    const Section& d_;
    std::vector<Stack> stacks_;
    Mesh mesh_;
};

}  // namespace

Mesh build(const Section& description) { return SectionBuilder(description).build(); }

}  // namespace tiretherm::mesh
