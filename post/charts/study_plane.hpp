// SPDX-License-Identifier: BSD-3-Clause
// Temperatures of a study over two sides of its grid, the other sides held, ready for a map.
#pragma once

#include <string>
#include <vector>

#include "post/charts/study_axis.hpp"
#include "post/pictures/isotherms.hpp"

namespace tiretherm::post {

/// The temperatures over two sides of the grid, the other sides held.
struct StudyPlane {
    StudyAxis x;
    StudyAxis y;
    std::vector<std::string> title;  ///< the values of the other sides, "drive.camber = 2 deg"
    std::vector<double> value;       ///< [x * y] degC, in the order of the axes' places; NaN where every run failed

    /// Numbers on both sides: what is between the runs can be interpolated. Otherwise each run is a tile.
    [[nodiscard]] bool smooth() const { return x.is_number && y.is_number; }
    [[nodiscard]] double at(std::size_t i, std::size_t j) const { return value[i * y.at.size() + j]; }
};

/// A plane over the first two sides for each value of the others; only the first of these planes where they are more
/// than six.   @param more out, whether there would be more
[[nodiscard]] std::vector<StudyPlane> study_planes(const diagnosis::StudyRecord& study, bool& more);

/// The plane on pixels, linear between the runs in both directions, or in tiles. Where a run
/// failed, something harmless.   @param low, high degC, ends of the colours
[[nodiscard]] Raster rasterise(const StudyPlane& plane, int width, int height, double low, double high);

}  // namespace tiretherm::post
