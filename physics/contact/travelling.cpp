// SPDX-License-Identifier: BSD-3-Clause
// Finds the contact's angle l/R_R and the angle since entry, l/(2 R_R) +- (wheel angle - pi), and the part of a sector
// that lies inside.

#include "physics/contact/travelling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/ring.hpp"

namespace tiretherm::physics {

namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double longest = 2.0;  // rad; beyond it a tire is no tire

/// The same angle in [low, low + 2 pi).
double reduced(double angle, double low) {
    const double turns = std::floor((angle - low) / turn);
    return angle - turns * turn;
}

}  // namespace

TravellingContact::TravellingContact(const Tire& tire, const Inputs& inputs) {
    const double turning = rolling_speed(inputs);
    // The faster of tread and road: a locked wheel stands on one place, under which the road passes.
    const double speed = std::max(std::abs(turning), std::abs(inputs.speed));
    if (!tire.touches(inputs.vertical_load) || speed == 0.0) {
        return;
    }
    const double radius = tire.rolling_radius(inputs);
    length_ = std::clamp(tire.contact_length(inputs) / radius, 0.0, longest);
    angular_speed_ = speed / radius;
    direction_ = turning < 0.0 ? -1.0 : 1.0;
    since_entry_ = 0.5 * length_ + direction_ * (inputs.wheel_angle - std::numbers::pi);
}

TravellingContact::Part TravellingContact::part(int sector, int sectors) const {
    if (!touches()) {
        return {};
    }
    if (sectors == 1) {
        const double since = reduced(since_entry_, 0.0);
        return {.inside = since < length_, .from = since, .to = since};
    }
    const double half = 0.5 * turn / sectors;
    const double middle = reduced(since_entry_ - direction_ * turn * sector / sectors, -half);
    const double from = std::clamp(middle - half, 0.0, length_);
    const double to = std::clamp(middle + half, 0.0, length_);
    return {.inside = to > from, .from = from, .to = to};
}

double concentration(const TravellingContact& contact, int sector, int sectors) {
    const TravellingContact::Part part = contact.part(sector, sectors);
    if (!part.inside) {
        return 0.0;
    }
    return sectors == 1 ? turn / contact.length() : (part.to - part.from) / contact.length() * sectors;
}

bool travels(const ActiveEffect& active) {
    const int choice = find_choice(*active.effect, around_key);
    const HeatEffect* heat = active.effect->heat_effect();
    return (heat != nullptr && heat->travels) ||
           (choice >= 0 && active.choices[static_cast<std::size_t>(choice)] == in_contact);
}

std::vector<int> sectors_of(const mesh::Mesh& mesh, const std::vector<int>& nodes) {
    std::vector<int> sectors;
    std::ranges::transform(nodes, std::back_inserter(sectors), [&](int node) { return mesh::sector_of(mesh, node); });
    return sectors;
}

}  // namespace tiretherm::physics
