// SPDX-License-Identifier: BSD-3-Clause
// Draws three panels with their colour scales, in mm about the origin of the specimen.

#include "post/pictures/camera_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include <fmt/format.h>

#include "post/pictures/axes.hpp"
#include "post/pictures/canvas.hpp"

namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered here

namespace {

constexpr double freezing = 273.15;
constexpr double panel = 520.0;  // px, of the longer side of an image
constexpr double between = 170.0;
constexpr double left = 120.0;
constexpr double top = 150.0;
constexpr double bar_height = 24.0;
constexpr Colour left_out = colour(0xb8b8b8);
constexpr Colour too_hot = colour(0xd55e00);
constexpr Colour too_cold = colour(0x0072b2);

using Shade = std::function<Colour(double share)>;

/// A scale below an image.
void draw_bar(Canvas& canvas, const Scale& scale, double y, const std::string& unit, const Shade& shade) {
    constexpr int steps = 100;
    const double width = scale.to - scale.from;
    for (int i = 0; i < steps; ++i) {
        canvas.rectangle({scale.from + i * width / steps, y}, width / steps + 0.5, bar_height,
                         shade((i + 0.5) / steps));
    }
    canvas.frame({scale.from, y}, width, bar_height, look::faint, 1.0);
    draw_axis_below(canvas, scale, ticks(scale.low, scale.high, 5), y + bar_height, unit);
}

/// One image: its pixels, a frame in mm about the specimen's origin, and the name above.
struct Panel {
    const ComparedImages& images;
    double scale;  ///< px per pixel
    double from;
    double width;
    double height;

    void draw(Canvas& canvas, const std::string& name, const std::vector<double>& value, double low, double high,
              const Shade& shade) const {
        canvas.write({from + width / 2.0, top - 24.0}, name,
                     {.size = look::text, .ink = look::ink, .align = Align::centre, .bold = true});
        canvas.rectangle({from, top}, width, height, left_out);
        for (std::size_t p = 0; p < images.pixels(); ++p) {
            const double x = from + images.place[p][1] * scale;
            const double y = top + images.place[p][0] * scale;
            const double share = high > low ? (value[p] - low) / (high - low) : 0.5;
            canvas.tile(std::array{Dot{x, y}, Dot{x + scale, y}, Dot{x + scale, y + scale}, Dot{x, y + scale}},
                        shade(std::clamp(share, 0.0, 1.0)));
        }
        canvas.frame({from, top}, width, height, look::faint, 1.0);
        const double half = 0.5e3 * images.columns * images.pitch_x;
        const Scale across{.low = -half, .high = half, .from = from, .to = from + width};
        draw_axis_below(canvas, across, ticks(-half, half, 5), top + height, "mm from the image's centre");
    }
};

}  // namespace

void draw_images(const std::filesystem::path& path, const ComparedImages& images, std::size_t frame,
                 const std::string& title) {
    const double scale = panel / std::max(images.rows, images.columns);
    const double width = scale * images.columns;
    const double height = scale * images.rows;
    Canvas canvas(static_cast<int>(left + 3.0 * width + 2.0 * between + left), static_cast<int>(top + height + 330.0),
                  look::paper);
    canvas.write({left, 50.0}, fmt::format("{}: {:.6g} s", title, images.time[frame]),
                 {.size = look::title, .ink = look::ink, .bold = true});
    const auto of_frame = [&](const std::vector<double>& all) {
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(frame * images.pixels());
        std::vector<double> celsius(first, first + static_cast<std::ptrdiff_t>(images.pixels()));
        std::ranges::for_each(celsius, [](double& value) { value -= freezing; });
        return celsius;
    };
    const std::vector<double> measured = of_frame(images.measured);
    const std::vector<double> simulated = of_frame(images.simulated);
    const double low = std::min(*std::ranges::min_element(measured), *std::ranges::min_element(simulated));
    const double high = std::max(*std::ranges::max_element(measured), *std::ranges::max_element(simulated));
    std::vector<double> difference(images.pixels());
    double most = 0.0;
    for (std::size_t p = 0; p < images.pixels(); ++p) {
        difference[p] = simulated[p] - measured[p];
        most = std::max(most, std::abs(difference[p]));
    }
    const Shade heat = [](double share) { return heat_colour(share); };
    const Shade both = [](double share) {
        return mix(look::paper, share > 0.5 ? too_hot : too_cold, std::abs(2.0 * share - 1.0));
    };
    const double bar = top + height + 130.0;
    double from = left;
    const auto next = [&] {
        const Panel one{.images = images, .scale = scale, .from = from, .width = width, .height = height};
        from += width + between;
        return one;
    };
    const auto bar_of = [&](const Panel& one, double bottom, double ceiling) {
        return Scale{.low = bottom, .high = ceiling, .from = one.from, .to = one.from + one.width};
    };
    const Panel first = next();
    first.draw(canvas, "measured", measured, low, high, heat);
    draw_bar(canvas, bar_of(first, low, high), bar, "degC", heat);
    const Panel second = next();
    second.draw(canvas, "simulated", simulated, low, high, heat);
    draw_bar(canvas, bar_of(second, low, high), bar, "degC", heat);
    const Panel third = next();
    third.draw(canvas, "simulated - measured", difference, -most, most, both);
    draw_bar(canvas, bar_of(third, -most, most), bar, "K", both);
    canvas.save(path);
}

}  // namespace tiretherm::post
