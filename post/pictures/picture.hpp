// SPDX-License-Identifier: BSD-3-Clause
// The pictures of a run: field across the thickness, folded tire section, and unrolled tread.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "post/pictures/section_plane.hpp"
#include "solver/problem.hpp"

namespace tiretherm::post {

struct PictureOptions {
    Shading shading = Shading::smooth;
    double stretch = 1.0;  ///< depth is drawn this many times too long; the picture says so when it is not 1
};

/// The temperature across the thickness as a PNG: colours, isotherms, layers, axes in mm, a scale in degC. Both scales
/// are equal unless `stretch` says otherwise. A quarter of a block or a half plane about an axis is drawn whole.
/// @param time s  @param temperature [n_nodes] K   @pre has_section(problem.mesh)   @errors FileError
void draw_field(const std::filesystem::path& path, const solver::Problem& problem, double time,
                std::span<const double> temperature, const PictureOptions& options = {});

/// The temperature of a tire's folded cross-section as a PNG, with layers, zones and the hottest place.
/// @param time s  @param temperature [n_nodes] K   @pre the mesh has columns   @errors FileError
void draw_folded(const std::filesystem::path& path, const solver::Problem& problem, double time,
                 std::span<const double> temperature);

/// The temperature of a ring's tread as a PNG, unrolled: angle in the rubber's frame across, meridian down, each face in one
/// colour, and where the contact is, if one goes round.
/// @param time s  @param temperature [n_nodes] K   @pre mesh.sectors > 1   @errors FileError
void draw_tread(const std::filesystem::path& path, const solver::Problem& problem, double time,
                std::span<const double> temperature);

}  // namespace tiretherm::post
