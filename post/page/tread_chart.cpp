// SPDX-License-Identifier: BSD-3-Clause
// Each face of the outer surface is a rectangle of angle and meridian.
#include "post/page/tread_chart.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/ring.hpp"
#include "physics/celsius.hpp"
#include "physics/contact/travelling.hpp"
#include "post/page/charts.hpp"

namespace tiretherm::post {

namespace {

constexpr double full_turn = 360.0;  // deg
constexpr double mm_per_metre = 1e3;

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

const std::vector<mesh::PatchFace>& faces_of(const mesh::Mesh& mesh) {
    return mesh.patches[static_cast<std::size_t>(mesh.find_patch("outside"))].faces;
}

/// Angle of the middle of a face's sector.
double angle_of(const mesh::Mesh& mesh, const mesh::PatchFace& face) {
    return full_turn * mesh::sector_of(mesh, face.node) / mesh.sectors;
}

/// From where to where the contact reaches at a moment; null where nothing goes round. The first is within 0 to 360 degrees.
Value contact_at(const solver::Problem& problem, double time) {
    const physics::Inputs inputs = problem.input_signals.at(time, solver::JumpSide::before);
    const physics::TravellingContact contact(problem.tire, inputs);
    if (!contact.touches() || !std::ranges::any_of(problem.effects, physics::travels)) {
        return {};
    }
    // What is at angle 0 meets the road half a turn later.
    const double length = degrees(contact.length());
    const double entry = degrees(inputs.wheel_angle) - 0.5 * full_turn - 0.5 * length;
    const double from = entry - full_turn * std::floor(entry / full_turn);
    return Value::List{rounded(from, 5), rounded(from + length, 5)};
}

}  // namespace

Moment TreadFrames::moment_of(double time, std::span<const double> temperature) const {
    Moment moment{.time = time, .celsius = {}, .mark = {}};
    for (const mesh::PatchFace& face : faces_of(problem_->mesh)) {
        moment.celsius.push_back(static_cast<float>(celsius(temperature[static_cast<std::size_t>(face.node)])));
    }
    return moment;
}

Value TreadFrames::chart() const {
    const mesh::Mesh& mesh = problem_->mesh;
    const double half = 0.5 * full_turn / mesh.sectors;
    double edge = 0.0;  // mm
    Value::List polygons;
    for (const mesh::PatchFace& face : faces_of(mesh)) {
        const double middle = angle_of(mesh, face);
        const double top = mm_per_metre * face.extent[0];
        const double bottom = mm_per_metre * face.extent[1];
        for (const double value :
             {middle - half, top, middle + half, top, middle + half, bottom, middle - half, bottom}) {
            polygons.emplace_back(rounded(value, 5));
        }
        edge = std::max({edge, -top, bottom});
    }
    const std::vector<Moment> shown = moments_.shown();
    Value::List contacts;
    for (const Moment& moment : shown) {
        contacts.push_back(contact_at(*problem_, moment.time));
    }
    Value data{{"kind", "field"}, {"first", "end"}};
    data.set(moments_.data(shown));
    data.set({{"x", Value{{"name", "angle in the frame of the rubber"},
                          {"unit", "°"},
                          {"min", rounded(-half, 5)},
                          {"max", rounded(full_turn - half, 5)},
                          {"ticks", Value::List{0, 60, 120, 180, 240, 300}}}},
              {"y", Value{{"name", "along the meridian"},
                          {"unit", "mm"},
                          {"min", rounded(-edge, 5)},
                          {"max", rounded(edge, 5)},
                          {"down", true}}},
              {"corners", 4},
              {"polygons", std::move(polygons)},
              {"contacts", std::move(contacts)}});
    return data;
}

std::string TreadFrames::caption() const {
    return "The outer surface, outboard above. One colour scale for all moments; the bar above is the contact. What is "
           "at 0° "
           "starts at the top of the wheel.";
}

}  // namespace tiretherm::post
