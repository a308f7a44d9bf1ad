// SPDX-License-Identifier: BSD-3-Clause
// Linear axes of pictures, with the colours and sizes that all pictures share.
#pragma once

#include <string>

#include "post/pictures/canvas.hpp"
#include "post/pictures/ticks.hpp"

namespace tiretherm::post {

/// Inks and sizes that the pictures share.
namespace look {
inline constexpr Colour paper = colour(0xffffff);
inline constexpr Colour ink = colour(0x222222);
inline constexpr Colour faint = colour(0x666666);
inline constexpr Colour grid = colour(0xe4e4e4);
inline constexpr double title = 34.0;  ///< px
inline constexpr double text = 24.0;   ///< px
inline constexpr double tick = 8.0;    ///< px
}  // namespace look

/// A linear axis: from the value `low` at pixel `from` to the value `high` at pixel `to`; where both values are equal,
/// all is at `from`.
struct Scale {
    double low = 0.0;
    double high = 1.0;
    double from = 0.0;
    double to = 1.0;

    [[nodiscard]] double px(double value) const {
        return high > low ? from + (value - low) / (high - low) * (to - from) : from;
    }
};

/// Ticks, numbers and a name below a horizontal axis at height y.
void draw_axis_below(Canvas& canvas, const Scale& scale, const Ticks& ticks, double y, const std::string& name);

/// The same to the left of a vertical axis at x; the name is turned to read from below.
void draw_axis_left(Canvas& canvas, const Scale& scale, const Ticks& ticks, double x, const std::string& name);

}  // namespace tiretherm::post
