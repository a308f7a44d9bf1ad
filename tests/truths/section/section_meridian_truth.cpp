// SPDX-License-Identifier: BSD-3-Clause
// The outer profile as three tangent arcs: crown, shoulder and sidewall.

#include "section/section_meridian_truth.hpp"

#include <cmath>
#include <numbers>

namespace hidden_effects {

namespace {

using std::numbers::pi;
constexpr double crown_radius = 1.0;
constexpr double bead_radius = centre_radius - 0.1125;

/// An arc that turns evenly from one angle to another.
struct Arc {
    double from, to;        ///< rad
    double length, radius;  ///< m; the radius about the tire's axis where it begins
    [[nodiscard]] double at(double along) const {
        const double per = (to - from) / length;
        return radius - (std::cos(from) - std::cos(from + per * along)) / per;
    }
};

Arc crown_arc() { return {0.0, crown_edge / crown_radius, crown_edge, centre_radius}; }
Arc shoulder_arc() { return {crown_arc().to, pi / 4.0, tread_edge - crown_edge, crown_arc().at(crown_edge)}; }
Arc sidewall_arc() {
    const Arc before = shoulder_arc();
    const double from = before.at(before.length);
    const double to = 2.0 * pi / 3.0;
    const double length = (from - bead_radius) * (to - before.to) / (std::cos(before.to) - std::cos(to));
    return {before.to, to, length, from};
}

}  // namespace

double section_radius(double s) {
    const double along = std::abs(s);
    if (along <= crown_edge) {
        return crown_arc().at(along);
    }
    return along <= tread_edge ? shoulder_arc().at(along - crown_edge) : sidewall_arc().at(along - tread_edge);
}

double section_reach() { return tread_edge + sidewall_arc().length; }

}  // namespace hidden_effects
