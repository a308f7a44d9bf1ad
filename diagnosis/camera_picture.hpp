#pragma once

#include <filesystem>
#include <string>

#include "diagnosis/camera_comparison.hpp"

namespace tiretherm::diagnosis {

/// Measured, simulated and their difference side by side, at one frame, as a PNG. Pixels that are left out stay grey.
/// @errors post::FileError
void draw_images(const std::filesystem::path& path, const ComparedImages& images, std::size_t frame,
                 const std::string& title);

}  // namespace tiretherm::diagnosis
