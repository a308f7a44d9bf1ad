// SPDX-License-Identifier: BSD-3-Clause
// Hottest place of a part of the tire, also between cell centres.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::solver {

/// The hottest place of a part, between its cells as well: a parabola through three nodes in depth and another along the
/// meridian about the hottest node, each on one side of a jump of material or thickness where there is one; along the
/// meridian never beyond the last node before it. Towards a neighbour it bends at most twice as much as the field does behind
/// that: a jump on one side makes no peak on the other. Second order in the cell size where the hottest node alone lies below the
/// peak by as much as half a cell's bend. Along the meridian on a section and a ring, around the
/// tire nowhere; of lumps and of directions with too few
/// cells the node itself. This is what "hottest" means wherever a result names it.
class HotSpotFinder {
public:
    HotSpotFinder(const mesh::Mesh& mesh, std::vector<int> nodes);

    struct Found {
        double temperature = 0.0;  ///< K
        int node = -1;             ///< the hottest, in whose cell the place lies
        mesh::Point point{};       ///< m, of the place itself
    };
    /// Allocates nothing. @param temperature [n_nodes] K
    [[nodiscard]] Found find(std::span<const double> temperature) const;
    /// The same place as a weighted mean of nodes. A small change of the field moves the peak by as much as this mean,
    /// since at the peak it does not matter that its place moves too.
    [[nodiscard]] mesh::Functional functional(std::span<const double> temperature) const;

private:
    /// A row of nodes through the thickness, its surfaces included.
    struct Line {
        std::vector<int> node{};
        std::span<const double>
            edge{};                  ///< [nodes - 2 + 1] m, of the cells between the surfaces that it has; the mesh's
        std::size_t first_cell = 0;  ///< index of the first cell among the nodes

        /// Of a node, m: the middle of its cell.
        [[nodiscard]] double depth(std::size_t index) const {
            const std::size_t cell = index - first_cell;
            const bool is_cell = index >= first_cell && cell + 1 < edge.size();
            return is_cell ? 0.5 * (edge[cell] + edge[cell + 1]) : index < first_cell ? edge.front() : edge.back();
        }
    };
    /// Where a node lies in its row.
    struct LinePosition {
        int line = -1;
        std::size_t index = 0;
    };
    /// A place between up to three neighbours, by their weights.
    struct Interpolant {
        double at = 0.0;
        std::array<std::size_t, 3> index{};
        std::array<double, 3> weight{1.0, 0.0, 0.0};
        std::size_t count = 1;
    };
    /// Columns of all sectors, sector by sector: the first lines.
    [[nodiscard]] std::size_t columns() const {
        return mesh_->columns.size() * static_cast<std::size_t>(mesh_->sectors);
    }
    [[nodiscard]] const mesh::Column& column_of(std::size_t line) const {
        return mesh_->columns[line % mesh_->columns.size()];
    }
    void add_line(Line line);
    template <typename Joined, typename Place, typename Value>
    [[nodiscard]] static Interpolant at_peak(std::size_t first, std::size_t n, const Joined& joined, const Place& place,
                                             const Value& value, double low, double high);
    [[nodiscard]] int hottest_node(std::span<const double> T) const;
    [[nodiscard]] Interpolant in_depth(const LinePosition& position, std::span<const double> T) const;
    [[nodiscard]] Interpolant along(std::size_t line, const Interpolant& depth, std::span<const double> T) const;
    [[nodiscard]] double at_depth(std::size_t line, const Interpolant& depth, std::span<const double> T) const;

    const mesh::Mesh* mesh_;
    std::vector<int> nodes_;
    std::vector<Line> lines_;                   ///< of a section or a ring: its columns, sector by sector
    std::vector<LinePosition> line_positions_;  ///< [n_nodes]
    std::vector<bool> goes_on_;                 ///< [lines] whether the next one continues this one
};

/// Every node of a mesh, ascending.
[[nodiscard]] std::vector<int> all_nodes(const mesh::Mesh& mesh);
/// Those of layers: without gas, rim and other lumps beside the tire.
[[nodiscard]] std::vector<int> nodes_of_layers(const mesh::Mesh& mesh);

/// K; what a plateau still rises by says nothing about when its peak was reached.
inline constexpr double creeping_rise = 0.005;

}  // namespace tiretherm::solver
