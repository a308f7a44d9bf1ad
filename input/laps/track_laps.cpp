// SPDX-License-Identifier: BSD-3-Clause
// Works in metres on the plane that touches the earth at the line.

#include "input/laps/track_laps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tiretherm::input {

namespace {

constexpr double metres_per_degree = 111320.0;  ///< of latitude; 2 pi 6 378 137 m / 360
constexpr double shortest_lap = 10.0;           ///< s
constexpr double half_width = 20.0;             ///< m, of a line that was found

struct Point {
    double x = 0.0;  ///< m, east
    double y = 0.0;  ///< m, north
};

/// Metres from an origin.
class Plane {
public:
    Plane(double latitude, double longitude)
        : latitude_(latitude), longitude_(longitude), shrink_(std::cos(latitude * std::numbers::pi / 180.0)) {}
    [[nodiscard]] Point of(double latitude, double longitude) const {
        return {metres_per_degree * shrink_ * (longitude - longitude_), metres_per_degree * (latitude - latitude_)};
    }
    [[nodiscard]] double latitude(const Point& p) const { return latitude_ + p.y / metres_per_degree; }
    [[nodiscard]] double longitude(const Point& p) const { return longitude_ + p.x / (metres_per_degree * shrink_); }

private:
    double latitude_;
    double longitude_;
    double shrink_;
};

double cross(const Point& a, const Point& b) { return a.x * b.y - a.y * b.x; }
Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y}; }
Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y}; }
Point operator*(double s, const Point& a) { return {s * a.x, s * a.y}; }

bool is_known(const Positions& positions, std::size_t i) {
    return std::isfinite(positions.latitude[i]) && std::isfinite(positions.longitude[i]) &&
           std::abs(positions.latitude[i]) <= 90.0 && std::abs(positions.longitude[i]) <= 180.0 &&
           (positions.latitude[i] != 0.0 || positions.longitude[i] != 0.0);
}

}  // namespace

std::vector<double> crossings_of(const Positions& positions, const StartLine& line) {
    struct Crossing {
        double time = 0.0;
        bool to_left = false;
    };
    const Plane plane(line.latitude_a, line.longitude_a);
    const Point along = plane.of(line.latitude_b, line.longitude_b);
    std::vector<Crossing> crossings;
    std::optional<std::size_t> before;
    for (std::size_t i = 0; i < positions.time.size(); ++i) {
        if (!is_known(positions, i)) {
            continue;
        }
        if (before) {
            const Point from = plane.of(positions.latitude[*before], positions.longitude[*before]);
            const Point to = plane.of(positions.latitude[i], positions.longitude[i]);
            const double side_from = cross(along, from);
            const double side_to = cross(along, to);
            // The sides differ; the crossing lies between the ends of the line.
            if (side_from != side_to && (side_from < 0.0) != (side_to < 0.0)) {
                const double share = side_from / (side_from - side_to);
                const Point there = from + share * (to - from);
                const double place = (there.x * along.x + there.y * along.y) / (along.x * along.x + along.y * along.y);
                if (place >= 0.0 && place <= 1.0) {
                    crossings.push_back(
                        {.time = positions.time[*before] + share * (positions.time[i] - positions.time[*before]),
                         .to_left = side_to > side_from});
                }
            }
        }
        before = i;
    }
    // The way from the pits, or a turn at them, may cross it the other way.
    const auto to_left = static_cast<std::size_t>(std::ranges::count(crossings, true, &Crossing::to_left));
    const bool is_first_way = 2 * to_left == crossings.size();
    std::vector<double> times;
    for (const Crossing& crossing : crossings) {
        const bool right_way =
            crossing.to_left == (is_first_way ? crossings.front().to_left : 2 * to_left > crossings.size());
        if (right_way && (times.empty() || crossing.time > times.back() + shortest_lap)) {
            times.push_back(crossing.time);
        }
    }
    return times;
}

