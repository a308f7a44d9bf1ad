// SPDX-License-Identifier: BSD-3-Clause
// Computes size and position of the plane on the page and samples the field at the pixels.

#include "post/pictures/field_layout.hpp"

#include <algorithm>

#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr int tallest = 900;  // px

/// The middles of n equal parts between two ends.
std::vector<double> middles(double from, double to, int n) {
    std::vector<double> result(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        result[static_cast<std::size_t>(i)] = from + (i + 0.5) / n * (to - from);
    }
    return result;
}

}  // namespace

Layout lay_out(const SectionPlane& plane, double stretch) {
    const double wide = plane.right() - plane.left();
    const double deep = stretch * (plane.depth.back() - plane.depth.front());
    const int room = look::page_width - look::left_margin - look::right_margin;
    const double px = std::min(room / wide, tallest / deep);
    Layout layout{.x = 0,
                  .width = static_cast<int>(px * wide),
                  .height = std::max(2, static_cast<int>(px * deep)),
                  .across = {},
                  .depth = {}};
    layout.x = look::left_margin + (room - layout.width) / 2;
    layout.across = {.low = plane.left() / millimetre,
                     .high = plane.right() / millimetre,
                     .from = static_cast<double>(layout.x),
                     .to = static_cast<double>(layout.x + layout.width)};
    layout.depth = {.low = plane.depth.front() / millimetre,
                    .high = plane.depth.back() / millimetre,
                    .from = look::top_margin,
                    .to = layout.bottom()};
    return layout;
}

Raster rasterise(const SectionPlane& plane, const Layout& layout) {
    Raster raster{.width = layout.width,
                  .height = layout.height,
                  .value = plane.sample(middles(plane.left(), plane.right(), layout.width),
                                        middles(plane.depth.front(), plane.depth.back(), layout.height))};
    std::transform(raster.value.begin(), raster.value.end(), raster.value.begin(), solver::celsius);
    const auto [low, high] = std::minmax_element(plane.kelvin.begin(), plane.kelvin.end());
    raster.low = solver::celsius(*low);
    raster.high = solver::celsius(*high);
    return raster;
}

}  // namespace tiretherm::post
