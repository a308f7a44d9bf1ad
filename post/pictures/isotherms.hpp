// SPDX-License-Identifier: BSD-3-Clause
// A field on pixels, its colours with isotherms, and where the isotherms carry their labels.
#pragma once

#include <span>
#include <vector>

#include "post/pictures/canvas.hpp"

namespace tiretherm::post {

/// A field on pixels, row by row from the top.
struct Raster {
    int width = 0;
    int height = 0;
    std::vector<double> value;  ///< [width * height]
    double low = 0.0;           ///< value of the coldest colour
    double high = 0.0;          ///< value of the hottest colour

    [[nodiscard]] double at(int x, int y) const {
        return value[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
    [[nodiscard]] double share(double v) const { return high > low ? (v - low) / (high - low) : 0.0; }
    /// Distance of a pixel from the line where the field is `level`, by its gradient there. px; huge where it is flat
    [[nodiscard]] double distance(int x, int y, double level) const;
};

/// Black or white, whichever shows on the colour of a level.
[[nodiscard]] Colour level_ink(const Raster& raster, double level);

/// Colours of a field with its isotherms as fine lines. @param levels may be empty  @returns [width * height]
[[nodiscard]] std::vector<Colour> shade(const Raster& raster, std::span<const double> levels);

/// Where an isotherm carries its number.
struct LevelMark {
    double level = 0.0;
    Dot place;  ///< px in the raster
};

/// A place on each isotherm, away from the left end, where the layers are named, apart from one another and from the frame; none for an isotherm without room.
/// @param room px needed round a number
[[nodiscard]] std::vector<LevelMark> level_marks(const Raster& raster, std::span<const double> levels, double room);

}  // namespace tiretherm::post
