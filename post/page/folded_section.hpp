// SPDX-License-Identifier: BSD-3-Clause
// A tire's cross-section as it is drawn: the shape of its cells, the lines between layers and zones, the hottest place.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "solver/hot_spot_finder.hpp"

namespace tiretherm::post {

/// A folded section in the plane of the tire's axis and its radius. The sides of a cell towards its neighbours along the
/// meridian are straight; the other two are arcs at right angles to them, so that a coarse sidewall is round.
class FoldedSection {
public:
    using Place = std::array<double, 2>;  ///< m, lateral from outboard to inboard, and radius

    /// @param mesh with columns and a folded drawing; lives longer
    explicit FoldedSection(const mesh::Mesh& mesh);

    /// @param u from outboard to inboard, 0 to 1  @param v from the inner to the outer side, 0 to 1
    [[nodiscard]] Place in_cell(int cell, double u, double v) const;
    /// @param along m along the meridian  @param depth m below the outer surface  @returns nothing beside the section
    [[nodiscard]] std::optional<Place> place(double along, double depth) const;
    /// The inner side of a zone's middle column, where its name is written. @returns nothing of a zone without columns
    [[nodiscard]] std::optional<Place> below_zone(std::size_t zone) const;
    /// Index of a corner of a cell among the points of the drawing: inner side from outboard to inboard, then the outer side
    /// back.
    [[nodiscard]] std::size_t corner(int cell, std::size_t i) const;

    struct Border {
        std::vector<Place> line;
        bool of_zones = false;  ///< or of layers
    };
    [[nodiscard]] const std::vector<Border>& borders() const { return borders_; }
    /// The hottest place of the tire itself, its gas and its rim aside. @param temperature [n_nodes] K
    [[nodiscard]] solver::HotSpotFinder::Found hottest(std::span<const double> temperature) const {
        return finder_.find(temperature);
    }

    /// An arc is drawn as so many straight pieces.
    static constexpr int pieces = 3;

private:
    const mesh::Mesh* mesh_;
    solver::HotSpotFinder finder_;
    std::vector<Border> borders_;
};

}  // namespace tiretherm::post
