// SPDX-License-Identifier: BSD-3-Clause
// Draws ticks, numbers and names of horizontal and vertical axes.

#include "post/pictures/axes.hpp"

#include <algorithm>
#include <array>

namespace tiretherm::post {

void draw_axis_below(Canvas& canvas, const Scale& scale, const Ticks& ticks, double y, const std::string& name) {
    for (const double value : ticks.values) {
        const double x = scale.px(value);
        canvas.line(std::array{Dot{x, y}, Dot{x, y + look::tick}}, look::ink, 1.5);
        canvas.write({x, y + look::tick + 0.8 * look::text}, ticks.label(value),
                     {.size = look::text, .ink = look::ink, .align = Align::centre});
    }
    canvas.write({0.5 * (scale.from + scale.to), y + look::tick + 2.2 * look::text}, name,
                 {.size = look::text, .ink = look::faint, .align = Align::centre});
}

void draw_axis_left(Canvas& canvas, const Scale& scale, const Ticks& ticks, double x, const std::string& name) {
    double widest = 0.0;
    for (const double value : ticks.values) {
        const double y = scale.px(value);
        const Writing writing{.size = look::text, .ink = look::ink, .align = Align::right};
        canvas.line(std::array{Dot{x, y}, Dot{x - look::tick, y}}, look::ink, 1.5);
        canvas.write({x - 1.8 * look::tick, y}, ticks.label(value), writing);
        widest = std::max(widest, canvas.width_of(ticks.label(value), writing));
    }
    canvas.write({x - 1.8 * look::tick - widest - 0.9 * look::text, 0.5 * (scale.from + scale.to)}, name,
                 {.size = look::text, .ink = look::faint, .align = Align::centre, .upwards = true});
}

}  // namespace tiretherm::post
