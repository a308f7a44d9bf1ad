// SPDX-License-Identifier: BSD-3-Clause
// The frames of a camera as a chart with a slider: measured, simulated, and their difference.
#pragma once

#include <string>

#include "diagnosis/compare/camera_comparison.hpp"
#include "post/report/value.hpp"

namespace tiretherm::post {

/// Three panels, in mm about the image's centre; shown first is the worst frame. @pre images has a frame and a pixel
[[nodiscard]] Value camera_chart(const diagnosis::ComparedImages& images);
/// How it is read.
[[nodiscard]] std::string camera_caption(const diagnosis::ComparedImages& images);

}  // namespace tiretherm::post
