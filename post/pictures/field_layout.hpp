// SPDX-License-Identifier: BSD-3-Clause
// Layout of a picture of the temperature across the thickness, and the field as a raster of pixels.
#pragma once

#include "post/pictures/axes.hpp"
#include "post/pictures/isotherms.hpp"
#include "post/pictures/section_plane.hpp"

namespace tiretherm::post {

namespace look {
inline constexpr int page_width = 1600;  ///< px
inline constexpr int left_margin = 120;
inline constexpr int right_margin = 60;
inline constexpr int top_margin = 165;
}  // namespace look

inline constexpr double millimetre = 1e-3;  ///< m

/// Where a plane lies on the page.
struct Layout {
    int x = 0;  ///< px, left end
    int width = 0;
    int height = 0;
    Scale across;  ///< mm
    Scale depth;   ///< mm

    [[nodiscard]] double bottom() const { return look::top_margin + height; }
};

/// As wide as the page, or as high as is sensible.
/// @param stretch scale of the depth over the scale across
[[nodiscard]] Layout lay_out(const SectionPlane& plane, double stretch);

/// The field at the middle of each pixel. @returns degC
[[nodiscard]] Raster rasterise(const SectionPlane& plane, const Layout& layout);

}  // namespace tiretherm::post
