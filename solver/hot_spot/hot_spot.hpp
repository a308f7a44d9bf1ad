// SPDX-License-Identifier: BSD-3-Clause
// Hottest place of a part of the tire, also between cell centres, its history over a run, and the time when it passes a
// critical temperature.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "solver/problem.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::solver {

/// A temperature that some part of the tire should not pass.
struct Critical {
    std::string name{};          ///< "belt edge"
    std::string part{};          ///< in words: "belt in outside_shoulder and inside_shoulder"; empty: the whole tire
    double temperature = 0.0;    ///< K
    std::vector<int> nodes{};    ///< of the part, ascending
    std::string surface_name{};  ///< of the channel that is compared with it; empty: there is none
    int channel = -1;            ///< index of this channel; -1: the mean temperature below
    mesh::Functional surface{};
};

/// The hottest place of a part, between its cells as well: a parabola through three nodes in depth and another along the
/// meridian about the hottest node, each on one side of a jump of material or thickness where there is one; along the meridian never
/// beyond the last node before it. Second order
/// in the cell size where the hottest node alone lies below the peak by as much as half a cell's bend. Along the meridian
/// only on a section; of lumps and of directions with too few cells the node itself.
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
        std::vector<double> depth{};  ///< [nodes] m
        std::vector<double> edge{};   ///< [nodes - 2 + 1] m, of the cells between the surfaces that it has
        std::size_t first_cell = 0;   ///< index of the first cell among the nodes
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
    void add_line(Line line);
    [[nodiscard]] int hottest_node(std::span<const double> T) const;
    [[nodiscard]] Interpolant in_depth(const LinePosition& position, std::span<const double> T) const;
    [[nodiscard]] Interpolant along(std::size_t line, const Interpolant& depth, std::span<const double> T) const;
    [[nodiscard]] double at_depth(std::size_t line, const Interpolant& depth, std::span<const double> T) const;

    const mesh::Mesh* mesh_;
    std::vector<int> nodes_;
    std::vector<Line> lines_;                   ///< of a section: its columns, in their order
    std::vector<LinePosition> line_positions_;  ///< [n_nodes]
    std::vector<bool> goes_on_;                 ///< [lines] whether the next one continues this one
};

/// The hot spot at every row of a run.
class HotSpotHistory {
public:
    HotSpotHistory(const mesh::Mesh& mesh, Critical critical);

    void take(const Snapshot& snapshot);
    /// Everything that was taken, as numbers.
    void visit(Archive& archive);

    [[nodiscard]] const Critical& critical() const { return critical_; }
    [[nodiscard]] std::size_t rows() const { return time_.size(); }
    [[nodiscard]] const std::vector<double>& time() const { return time_; }                ///< [rows] s
    [[nodiscard]] const std::vector<double>& temperature() const { return temperature_; }  ///< [rows] K
    [[nodiscard]] const std::vector<double>& surface() const {
        return surface_;
    }  ///< [rows] K; NaN where there is none
    [[nodiscard]] const HotSpotFinder::Found& found(std::size_t row) const { return found_[row]; }
    /// Row in which the highest temperature is reached, to 5 mK: a plateau goes on creeping. @pre rows() > 0
    [[nodiscard]] std::size_t hottest_row() const { return hottest_row_; }
    /// Weights of the hottest place of this row, see HotSpotFinder::functional.
    [[nodiscard]] const mesh::Functional& hottest_place() const { return hottest_place_; }

private:
    Critical critical_;
    HotSpotFinder finder_;
    std::vector<double> time_;
    std::vector<double> temperature_;
    std::vector<double> surface_;
    std::vector<HotSpotFinder::Found> found_;
    mesh::Functional hottest_place_;
    std::size_t hottest_row_ = 0;
};

/// When a history first passes a level from below, straight between its rows; the first time where it begins above.
/// @returns s; NaN where it never does
[[nodiscard]] double passing_time(std::span<const double> time, std::span<const double> value, double level);

/// A history at a time, straight between its rows and held beyond them.
[[nodiscard]] double value_at(std::span<const double> time, std::span<const double> value, double t);

}  // namespace tiretherm::solver
