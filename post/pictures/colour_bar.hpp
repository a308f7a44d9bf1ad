// SPDX-License-Identifier: BSD-3-Clause
// The temperature scale below the picture of a field.
#pragma once

#include "post/pictures/canvas.hpp"
#include "post/pictures/ticks.hpp"

namespace tiretherm::post {

/// The scale below a field: colours from the coldest to the hottest temperature, with ticks.
/// @param low, high degC  @param y px, its upper end
void draw_colour_bar(Canvas& canvas, double low, double high, const Ticks& levels, double y);

}  // namespace tiretherm::post
