// SPDX-License-Identifier: BSD-3-Clause
// Draws the temperature of a tire's cross-section in its real shape, with the borders of layers and zones and the
// hottest place.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "mesh/place.hpp"
#include "mesh/ring.hpp"
#include "post/pictures/axes.hpp"
#include "post/pictures/colour_bar.hpp"
#include "post/pictures/drawn_field.hpp"
#include "post/pictures/field_layout.hpp"
#include "post/pictures/folded_section.hpp"
#include "post/pictures/picture.hpp"
#include "post/report/number_text.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

using mesh::Mesh;
using mesh::Point;

constexpr int pieces = 4;  ///< a cell is drawn as so many squared quadrilaterals, the colour even in each
constexpr double margin = 110.0;
constexpr double room_above = 150.0;

/// From metres in the section's plane to pixels.
struct Page {
    double scale = 1.0;  ///< px/m
    double left = 0.0;   ///< m
    double top = 0.0;    ///< m, largest radius
    double height = 0.0;

    [[nodiscard]] Dot dot(double lateral, double radius) const {
        return {margin + scale * (lateral - left), room_above + scale * (top - radius)};
    }
    [[nodiscard]] Dot dot(const FoldedSection::Place& place) const { return dot(place[0], place[1]); }
};

Page page_of(const Mesh& mesh) {
    double left = 1e300;
    double right = -1e300;
    double top = -1e300;
    double bottom = 1e300;
    for (const Point& p : mesh.drawing.points) {
        left = std::min(left, p[0]);
        right = std::max(right, p[0]);
        top = std::max(top, p[2]);
        bottom = std::min(bottom, p[2]);
    }
    const double scale = (look::page_width - 2.0 * margin) / (right - left);
    return {.scale = scale, .left = left, .top = top, .height = scale * (top - bottom)};
}

/// Between the corners of a cell. @param u from outboard to inboard, 0 to 1  @param v from the inner to the outer side
double blend(const std::array<double, 4>& value, double u, double v) {
    return (1.0 - v) * ((1.0 - u) * value[0] + u * value[1]) + v * ((1.0 - u) * value[3] + u * value[2]);
}

void fill_cell(Canvas& canvas, const Page& page, const FoldedSection& section, int cell, std::span<const double> kelvin,
               double low, double high) {
    std::array<double, 4> T{};
    for (std::size_t i = 0; i < 4; ++i) {
        T[i] = solver::celsius(kelvin[section.corner(cell, i)]);
    }
    for (int a = 0; a < pieces; ++a) {
        for (int b = 0; b < pieces; ++b) {
            const auto at = [&](int i, int j) {
                return page.dot(
                    section.in_cell(cell, static_cast<double>(i) / pieces, static_cast<double>(j) / pieces));
            };
            const double middle = blend(T, (a + 0.5) / pieces, (b + 0.5) / pieces);
            canvas.tile(std::array{at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)},
                        heat_colour((middle - low) / std::max(high - low, 1e-9)));
        }
    }
}

/// Lines where layers meet and where zones meet.
void draw_borders(Canvas& canvas, const Page& page, const FoldedSection& section) {
    const Colour faint = colour(0xffffff, 0.6);
    for (const FoldedSection::Border& border : section.borders()) {
        std::vector<Dot> line;
        for (const FoldedSection::Place& place : border.line) {
            line.push_back(page.dot(place));
        }
        canvas.line(line, faint, border.of_zones ? 2.0 : 1.5, border.of_zones);
    }
}

/// The name of each zone beside its middle column, inside the cavity.
void name_zones(Canvas& canvas, const Page& page, const FoldedSection& section, const Mesh& mesh) {
    for (std::size_t zone = 0; zone < mesh.zones.size(); ++zone) {
        const std::optional<FoldedSection::Place> below = section.below_zone(zone);
        if (!below) {
            continue;
        }
        const Dot at = page.dot(*below);
        const bool left = at.x < 0.4 * look::page_width;
        const bool right = at.x > 0.6 * look::page_width;
        canvas.write({left    ? at.x + 22.0
                      : right ? at.x - 22.0
                              : at.x,
                      at.y + 30.0},
                     in_words(mesh.zones[zone]),
                     {.size = look::text,
                      .ink = look::faint,
                      .align = left    ? Align::left
                               : right ? Align::right
                                       : Align::centre});
    }
}

}  // namespace

void draw_folded(const std::filesystem::path& path, const solver::Problem& problem, double time,
                 std::span<const double> temperature) {
    const bool is_ring = problem.mesh.sectors > 1;
    const Mesh mesh = is_ring ? mesh::drawn_section(problem.mesh) : problem.mesh;
    const std::vector<double> mean = is_ring ? mesh::around(problem.mesh, temperature) : std::vector<double>{};
    const std::span<const double> shown = is_ring ? std::span<const double>(mean) : temperature;
    const std::vector<double> kelvin = DrawnField(mesh).at_points(shown);
    const FoldedSection section(mesh);
    const solver::HotSpotFinder::Found hottest = section.hottest(shown);
    const double low = solver::celsius(std::ranges::min(kelvin));
    const double high = solver::celsius(hottest.temperature);
    const Page page = page_of(mesh);
    Canvas canvas(look::page_width, static_cast<int>(room_above + page.height + 215.0), look::paper);
    canvas.write({margin, 40.0}, problem.title.empty() ? problem.name : problem.title,
                 {.size = look::title, .ink = look::ink, .bold = true});
    const std::string moment =
        problem.settings.steady ? std::string("steady state") : fmt::format("t = {:.6g} s", time);
    canvas.write({margin, 88.0},
                 fmt::format("{}{}; hottest {:.1f} °C (circle); outboard on the left, inboard on the right", moment,
                             is_ring ? ", mean around the tire" : "", high),
                 {.size = look::text, .ink = look::faint});
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        fill_cell(canvas, page, section, cell, kelvin, low, high);
    }
    draw_borders(canvas, page, section);
    name_zones(canvas, page, section, mesh);
    if (const auto place = section.place(hottest.point[0], hottest.point[2])) {
        canvas.disc(page.dot(*place), 7.0, colour(0xffffff, 0.9), look::ink, 2.0);
    }
    draw_colour_bar(canvas, low, high, ticks(low, high, 9), room_above + page.height + 60.0);
    canvas.save(path);
}

}  // namespace tiretherm::post
