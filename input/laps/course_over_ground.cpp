// SPDX-License-Identifier: BSD-3-Clause
// Headings turned into angles to the left, or the direction of the straight way between positions a second apart.

#include "input/laps/course_over_ground.hpp"

#include <cmath>
#include <numbers>

#include "input/laps/file_laps.hpp"
#include "physics/vehicle/local_mean.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double way = 1.0;  ///< s, over which positions give a direction

/// Which samples are new ones: their value differs, or as long has passed as the receiver mostly takes.
/// @param pace out, s, the median time between two different values
template <typename Same>
std::vector<std::size_t> new_samples(const std::vector<double>& time, Same same, double& pace) {
    std::vector<double> steps;
    std::size_t last = 0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (!same(i, last)) {
            steps.push_back(time[i] - time[last]);
            last = i;
        }
    }
    std::vector<std::size_t> kept;
    if (steps.empty()) {
        return kept;
    }
    pace = solver::median(std::move(steps));
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (kept.empty() ||
            (time[i] > time[kept.back()] && (!same(i, kept.back()) || time[i] - time[kept.back()] >= pace))) {
            kept.push_back(i);
        }
    }
    return kept;
}

CourseOverGround by_heading(const WrittenHeading& heading) {
    CourseOverGround found{.source = heading.column};
    std::vector<double> time;
    std::vector<double> value;
    for (std::size_t i = 0; i < heading.time.size(); ++i) {
        if (std::isfinite(heading.degrees[i])) {
            time.push_back(heading.time[i]);
            value.push_back(-degree * heading.degrees[i]);
        }
    }
    for (const std::size_t i : new_samples(
             time, [&](std::size_t a, std::size_t b) { return value[a] == value[b]; }, found.pace)) {
        found.course.time.push_back(time[i]);
        found.course.value.push_back(value[i]);
    }
    return found;
}

CourseOverGround by_positions(const Positions& positions) {
    CourseOverGround found{.source = std::string(positions_as_source)};
    std::vector<double> time;
    std::vector<double> east;
    std::vector<double> north;
    for (std::size_t i = 0; i < positions.time.size(); ++i) {
        // Before it knows where it is a receiver writes 0, 0.
        const bool known = std::isfinite(positions.latitude[i]) && std::isfinite(positions.longitude[i]) &&
                           (positions.latitude[i] != 0.0 || positions.longitude[i] != 0.0);
        if (known) {
            time.push_back(positions.time[i]);
            north.push_back(positions.latitude[i]);
            east.push_back(positions.longitude[i] * std::cos(degree * (north.empty() ? 0.0 : north.front())));
        }
    }
    const std::vector<std::size_t> kept = new_samples(
        time, [&](std::size_t a, std::size_t b) { return east[a] == east[b] && north[a] == north[b]; }, found.pace);
    const auto of = [&](const std::vector<double>& all) {
        std::vector<double> chosen;
        std::ranges::transform(kept, std::back_inserter(chosen), [&](std::size_t i) { return all[i]; });
        return chosen;
    };
    const std::vector<double> moments = of(time);
    const std::vector<double> to_east = physics::local_slope(moments, of(east), found.window(way));
    const std::vector<double> to_north = physics::local_slope(moments, of(north), found.window(way));
    for (std::size_t i = 0; i < moments.size(); ++i) {
        if (to_east[i] != 0.0 || to_north[i] != 0.0) {
            found.course.time.push_back(moments[i]);
            found.course.value.push_back(std::atan2(to_north[i], to_east[i]));
        }
    }
    return found;
}

/// Whether a heading is counted to the left, as some devices have it, by the positions of the same log: the correlation of how
/// far both turn from one position to the next. What a receiver makes up while the car stands turns further than a car.
bool goes_against(const CourseOverGround& heading, const CourseOverGround& places) {
    constexpr double sure = 0.5;
    constexpr double furthest = 0.5;  // rad
    const auto turned = [](double from, double to) { return std::remainder(to - from, 2.0 * std::numbers::pi); };
    const auto heading_at = [&](double time) {
        const auto after = std::ranges::lower_bound(heading.course.time, time) - heading.course.time.begin();
        return heading.course.value[std::min(static_cast<std::size_t>(after), heading.course.value.size() - 1)];
    };
    double products = 0.0;
    double of_places = 0.0;
    double of_heading = 0.0;
    for (std::size_t i = 1; i < places.course.time.size(); ++i) {
        const double place = turned(places.course.value[i - 1], places.course.value[i]);
        const double written = turned(heading_at(places.course.time[i - 1]), heading_at(places.course.time[i]));
        if (std::max(std::abs(place), std::abs(written)) < furthest) {
            products += place * written;
            of_places += place * place;
            of_heading += written * written;
        }
    }
    return products < -sure * std::sqrt(of_places * of_heading);
}

}  // namespace

solver::SignalHistory unwrapped(solver::SignalHistory course) {
    for (std::size_t i = 1; i < course.value.size(); ++i) {
        const double before = course.value[i - 1];
        course.value[i] = before + std::remainder(course.value[i] - before, 2.0 * std::numbers::pi);
    }
    return course;
}

CourseOverGround course_over_ground(const DataFile& file, const std::vector<double>& time, const InputErrors& errors) {
    const auto positions = read_positions(file, time, errors);
    CourseOverGround by_places = positions ? by_positions(*positions) : CourseOverGround{};
    for (const WrittenHeading& heading : read_headings(file, time, errors)) {
        CourseOverGround found = by_heading(heading);
        if (found.course.time.size() > 1 && !goes_against(found, by_places)) {
            return found;
        }
    }
    return by_places;
}

}  // namespace tiretherm::input
