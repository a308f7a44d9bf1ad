// SPDX-License-Identifier: BSD-3-Clause
// Conservative transfer of heat from points of a structural code to faces or cells: shares are never negative and sum
// to 1 for each point; a uniform field stays uniform.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace tiretherm::physics {

/// The points of one frame of a structural code. A coordinate that is not given is empty.
struct FieldPoints {
    std::vector<double> along{};    ///< m, x: along the travel
    std::vector<double> across{};   ///< m, y: arc length along the meridian from the centre plane, negative outboard
    std::vector<double> depth{};    ///< m, below the outer surface
    std::vector<int> cell{};        ///< of the mesh; instead of places
    std::vector<double> measure{};  ///< m2 or m3 that each point stands for; empty: derived from the points' places

    /// Of the frame; a coordinate that is given has as many.
    [[nodiscard]] std::size_t size() const { return cell.empty() ? across.size() : cell.size(); }

    friend bool operator==(const FieldPoints&, const FieldPoints&) = default;
};

/// Whether areas follow from the points' places.
struct Spacings {
    std::size_t rows = 0;  ///< different y
    bool alone = false;    ///< some y has one x only
};
[[nodiscard]] Spacings spacings(const FieldPoints& points);

/// Where the points of a frame lie on a mesh: which share of each point's heat goes to which node.
///
/// The values are joined by straight lines between neighbours and held half a spacing beyond the first and the last,
/// as far as the mesh reaches; what a node gets is the integral over its cell. So shares are never negative, those of
/// a point sum to 1, and a uniform field stays uniform.
struct FieldTransfer {
    struct Share {
        std::size_t point = 0;
        std::size_t node = 0;  ///< index into nodes
        double share = 0.0;
    };
    std::vector<int> nodes;
    std::vector<Share> shares;
    std::vector<double> measure;  ///< [points] m2 or m3

    /// @param density [points] W/m2 or W/m3 (or Pa, for a shape)  @returns [nodes] W (N)
    [[nodiscard]] std::vector<double> watts(std::span<const double> density) const;
    /// @returns W (N), before the transfer
    [[nodiscard]] double total(std::span<const double> density) const;
};

/// A point that lies beyond the mesh, and a sentence about it.
struct Stray {
    std::size_t point = 0;
    std::string what;
};
/// Points that the transfer cannot place. @param patches of a field of the contact; empty: of one of the cells
[[nodiscard]] std::vector<Stray> strays(const mesh::Mesh& mesh, std::span<const int> patches,
                                        const FieldPoints& points);

/// Onto the faces of patches. Without `along` a value is the mean around the tire, and the measure that of the face;
/// with it the points lie in the contact.
/// @pre no strays; with `along` and without `measure` at least two points at each y; `across` or `cell`
[[nodiscard]] FieldTransfer onto_faces(const mesh::Mesh& mesh, std::span<const int> patches, const FieldPoints& points);

/// Onto the cells. Without `depth` a value holds through the thickness.
/// @pre no strays
[[nodiscard]] FieldTransfer onto_cells(const mesh::Mesh& mesh, const FieldPoints& points);

}  // namespace tiretherm::physics
