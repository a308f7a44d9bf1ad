// SPDX-License-Identifier: BSD-3-Clause
// Draws the temperature across the thickness: colours, isotherms with their values, layers, axes and the hottest place.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "post/pictures/axes.hpp"
#include "post/pictures/colour_bar.hpp"
#include "post/pictures/field_layout.hpp"
#include "post/pictures/picture.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr int below_plot = 215;  // px

/// Round temperatures strictly between coldest and hottest.
Ticks isotherm_levels(const Raster& raster) {
    Ticks levels = ticks(raster.low, raster.high, 9);
    const double edge = 0.02 * (raster.high - raster.low);
    std::erase_if(levels.values, [&](double v) { return v <= raster.low + edge || v >= raster.high - edge; });
    return levels;
}

void draw_layers(Canvas& canvas, const mesh::Mesh& mesh, const Layout& layout) {
    const mesh::Grid& grid = *mesh.grid;
    const auto layer_at = [&](int k) { return mesh.layer[static_cast<std::size_t>(grid.cell(0, 0, k))]; };
    int first = 0;
    for (int k = 1; k <= grid.size(2); ++k) {
        if (k < grid.size(2) && layer_at(k) == layer_at(first)) {
            continue;
        }
        const double above = layout.depth.px(grid.edge[2][static_cast<std::size_t>(first)] / millimetre);
        const double below = layout.depth.px(grid.edge[2][static_cast<std::size_t>(k)] / millimetre);
        if (k < grid.size(2)) {
            canvas.line(std::array{Dot{layout.across.from, below}, Dot{layout.across.to, below}}, colour(0xffffff, 0.7),
                        1.8, true);
        }
        if (mesh.layers.size() > 1 && below - above > 1.3 * look::text) {
            canvas.write({layout.across.from + 14.0, 0.5 * (above + below)},
                         mesh.layers[static_cast<std::size_t>(layer_at(first))],
                         {.size = look::text, .ink = colour(0xffffff), .halo = colour(0x000000, 0.45)});
        }
        first = k;
    }
}

void draw_level_marks(Canvas& canvas, const Raster& raster, const Ticks& levels, const Layout& layout) {
    constexpr double size = 19.0;
    for (const LevelMark& mark : level_marks(raster, levels.values, 2.0 * size)) {
        canvas.write({layout.x + mark.place.x, look::top_margin + mark.place.y}, levels.label(mark.level),
                     {.size = size,
                      .ink = level_ink(raster, mark.level),
                      .align = Align::centre,
                      .halo = heat_colour(raster.share(mark.level))});
    }
}

/// A ring at the hottest place of the plane; its temperature above the surface, or beside it where that is inside.
void draw_hottest(Canvas& canvas, const SectionPlane& plane, const Layout& layout) {
    const auto hottest =
        static_cast<std::size_t>(std::max_element(plane.kelvin.begin(), plane.kelvin.end()) - plane.kelvin.begin());
    const Dot place{layout.across.px(plane.x[hottest % plane.x.size()] / millimetre),
                    layout.depth.px(plane.depth[hottest / plane.x.size()] / millimetre)};
    canvas.disc(place, 7.0, colour(0xffffff, 0.9), look::ink, 2.0);
    const std::string text = fmt::format("{:.1f} °C", solver::celsius(plane.kelvin[hottest]));
    if (place.y < look::top_margin + 12.0) {
        canvas.write({place.x, look::top_margin - 26.0}, text,
                     {.size = look::text, .ink = look::ink, .align = Align::centre, .bold = true});
    } else {
        canvas.write({place.x + 18.0, place.y}, text,
                     {.size = look::text, .ink = look::ink, .bold = true, .halo = heat_colour(1.0)});
    }
}

std::string when(const solver::Settings& settings, double time) {
    return settings.steady ? std::string("steady state") : fmt::format("t = {:.6g} s", time);
}

}  // namespace

void draw_field(const std::filesystem::path& path, const solver::Problem& problem, double time,
                std::span<const double> temperature, const PictureOptions& options) {
    SectionPlane plane = section_plane(problem, temperature, options.shading);
    const double whole = plane.right();
    crop_uniform_rim(plane);
    const Layout layout = lay_out(plane, options.stretch);
    const Raster raster = rasterise(plane, layout);
    const Ticks levels = isotherm_levels(raster);
    const bool lines = plane.shading == Shading::smooth;
    const bool round = problem.mesh.grid->metric == mesh::Metric::axisymmetric;

    Canvas canvas(look::page_width, look::top_margin + layout.height + below_plot, look::paper);
    const double left = look::left_margin;
    canvas.write({left, 40.0}, problem.title.empty() ? problem.name : problem.title,
                 {.size = look::title, .ink = look::ink, .bold = true});
    std::string subtitle = when(problem.settings, time) + ", outer surface above";
    if (plane.right() < whole) {
        subtitle += fmt::format(", shown to {:.3g} mm of {:.3g} mm", plane.right() / millimetre, whole / millimetre);
    }
    if (options.stretch != 1.0) {
        subtitle += fmt::format(", depth stretched {:g} times", options.stretch);
    }
    canvas.write({left, 88.0}, subtitle, {.size = look::text, .ink = look::faint});

    canvas.image({static_cast<double>(layout.x), static_cast<double>(look::top_margin)}, raster.width, raster.height,
                 shade(raster, lines ? std::span<const double>(levels.values) : std::span<const double>{}));
    draw_layers(canvas, problem.mesh, layout);
    if (lines) {
        draw_level_marks(canvas, raster, levels, layout);
    }
    canvas.frame({static_cast<double>(layout.x), static_cast<double>(look::top_margin)}, layout.width, layout.height,
                 look::ink, 1.5);
    if (lines) {
        draw_hottest(canvas, plane, layout);
    }
    draw_axis_below(canvas, layout.across, ticks(layout.across.low, layout.across.high, 12), layout.bottom(),
                    round ? "x through the axis [mm]" : "x [mm]");
    const int depth_ticks = std::max(2, layout.height / 60);
    draw_axis_left(canvas, layout.depth, ticks(layout.depth.low, layout.depth.high, depth_ticks), layout.x,
                   "depth [mm]");
    draw_colour_bar(canvas, raster.low, raster.high, levels, layout.bottom() + 105.0);
    canvas.save(path);
}

}  // namespace tiretherm::post
