// SPDX-License-Identifier: BSD-3-Clause
// Picture of one camera frame: measured, simulated and difference side by side.
#pragma once

#include <filesystem>
#include <string>

#include "diagnosis/compare/camera_comparison.hpp"

namespace tiretherm::post {

/// Measured, simulated and their difference side by side, at one frame, as a PNG. Pixels that are left out stay grey.
/// @errors FileError
void draw_images(const std::filesystem::path& path, const diagnosis::ComparedImages& images, std::size_t frame,
                 const std::string& title);

}  // namespace tiretherm::post
