// SPDX-License-Identifier: BSD-3-Clause
// Adds up circular arcs from the centre plane to a place s; the mean radius of a stretch is found by Gauss's five-point
// rule on each arc.

#include "mesh/meridian.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tiretherm::mesh {

Meridian::Meridian(double radius, std::vector<Arc> arcs) : radius_(radius), arcs_(std::move(arcs)) {}

Meridian::ProfilePoint Meridian::at(double s) const {
    ProfilePoint place{.lateral = 0.0, .radius = radius_, .turn = 0.0};
    double left = std::abs(s);
    for (std::size_t i = 0; i <= arcs_.size() && left > 0.0; ++i) {
        const bool beyond = i == arcs_.size();
        const double length = beyond ? left : std::min(left, arcs_[i].length);
        const double curvature = beyond ? 0.0 : arcs_[i].curvature;
        const double turned = curvature * length;
        if (curvature == 0.0) {
            place.lateral += length * std::cos(place.turn);
            place.radius -= length * std::sin(place.turn);
        } else {
            place.lateral += (std::sin(place.turn + turned) - std::sin(place.turn)) / curvature;
            place.radius -= (std::cos(place.turn) - std::cos(place.turn + turned)) / curvature;
        }
        place.turn += turned;
        left -= length;
    }
    if (s < 0.0) {
        place.lateral = -place.lateral;
        place.turn = -place.turn;
    }
    return place;
}

Meridian::ProfilePoint Meridian::inside(double s, double depth) const {
    ProfilePoint place = at(s);
    place.lateral -= depth * std::sin(place.turn);
    place.radius -= depth * std::cos(place.turn);
    return place;
}

double Meridian::mean_radius(double from, double to) const {
    // Gauss's rule of five points on every arc that the stretch meets; mirrored stretches take mirrored points.
    if (from < 0.0 && to > 0.0) {
        return (mean_radius(0.0, -from) * -from + mean_radius(0.0, to) * to) / (to - from);
    }
    if (to <= 0.0) {
        return mean_radius(-to, -from);
    }
    constexpr double x[] = {0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr double w[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    double integral = 0.0;
    double low = from;
    double end = 0.0;
    for (std::size_t i = 0; low < to; ++i) {
        end = i < arcs_.size() ? end + arcs_[i].length : to;
        const double high = std::min(end, to);
        if (high <= low) {
            continue;
        }
        const double middle = 0.5 * (low + high);
        const double half = 0.5 * (high - low);
        for (int p = 0; p < 3; ++p) {
            const double sum =
                p == 0 ? at(middle).radius : at(middle - half * x[p]).radius + at(middle + half * x[p]).radius;
            integral += half * w[p] * sum;
        }
        low = high;
    }
    return integral / (to - from);
}

}  // namespace tiretherm::mesh
