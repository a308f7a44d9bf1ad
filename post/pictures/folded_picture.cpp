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
#include "post/pictures/picture.hpp"
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
    [[nodiscard]] Dot dot(const Point& p) const { return dot(p[0], p[2]); }
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

/// Corners of a cell: outboard and inboard below, inboard and outboard above.
std::array<std::size_t, 4> corners(const Mesh& mesh, int cell) {
    std::array<std::size_t, 4> c{};
    for (std::size_t i = 0; i < 4; ++i) {
        c[i] = static_cast<std::size_t>(mesh.drawing.corners[4 * static_cast<std::size_t>(cell) + i]);
    }
    return c;
}

/// Between the corners of a cell. @param x from outboard to inboard, 0 to 1  @param y from below to above
template <typename Value>
auto blend(const std::array<Value, 4>& v, double x, double y) {
    return (1.0 - y) * ((1.0 - x) * v[0] + x * v[1]) + y * ((1.0 - x) * v[3] + x * v[2]);
}

void fill_cell(Canvas& canvas, const Page& page, const Mesh& mesh, int cell, std::span<const double> kelvin, double low,
               double high) {
    const std::array<std::size_t, 4> c = corners(mesh, cell);
    std::array<double, 4> T{};
    std::array<double, 4> px{};
    std::array<double, 4> py{};
    for (std::size_t i = 0; i < 4; ++i) {
        T[i] = solver::celsius(kelvin[c[i]]);
        const Dot dot = page.dot(mesh.drawing.points[c[i]]);
        px[i] = dot.x;
        py[i] = dot.y;
    }
    for (int a = 0; a < pieces; ++a) {
        for (int b = 0; b < pieces; ++b) {
            const auto at = [&](int i, int j) {
                const double x = static_cast<double>(i) / pieces;
                const double y = static_cast<double>(j) / pieces;
                return Dot{blend(px, x, y), blend(py, x, y)};
            };
            const double middle = blend(T, (a + 0.5) / pieces, (b + 0.5) / pieces);
            canvas.tile(std::array{at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b + 1)},
                        heat_colour((middle - low) / std::max(high - low, 1e-9)));
        }
    }
}

/// Lines where layers meet and where zones meet.
void draw_borders(Canvas& canvas, const Page& page, const Mesh& mesh) {
    const Colour faint = colour(0xffffff, 0.6);
    for (std::size_t i = 0; i < mesh.columns.size(); ++i) {
        const mesh::Column& column = mesh.columns[i];
        for (int k = 0; k + 1 < column.cells(); ++k) {
            const int cell = column.first_cell + k;
            if (mesh.layer[static_cast<std::size_t>(cell)] != mesh.layer[static_cast<std::size_t>(cell) + 1]) {
                const auto c = corners(mesh, cell);
                canvas.line(std::array{page.dot(mesh.drawing.points[c[0]]), page.dot(mesh.drawing.points[c[1]])}, faint,
                            1.5);
            }
        }
        if (i + 1 < mesh.columns.size() && mesh.columns[i + 1].zone != column.zone) {
            const auto outer = corners(mesh, column.first_cell);
            const auto inner = corners(mesh, column.first_cell + column.cells() - 1);
            canvas.line(std::array{page.dot(mesh.drawing.points[outer[2]]), page.dot(mesh.drawing.points[inner[1]])},
                        faint, 2.0, true);
        }
    }
}

std::string words(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// The name of each zone beside its middle column, inside the cavity.
void name_zones(Canvas& canvas, const Page& page, const Mesh& mesh) {
    for (std::size_t zone = 0; zone < mesh.zones.size(); ++zone) {
        std::vector<const mesh::Column*> own;
        for (const mesh::Column& column : mesh.columns) {
            if (column.zone == static_cast<int>(zone)) {
                own.push_back(&column);
            }
        }
        const mesh::Column& middle = *own[own.size() / 2];
        const auto inner = corners(mesh, middle.first_cell + middle.cells() - 1);
        const Dot at = page.dot(mesh.drawing.points[inner[0]]);
        const bool left = at.x < 0.4 * look::page_width;
        const bool right = at.x > 0.6 * look::page_width;
        canvas.write({left    ? at.x + 22.0
                      : right ? at.x - 22.0
                              : at.x,
                      at.y + 30.0},
                     words(mesh.zones[zone]),
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
    const std::vector<double> kelvin = DrawnField(mesh).at_points(is_ring ? mean : temperature);
    const auto hottest = std::max_element(kelvin.begin(), kelvin.end());
    const double low = solver::celsius(*std::min_element(kelvin.begin(), kelvin.end()));
    const double high = solver::celsius(*hottest);
    const Page page = page_of(mesh);
    Canvas canvas(look::page_width, static_cast<int>(room_above + page.height + 215.0), look::paper);
    canvas.write({margin, 40.0}, problem.title.empty() ? problem.name : problem.title,
                 {.size = look::title, .ink = look::ink, .bold = true});
    const std::string moment =
        problem.settings.steady ? std::string("steady state") : fmt::format("t = {:.6g} s", time);
    canvas.write(
        {margin, 88.0},
        fmt::format("{}{}; hottest {:.1f} °C between the cells (circle); outboard on the left, inboard on the right",
                    moment, is_ring ? ", mean around the tire" : "", high),
        {.size = look::text, .ink = look::faint});
    for (int cell = 0; cell < mesh.n_cells; ++cell) {
        fill_cell(canvas, page, mesh, cell, kelvin, low, high);
    }
    draw_borders(canvas, page, mesh);
    name_zones(canvas, page, mesh);
    const auto index = static_cast<std::size_t>(hottest - kelvin.begin());
    const Dot mark = page.dot(mesh.drawing.points[index]);
    canvas.disc(mark, 7.0, colour(0xffffff, 0.9), look::ink, 2.0);
    draw_colour_bar(canvas, low, high, ticks(low, high, 9), room_above + page.height + 60.0);
    canvas.save(path);
}

}  // namespace tiretherm::post
