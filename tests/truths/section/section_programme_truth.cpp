// SPDX-License-Identifier: BSD-3-Clause
// Draws holds of speed, load, camber and slip angle with ramps between them, and a side force that saturates.

#include "section/section_programme_truth.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/random_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

constexpr double duration = 2400.0;
constexpr double ramp = 4.0;

struct Hold {
    double speed = 0.0;   ///< km/h
    double load = 0.0;    ///< N
    double slip = 0.0;    ///< deg
    double camber = 0.0;  ///< deg
};

double rounded(double x, double unit) { return std::round(x / unit) * unit; }

/// The next hold: at rest hanging on its own weight, coasting nearly unloaded, or rolling under load.
Hold draw_hold(Random& random) {
    const double kind = random.uniform();
    if (kind < 0.05) {
        return {.load = 200.0};
    }
    if (kind < 0.15) {
        return {.speed = 50.0, .load = 200.0};
    }
    Hold hold{.speed = random.uniform(40.0, 180.0), .load = random.uniform(2000.0, 7000.0)};
    if (kind > 0.75) {
        hold.slip = (random.uniform() < 0.5 ? -1.0 : 1.0) * random.uniform(0.4, 1.5);
    }
    hold.camber = random.uniform() < 0.3 ? 0.0 : random.uniform(-4.0, 4.0);
    return hold;
}

void append(SectionProgramme& programme, double time, const Hold& a, const Hold& b, double share) {
    const auto line = [share](double from, double to) { return from + share * (to - from); };
    const double load = rounded(line(a.load, b.load), 0.1);
    const double slip = rounded(line(a.slip, b.slip), 1e-4) * degree;
    // A brush that saturates smoothly: 60 kN/rad at first, 1.05 Fz at most, against the slip.
    const double most = 1.05 * load;
    programme.time.push_back(time);
    programme.speed.push_back(rounded(line(a.speed, b.speed), 0.01) / 3.6);
    programme.vertical_load.push_back(load);
    programme.slip_angle.push_back(slip);
    programme.lateral_force.push_back(most > 0.0 ? rounded(-most * std::tanh(60e3 * slip / most), 0.1) : 0.0);
    programme.camber.push_back(rounded(line(a.camber, b.camber), 0.01) * degree);
}

/// Wanders between 0 and 1: straight between values drawn for moments half a minute to two minutes apart.
void draw_throttle(SectionProgramme& programme, Random& random) {
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

}  // namespace

SectionProgramme draw_section_programme(std::uint64_t seed, double interval) {
    Random random(seed);
    const double air = std::round(random.uniform(150.0, 300.0)) / 10.0 + celsius;
    const double road = air + std::round(random.uniform(0.0, 100.0)) / 10.0;
    SectionProgramme programme;
    Hold from;
    Hold to;
    double change = 0.0;  // when the ramp to `to` begins
    double next = 60.0;
    for (double t = 0.0; t <= duration; t += interval) {
        if (t >= next) {
            from = to;
            to = draw_hold(random);
            change = next;
            next += to.slip != 0.0 ? random.uniform(60.0, 180.0) : random.uniform(100.0, 360.0);
            next = std::round(next / interval) * interval;
        }
        append(programme, t, from, to, std::min(1.0, (t - change) / ramp));
        programme.air_temperature.push_back(air);
        programme.road_temperature.push_back(road);
    }
    draw_throttle(programme, random);
    return programme;
}

}  // namespace hidden_effects
