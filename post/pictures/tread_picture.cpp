// SPDX-License-Identifier: BSD-3-Clause
// Draws the tread surface of a ring unrolled, angle against meridian, with the position of the contact.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "mesh/ring.hpp"
#include "physics/contact/travelling.hpp"
#include "post/pictures/axes.hpp"
#include "post/pictures/colour_bar.hpp"
#include "post/pictures/field_layout.hpp"
#include "post/pictures/picture.hpp"
#include "solver/celsius.hpp"

namespace tiretherm::post {

namespace {

constexpr double left = 130.0;
constexpr double top = 165.0;
constexpr double height = 330.0;
constexpr double whole = 360.0;  // deg

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

/// A stretch of the circumference as up to two pieces within 0 to 360 deg.
template <typename Draw>
void wrapped(double from, double to, const Draw& draw) {
    const double shift = whole * std::floor(from / whole);
    draw(from - shift, std::min(to - shift, whole));
    if (to - shift > whole) {
        draw(0.0, to - shift - whole);
    }
}

/// Where the contact is, as a bar above the map.
void draw_contact(Canvas& canvas, const Scale& around, const solver::Problem& problem, double time) {
    const physics::TravellingContact contact(problem.tire, problem.input_signals.at(time, solver::JumpSide::before));
    if (!contact.touches() || !std::ranges::any_of(problem.effects, physics::travels)) {
        return;
    }
    const double half = 0.5 * degrees(contact.length());
    const double middle = degrees(problem.input_signals.at(time, solver::JumpSide::before).wheel_angle) - 0.5 * whole;
    wrapped(middle - half, middle + half, [&](double from, double to) {
        canvas.rectangle({around.px(from), top - 16.0}, around.px(to) - around.px(from), 8.0, look::ink);
        if (to - from > half) {
            canvas.write(
                {std::clamp(0.5 * (around.px(from) + around.px(to)), around.from + 40.0, around.to - 40.0), top - 34.0},
                "contact", {.size = look::text, .ink = look::ink, .align = Align::centre});
        }
    });
}

}  // namespace

void draw_tread(const std::filesystem::path& path, const solver::Problem& problem, double time,
                std::span<const double> temperature) {
    const mesh::Mesh& mesh = problem.mesh;
    const std::vector<mesh::PatchFace>& faces =
        mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].faces;
    double low = 1e300;
    double high = -1e300;
    double edge = 0.0;  // mm
    for (const mesh::PatchFace& face : faces) {
        low = std::min(low, solver::celsius(temperature[static_cast<std::size_t>(face.node)]));
        high = std::max(high, solver::celsius(temperature[static_cast<std::size_t>(face.node)]));
        edge = std::max({edge, -1e3 * face.extent[0], 1e3 * face.extent[1]});
    }
    Canvas canvas(look::page_width, static_cast<int>(top + height + 330.0), look::paper);
    canvas.write({left, 40.0}, problem.title.empty() ? problem.name : problem.title,
                 {.size = look::title, .ink = look::ink, .bold = true});
    canvas.write({left, 88.0}, fmt::format("t = {:.6g} s; surface of the tread, unrolled; outboard above", time),
                 {.size = look::text, .ink = look::faint});
    const Scale around{.low = 0.0, .high = whole, .from = left, .to = look::page_width - 60.0};
    const Scale across{.low = -edge, .high = edge, .from = top, .to = top + height};
    const double half = 0.5 * whole / mesh.sectors;
    for (const mesh::PatchFace& face : faces) {
        const double kelvin = temperature[static_cast<std::size_t>(face.node)];
        const double share = high > low ? (solver::celsius(kelvin) - low) / (high - low) : 0.5;
        const double middle = whole * mesh::sector_of(mesh, face.node) / mesh.sectors;
        wrapped(middle - half, middle + half, [&](double from, double to) {
            const double y0 = across.px(1e3 * face.extent[0]);
            const double y1 = across.px(1e3 * face.extent[1]);
            canvas.tile(std::array{Dot{around.px(from), y0}, Dot{around.px(to), y0}, Dot{around.px(to), y1},
                                   Dot{around.px(from), y1}},
                        heat_colour(share));
        });
    }
    draw_contact(canvas, around, problem, time);
    draw_axis_below(canvas, around, {.values = {0.0, 60.0, 120.0, 180.0, 240.0, 300.0, 360.0}, .decimals = 0},
                    top + height, "angle in the rubber's frame [deg]");
    draw_axis_left(canvas, across, ticks(-edge, edge, 5), left, "along the meridian [mm]");
    draw_colour_bar(canvas, low, high, ticks(low, high, 9), top + height + 150.0);
    canvas.save(path);
}

}  // namespace tiretherm::post
