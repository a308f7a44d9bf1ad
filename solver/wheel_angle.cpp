// SPDX-License-Identifier: BSD-3-Clause
// Integrates the rolling speed over R_R by Simpson's rule and finds the moments at which an edge of the contact has moved by a whole sector
// by regula falsi (Illinois).

#include "solver/wheel_angle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/contact/travelling.hpp"

namespace tiretherm::solver {

namespace {

/// By so much a column is seen before and behind an edge of the contact at the moment when it is on it. rad
constexpr double position_tolerance = 1e-8;
constexpr double turn = 2.0 * std::numbers::pi;

class Turning {
public:
    explicit Turning(const Problem& problem)
        : problem_(problem),
          signal_(physics::find_signal("wheel_angle")),
          given_(problem.input_signals.gives(*signal_)),
          pitch_(turn / problem.mesh.sectors) {}

    std::optional<Series> series(std::size_t most) {
        double t = problem_.settings.start;
        double angle = given_ ? at(t, JumpSide::after).wheel_angle : 0.0;
        add(t, angle);
        for (const double knot : knots()) {
            while (t < knot) {
                const auto [time, where] = next(t, angle, knot);
                t = time;
                angle = where;
                if (t < knot && !problem_.mesh.is_ring()) {
                    const bool backwards = physics::rolling_speed(at(t, JumpSide::before)) < 0.0;
                    const double before = backwards ? position_tolerance : -position_tolerance;
                    add(t, angle + before);
                    add(t, angle - before);
                } else {
                    add(t, angle);
                }
                if (time_.size() > most) {
                    return std::nullopt;
                }
            }
        }
        return Series{.signal = signal_, .time = std::move(time_), .value = std::move(value_), .logged = false};
    }

private:
    struct Point {
        double time = 0.0;
        double angle = 0.0;
    };

    [[nodiscard]] physics::Inputs at(double t, JumpSide side) const { return problem_.input_signals.at(t, side); }

    [[nodiscard]] double rate(const physics::Inputs& in) const {
        return physics::rolling_speed(in) / problem_.tire.rolling_radius(in);
    }

    /// Where the inputs bend: between two of them its inputs are straight.
    [[nodiscard]] std::vector<double> knots() const {
        const Settings& settings = problem_.settings;
        std::vector<double> all;
        std::ranges::set_union(problem_.input_signals.stops(), problem_.input_signals.samples(),
                               std::back_inserter(all));
        std::erase_if(all, [&](double t) { return t <= settings.start || t >= settings.end; });
        all.push_back(settings.end);
        return all;
    }

    /// Simpson's rule over a piece in which speed and load are straight.
    [[nodiscard]] double angle_at(double t, const Point& from) const {
        if (given_) {
            return at(t, JumpSide::before).wheel_angle;
        }
        const double middle = rate(at(0.5 * (from.time + t), JumpSide::before));
        return from.angle + (t - from.time) / 6.0 *
                                (rate(at(from.time, JumpSide::after)) + 4.0 * middle + rate(at(t, JumpSide::before)));
    }

    /// How far the contact's two edges have come, in pitches.
    [[nodiscard]] std::array<double, 2> edges(double angle, const physics::Inputs& in) const {
        const physics::TravellingContact contact(problem_.tire, in);
        const double direction = physics::rolling_speed(in) < 0.0 ? -1.0 : 1.0;
        const double travelled = direction * (angle - std::numbers::pi);
        return {(travelled + 0.5 * contact.length()) / pitch_, (travelled - 0.5 * contact.length()) / pitch_};
    }

    /// The next moment at which an edge has come a whole number of pitches, no later than the knot.
    [[nodiscard]] Point next(double t, double angle, double knot) const {
        const Point from{.time = t, .angle = angle};
        const std::array<double, 2> begin = edges(angle, at(t, JumpSide::after));
        Point found{.time = knot, .angle = angle_at(knot, from)};
        for (const std::size_t edge : {0U, 1U}) {
            // Just beyond the one that it may be on.
            const double whole = std::floor(begin[edge] + 10.0 * position_tolerance / pitch_) + 1.0;
            const auto left = [&](double moment) {
                return edges(angle_at(moment, from), at(moment, JumpSide::before))[edge] - whole;
            };
            double low = t;
            double high = found.time;
            double at_high = left(high);
            if (at_high < 0.0) {
                continue;
            }
            double at_low = begin[edge] - whole;
            while (high - low > 4.0 * std::numeric_limits<double>::epsilon() * high &&
                   at_high > 1e-2 * position_tolerance) {
                // Regula falsi, whose end that stays counts half (Illinois).
                const double guess = std::clamp(low - at_low * (high - low) / (at_high - at_low), low, high);
                const double value = left(guess);
                if (value < 0.0) {
                    low = guess;
                    at_low = value;
                    at_high *= 0.5;
                } else {
                    high = guess;
                    at_high = value;
                    at_low *= 0.5;
                }
                if (std::abs(value) < 1e-2 * position_tolerance) {
                    high = guess;
                    break;
                }
            }
            found = {.time = high, .angle = angle_at(high, from)};
        }
        return found;
    }

    void add(double t, double angle) {
        time_.push_back(t);
        value_.push_back(angle);
    }

    const Problem& problem_;
    const physics::Signal* signal_;
    bool given_;
    double pitch_;
    std::vector<double> time_{};
    std::vector<double> value_{};
};

}  // namespace

std::optional<Series> wheel_angle(const Problem& problem, std::size_t most) { return Turning(problem).series(most); }

bool has_travelling_effect(const Problem& problem) { return std::ranges::any_of(problem.effects, physics::travels); }

}  // namespace tiretherm::solver