namespace {

/// A line through a point, square to a way that is not zero.
StartLine square_to(const Point& way, const Point& through, const Plane& plane) {
    const double length = std::hypot(way.x, way.y);
    const Point half{-half_width * way.y / length, half_width * way.x / length};
    const Point a = through + half;
    const Point b = through - half;
    return {.latitude_a = plane.latitude(a),
            .longitude_a = plane.longitude(a),
            .latitude_b = plane.latitude(b),
            .longitude_b = plane.longitude(b)};
}

}  // namespace

double nearest_to(const Positions& positions, const StartLine& line) {
    const Plane plane(line.latitude_a, line.longitude_a);
    const Point end = plane.of(line.latitude_b, line.longitude_b);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < positions.time.size(); ++i) {
        if (is_known(positions, i)) {
            const Point here = plane.of(positions.latitude[i], positions.longitude[i]);
            const double place = (here.x * end.x + here.y * end.y) / (end.x * end.x + end.y * end.y);
            const Point away = here - std::clamp(place, 0.0, 1.0) * end;
            nearest = std::min(nearest, std::hypot(away.x, away.y));
        }
    }
    return nearest;
}

StartLine line_across(const Positions& positions, const StartLine& line) {
    constexpr double along_it = 0.866;  // cosine of 30 degrees
    constexpr double least_way = 0.5;   // m between samples of a car that moves
    const Plane plane(line.latitude_a, line.longitude_a);
    const Point end = plane.of(line.latitude_b, line.longitude_b);
    const Point middle = 0.5 * end;
    double nearest = std::numeric_limits<double>::infinity();
    Point way;
    std::optional<Point> before;
    for (std::size_t i = 0; i < positions.time.size(); ++i) {
        if (!is_known(positions, i)) {
            continue;
        }
        const Point here = plane.of(positions.latitude[i], positions.longitude[i]);
        if (before) {
            const Point step = here - *before;
            const Point to_middle = 0.5 * (here + *before) - middle;
            const double distance = std::hypot(to_middle.x, to_middle.y);
            if (std::hypot(step.x, step.y) > least_way && distance < nearest) {
                nearest = distance;
                way = step;
            }
        }
        before = here;
    }
    const double length = std::hypot(end.x, end.y) * std::hypot(way.x, way.y);
    const bool is_along = length > 0.0 && std::abs(end.x * way.x + end.y * way.y) > along_it * length;
    return is_along && nearest < half_width ? square_to(way, middle, plane) : line;
}

std::optional<StartLine> find_start_line(const Positions& positions) {
    constexpr std::size_t tried = 200;  // places, evenly over the recording
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < positions.time.size(); ++i) {
        if (is_known(positions, i)) {
            known.push_back(i);
        }
    }
    if (known.size() < 20) {
        return std::nullopt;
    }
    std::optional<StartLine> best;
    std::size_t most = 1;  // crossings; one is no lap
    double fastest = 0.0;
    const std::size_t step = std::max<std::size_t>(known.size() / tried, 1);
    for (std::size_t k = step; k + step < known.size(); k += step) {
        const std::size_t i = known[k - 1];
        const std::size_t j = known[k + 1];
        const Plane plane(positions.latitude[known[k]], positions.longitude[known[k]]);
        const Point way = plane.of(positions.latitude[j], positions.longitude[j]) -
                          plane.of(positions.latitude[i], positions.longitude[i]);
        const double length = std::hypot(way.x, way.y);
        const double speed = length / (positions.time[j] - positions.time[i]);
        if (!(speed > 3.0)) {  // m/s; a standing car has no direction
            continue;
        }
        const StartLine line = square_to(way, {}, plane);
        const std::size_t count = crossings_of(positions, line).size();
        if (count > most || (count == most && best && speed > fastest)) {
            most = count;
            fastest = speed;
            best = line;
        }
    }
    return best;
}

}  // namespace tiretherm::input
