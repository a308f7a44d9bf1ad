// SPDX-License-Identifier: BSD-3-Clause
// Finite-volume mesh as a graph of nodes and faces, with patches, regions and lumped nodes. It knows no physics and no
// unit but the metre.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/grid.hpp"

namespace tiretherm::mesh {

/// A measured place: sum of weight * temperature over a few nodes. The weights sum to 1 for an average or an interpolation.
struct Functional {
    std::vector<int> nodes;
    std::vector<double> weights;

    void add(int node, double weight);
    /// Scales the weights so that they sum to 1.
    void normalise();
    [[nodiscard]] double operator()(std::span<const double> temperature) const;
};

/// Joins two nodes. Its conductance per area is the series of two half distances, each with the material of its side,
/// and, where `link` >= 0, of the resistance of that link.
struct Face {
    int a = 0;
    int b = 0;
    double area = 0.0;    ///< m2, > 0
    double half_a = 0.0;  ///< m, >= 0: from node a to the face; 0 for a lump
    double half_b = 0.0;  ///< m, >= 0
    int link = -1;        ///< index into Mesh::links, or -1
    Axis axis = Axis::through;
    bool is_coupling = false;  ///< leads to a lumped node: nothing is conducted but what an effect adds
};

/// An extra resistance between two blocks: `length` / k, with k evaluated at the mean temperature of `region`.
struct Link {
    std::string name;
    double length = 0.0;  ///< m
    int region = 0;       ///< index into Mesh::regions
};

/// A piece of the boundary: heat enters or leaves at `node`, a surface node or, for a lump, the cell itself.
struct PatchFace {
    int node = 0;
    int cell = 0;
    double area = 0.0;               ///< m2
    Point centre{};                  ///< m
    std::array<double, 4> extent{};  ///< x0, x1, y0, y1 [m] of a face of the outer or inner side; else zeros
};

/// A named part of the boundary.
struct Patch {
    std::string name;
    std::vector<PatchFace> faces;

    [[nodiscard]] double area() const;
};

/// A named mean temperature that laws may depend on ("surface", "bulk").
struct Region {
    std::string name;
    Functional mean;
};

/// A stack of cells through the thickness at one place of the meridian.
struct Column {
    double from = 0.0;         ///< m along the meridian, negative outboard
    double to = 0.0;           ///< m
    double radius = 0.0;       ///< m, mean distance from the tire's axis
    int zone = 0;              ///< index into Mesh::zones
    int first_cell = 0;        ///< the cells of a column are numbered from the outside in
    std::vector<double> edge;  ///< [cells + 1] m below the column's outer surface
    int outer = 0;             ///< surface node
    int inner = 0;             ///< surface node

    [[nodiscard]] int cells() const { return static_cast<int>(edge.size()) - 1; }
    [[nodiscard]] double middle() const { return 0.5 * (from + to); }
};

/// A node of its own beside the cells, such as the gas in the cavity or the rim.
struct LumpedNode {
    std::string name;
    int node = 0;
};

/// How a cell is drawn.
enum class CellShape : std::uint8_t { vertex = 1, line = 2, quadrilateral = 4, hexahedron = 8 };

/// Corner points of every cell, in VTK's order, `corners_per_cell(shape)` each.
struct Drawing {
    CellShape shape = CellShape::vertex;
    std::vector<Point> points;    ///< m
    std::vector<int> corners;     ///< [n_cells * corners_per_cell]
    std::vector<Point> places{};  ///< of the points of a folded drawing in the mesh's own coordinates; else empty
};

[[nodiscard]] constexpr int corners_per_cell(CellShape shape) { return static_cast<int>(shape); }

/// Nodes are numbered: cells first, then surface nodes (no volume), then lumped nodes such as gas and rim.
struct Mesh {
    std::string kind;  ///< for readers of results alone: "two_node", "layers", "cylinder", "section", "ring", "patch"
    int n_cells = 0;
    int n_nodes = 0;
    std::vector<double> volume;  ///< [n_nodes] m3; 0 for a surface node
    std::vector<Point> centre;   ///< [n_nodes] m; z is the depth below the outer surface
    std::vector<int> layer;      ///< [n_nodes] index into layers; a surface node has its cell's, a lumped one -1
    std::vector<std::string> layers;
    std::vector<int> zone;  ///< [n_nodes] index into zones, -1 where there is none
    std::vector<std::string> zones;
    std::vector<Face> faces;
    std::vector<Link> links;
    std::vector<Patch> patches;
    std::vector<Region> regions;
    std::vector<LumpedNode> lumped_nodes;
    std::optional<Grid> grid;     ///< present when the cells are a tensor product
    std::vector<Column> columns;  ///< of a section, from outboard to inboard; of a ring its first sector's
    bool stack = false;           ///< the cells lie in one stack: a place in it is a depth
    int sectors = 1;              ///< of a ring: its cells are that many equal sectors one after the other, its surface
                                  ///< nodes likewise
    Drawing drawing;

    int add_cell(double cell_volume, const Point& place, int cell_layer, int cell_zone = -1);
    /// Adds `area` of boundary to a patch. With half_distance > 0 a surface node is created between cell and outside.
    int add_patch_face(int patch, int cell, double area, double half_distance, const Point& place, Axis axis);
    int add_patch(std::string_view name);
    /// A node beside the cells, with a region of the same name; the one that is there when the name is taken.
    int add_lumped_node(std::string_view name);
    /// A face by which an effect couples a node to a lumped one. @returns its index
    int add_coupling_face(int node, int lumped_node, double area);

    /// Whether the cells are lumps: there is no place within them, and they have no surface of their own.
    [[nodiscard]] bool is_lumped() const { return !grid && columns.empty(); }
    /// Whether the cells are those of a tire's section, of one sector or of the sectors of a ring.
    [[nodiscard]] bool is_section() const { return !columns.empty(); }
    [[nodiscard]] bool is_ring() const { return sectors > 1; }
    [[nodiscard]] bool is_axisymmetric() const { return grid && grid->metric == Metric::axisymmetric; }

    [[nodiscard]] int find_patch(std::string_view name) const;        ///< -1 when absent
    [[nodiscard]] int find_region(std::string_view name) const;       ///< -1 when absent
    [[nodiscard]] int find_lumped_node(std::string_view name) const;  ///< node, -1 when absent
    [[nodiscard]] int find_zone(std::string_view name) const;         ///< -1 when absent
    [[nodiscard]] int find_layer(std::string_view name) const;        ///< -1 when absent
    [[nodiscard]] double total_volume() const;                        ///< m3, cells only
};

/// What is wrong with a mesh, a sentence each (negative volume, face to itself, unconnected cell); empty when sound.
[[nodiscard]] std::vector<std::string> defects(const Mesh& mesh);

}  // namespace tiretherm::mesh
