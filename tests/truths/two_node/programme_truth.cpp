// SPDX-License-Identifier: BSD-3-Clause
// Draws holds of speed, load and slip angle with ramps between them, and a side force that saturates.

#include "two_node/programme_truth.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/random_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

constexpr double duration = 2400.0;
constexpr double ramp = 4.0;

struct Hold {
    double speed = 0.0;  ///< m/s
    double load = 0.0;   ///< N
    double slip = 0.0;   ///< rad
};

/// Signals at one moment, straight from one hold to the next.
Hold between(const Hold& a, const Hold& b, double share) {
    return {.speed = a.speed + share * (b.speed - a.speed),
            .load = a.load + share * (b.load - a.load),
            .slip = a.slip + share * (b.slip - a.slip)};
}

double rounded(double x, double unit) { return std::round(x / unit) * unit; }

/// A brush that saturates smoothly: 60 kN/rad at first, 1.05 Fz at most, against the slip.
double lateral_force(const Hold& hold) {
    const double most = 1.05 * hold.load;
    return most > 0.0 ? -most * std::tanh(60e3 * hold.slip / most) : 0.0;
}

/// Temperatures of a day, K.
struct Day {
    double air = 0.0;
    double road = 0.0;
};

Day draw_day(Random& random) {
    const double air = std::round(random.uniform(150.0, 300.0)) / 10.0 + celsius;
    return {.air = air, .road = air + std::round(random.uniform(0.0, 100.0)) / 10.0};
}

void append(Programme& programme, double time, const Hold& hold, const Day& day) {
    programme.time.push_back(time);
    programme.speed.push_back(rounded(hold.speed * 3.6, 0.01) / 3.6);
    programme.vertical_load.push_back(rounded(hold.load, 0.1));
    programme.slip_angle.push_back(rounded(hold.slip / degree, 1e-4) * degree);
    programme.lateral_force.push_back(rounded(lateral_force(hold), 0.1));
    programme.air_temperature.push_back(day.air);
    programme.road_temperature.push_back(day.road);
}

/// Wanders between 0 and 1: straight between values drawn for moments half a minute to two minutes apart.
void draw_throttle(Programme& programme, Random& random) {
    double from_time = 0.0;
    double from = random.uniform();
    double to_time = random.uniform(30.0, 120.0);
    double to = random.uniform();
    for (const double t : programme.time) {
        while (t > to_time) {
            from_time = to_time;
            from = to;
            to_time += random.uniform(30.0, 120.0);
            to = random.uniform();
        }
        programme.throttle.push_back(rounded(from + (to - from) * (t - from_time) / (to_time - from_time), 0.001));
    }
}

Hold draw_hold(Random& random) {
    const double kind = random.uniform();
    if (kind < 0.06) {
        return {.load = 200.0};  // at rest, hanging on its own weight
    }
    if (kind < 0.16) {
        return {.speed = 50.0 / 3.6, .load = 200.0};  // coasting: no source, forced convection
    }
    Hold hold{.speed = random.uniform(30.0, 190.0) / 3.6, .load = random.uniform(1500.0, 7000.0)};
    if (kind > 0.70) {
        hold.slip = (random.uniform() < 0.5 ? -1.0 : 1.0) * random.uniform(0.5, 3.0) * degree;
    }
    return hold;
}

}  // namespace

Programme draw_programme(std::uint64_t seed, double interval) {
    Random random(seed);
    const Day day = draw_day(random);
    Programme programme;
    Hold from;
    Hold to;
    double change = 0.0;  // when the ramp to `to` begins
    double next = 60.0;
    for (double t = 0.0; t <= duration; t += interval) {
        if (t >= next) {
            from = to;
            to = draw_hold(random);
            change = next;
            next += to.slip != 0.0 ? random.uniform(60.0, 180.0) : random.uniform(80.0, 420.0);
            next = std::round(next / interval) * interval;
        }
        append(programme, t, between(from, to, std::min(1.0, (t - change) / ramp)), day);
    }
    draw_throttle(programme, random);
    return programme;
}

Programme drive_programme(const Drive& drive, std::uint64_t seed) {
    Random random(seed);
    const Day day = draw_day(random);
    Programme programme;
    for (std::size_t i = 0; i < drive.time.size(); ++i) {
        append(programme, drive.time[i],
               {.speed = drive.speed[i], .load = drive.vertical_load[i], .slip = drive.slip_angle[i]}, day);
    }
    draw_throttle(programme, random);
    return programme;
}

Programme draw_dull_programme(std::uint64_t seed, double interval) {
    Random random(seed);
    const Day day = draw_day(random);
    const Hold hold{.speed = random.uniform(60.0, 160.0) / 3.6, .load = random.uniform(3000.0, 6000.0)};
    Programme programme;
    for (double t = 0.0; t <= duration; t += interval) {
        append(programme, t, hold, day);
    }
    draw_throttle(programme, random);
    return programme;
}

}  // namespace hidden_effects
