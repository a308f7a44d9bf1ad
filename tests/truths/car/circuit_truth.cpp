// SPDX-License-Identifier: BSD-3-Clause
// Curvature of a polar curve by its derivatives, and even steps along it.

#include "car/circuit_truth.hpp"

#include <cmath>
#include <numbers>

namespace hidden_effects {

namespace {

using std::numbers::pi;
constexpr double mean_radius = 330.0;  // m

/// r and its first two derivatives by the angle.
std::array<double, 3> polar(double a) {
    const double two = 0.30;
    const double three = 0.16;
    return {mean_radius * (1.0 + two * std::cos(2.0 * a) + three * std::sin(3.0 * a)),
            mean_radius * (-2.0 * two * std::sin(2.0 * a) + 3.0 * three * std::cos(3.0 * a)),
            mean_radius * (-4.0 * two * std::cos(2.0 * a) - 9.0 * three * std::sin(3.0 * a))};
}

double between(const std::vector<double>& values, double at) {
    const auto n = static_cast<double>(values.size());
    const double place = at - n * std::floor(at / n);
    const auto i = static_cast<std::size_t>(place) % values.size();
    const double share = place - std::floor(place);
    return values[i] + share * (values[(i + 1) % values.size()] - values[i]);
}

}  // namespace

double Circuit::curvature_at(double s) const { return between(curvature, s / step); }

std::array<double, 2> Circuit::place_at(double s) const {
    const auto n = static_cast<double>(place.size());
    const double at = s / step - n * std::floor(s / step / n);
    const auto i = static_cast<std::size_t>(at) % place.size();
    const double share = at - std::floor(at);
    const std::array<double, 2>& from = place[i];
    const std::array<double, 2>& to = place[(i + 1) % place.size()];
    return {from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])};
}

Circuit made_up_circuit() {
    constexpr std::size_t fine = 200'000;
    const double da = 2.0 * pi / static_cast<double>(fine);
    double length = 0.0;
    for (std::size_t i = 0; i < fine; ++i) {
        const auto [r, dr, ddr] = polar(da * (static_cast<double>(i) + 0.5));
        length += da * std::hypot(r, dr);
    }
    Circuit circuit;
    constexpr double about = 1.0;  // m
    const auto points = static_cast<std::size_t>(length / about);
    circuit.step = length / static_cast<double>(points);
    double s = 0.0;
    const double start = polar(0.0)[0];
    for (std::size_t i = 0; i < fine && circuit.curvature.size() < points; ++i) {
        const double a = da * static_cast<double>(i);
        const auto [r, dr, ddr] = polar(a);
        if (s >= circuit.step * static_cast<double>(circuit.curvature.size())) {
            circuit.curvature.push_back((r * r + 2.0 * dr * dr - r * ddr) / std::pow(r * r + dr * dr, 1.5));
            circuit.place.push_back({r * std::cos(a) - start, r * std::sin(a)});
        }
        const auto [rm, drm, ddrm] = polar(a + 0.5 * da);
        s += da * std::hypot(rm, drm);
    }
    return circuit;
}

std::array<double, 2> on_earth(const std::array<double, 2>& place) {
    constexpr double earth = 6.371e6;  // m
    constexpr double latitude = 41.5;
    constexpr double longitude = 12.5;
    const double degree = pi / 180.0 * earth;
    return {latitude + place[1] / degree, longitude + place[0] / (degree * std::cos(latitude * pi / 180.0))};
}

}  // namespace hidden_effects
