// SPDX-License-Identifier: BSD-3-Clause
// Draws the bar pixel by pixel with its ticks and temperatures below.

#include "post/pictures/colour_bar.hpp"

#include <fmt/format.h>

#include "post/pictures/axes.hpp"
#include "post/pictures/field_layout.hpp"

namespace tiretherm::post {

void draw_colour_bar(Canvas& canvas, double low, double high, const Ticks& levels, double y) {
    constexpr int width = 900;  // px
    constexpr int height = 26;
    const int x = (look::page_width + look::left_margin - look::right_margin - width) / 2;
    std::vector<Colour> colours;
    for (int row = 0; row < height; ++row) {
        for (int i = 0; i < width; ++i) {
            colours.push_back(heat_colour((i + 0.5) / width));
        }
    }
    canvas.image({static_cast<double>(x), y}, width, height, colours);
    canvas.frame({static_cast<double>(x), y}, width, height, look::ink, 1.5);
    const Scale scale{.low = low, .high = high, .from = static_cast<double>(x), .to = static_cast<double>(x + width)};
    draw_axis_below(canvas, scale, levels, y + height, "temperature [°C]");
    const double middle = y + 0.5 * height;
    canvas.write({scale.from - 14.0, middle}, fmt::format("{:.1f}", low),
                 {.size = look::text, .ink = look::ink, .align = Align::right});
    canvas.write({scale.to + 14.0, middle}, fmt::format("{:.1f}", high), {.size = look::text, .ink = look::ink});
}

}  // namespace tiretherm::post
