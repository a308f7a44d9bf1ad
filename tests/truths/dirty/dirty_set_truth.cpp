// SPDX-License-Identifier: BSD-3-Clause
// Draws sets of dirty data: base model, sensors, programme, runs and causes.

#include "dirty/dirty_set_truth.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "dirty/dirty_causes_truth.hpp"
#include "numerics/random_truth.hpp"

namespace hidden_effects {

namespace {

int whole(Random& random, int from, int to) {
    return from + std::min(to - from, static_cast<int>(random.uniform() * (to - from + 1)));
}

void draw_sensors(DirtySet& set, Random& random) {
    using Place = DirtySensor::Place;
    constexpr Place places[] = {Place::crown, Place::inside_shoulder, Place::outside_shoulder, Place::crown};
    const int cameras = random.uniform() < 0.5 ? 1 : whole(random, 2, 4);
    const double sigma = random.uniform(0.15, 0.5);
    const double share = random.uniform(0.0, 0.6);
    const auto add = [&](const std::string& name, Place place, double deviation) {
        DirtySensor sensor;
        sensor.name = name;
        sensor.place = place;
        sensor.sigma = deviation;
        sensor.correlated_share = share;
        set.world.sensors.push_back(sensor);
    };
    for (int i = 0; i < cameras; ++i) {
        add(cameras == 1 ? "surface_temperature" : "infrared_" + std::to_string(i + 1), places[i], sigma);
    }
    if (random.uniform() < 0.7) {
        add("bulk_temperature", set.two_node ? Place::bulk : Place::probe, random.uniform(0.1, 0.35));
    }
    if (!set.two_node && random.uniform() < 0.4) {
        add("inner_liner_temperature", Place::liner, random.uniform(0.1, 0.35));
    }
    set.has_gas_sensor = random.uniform() < 0.2;
    if (set.has_gas_sensor) {
        add("gas_temperature", Place::gas, random.uniform(0.1, 0.3));
        // The case has the same gas: it is none of the causes.
        set.world.tire.liner = 9.0;
        set.world.tire.gas_rim = 4.0;
    }
}

/// What the base model has, and what the truth has in its place.
void draw_structure(DirtySet& set, Random& random) {
    const double share = set.style == "dominant" ? 0.12 : 0.25;
    const bool coarse = set.style == "structure" || random.uniform() < share;
    if (set.two_node) {
        set.base_column = dirty_lumps();
        set.world.tire.column = coarse ? dirty_cells_of_lumps() : dirty_lumps();
    } else {
        set.case_layers = coarse ? std::vector<int>{whole(random, 1, 3), whole(random, 1, 2)} : std::vector<int>{16, 7};
        set.world.tire.column = dirty_layers(24, 10, 5.0);
        set.base_column = coarse ? dirty_layers(set.case_layers[0], set.case_layers[1], 1.0) : set.world.tire.column;
    }
    if (coarse) {
        const DirtyColumn base = set.base_column;
        set.causes.push_back({.id = "mesh",
                              .channel = {},
                              .parameters = {},
                              .accepted = {"coarse"},
                              .remove = [base](DirtyWorld& world) { world.tire.column = base; }});
    }
}

void draw_causes(DirtySet& set, Random& random) {
    const std::vector<std::string>& words = dirty_cause_words();
    const auto draw_word = [&] {
        for (;;) {
            const std::string& word =
                words[static_cast<std::size_t>(whole(random, 0, static_cast<int>(words.size()) - 1))];
            if (dirty_cause_fits(set, word)) {
                return word;
            }
        }
    };
    if (set.style == "dominant") {
        const bool timing = set.laps && random.uniform() < 0.6;
        const std::string late[] = {"infrared_lag", "clock_delay", "late_load", "late_slip"};
        add_dirty_cause(set, timing ? late[whole(random, 0, 3)] : draw_word(), random.uniform(0.6, 1.0), random);
        for (int i = whole(random, 0, 2); i > 0; --i) {
            add_dirty_cause(set, draw_word(), random.uniform(0.02, 0.15), random);
        }
    } else if (set.style == "many") {
        for (int i = whole(random, 3, 7); i > 0; --i) {
            add_dirty_cause(set, draw_word(), random.uniform(0.1, 0.9), random);
        }
    }
}

/// Clips the highest 3 % of a sensor's readings.
void place_clipping(DirtySet& set) {
    if (std::ranges::none_of(set.world.sensors, [](const DirtySensor& sensor) { return sensor.clip <= 0.0; })) {
        return;
    }
    const auto courses = dirty_courses(set, set.world, set.n_runs);
    for (std::size_t i = 0; i < set.world.sensors.size(); ++i) {
        if (set.world.sensors[i].clip <= 0.0) {
            std::vector<double> course;
            for (const auto& run : courses) {
                course.insert(course.end(), run[i].begin(), run[i].end());
            }
            std::ranges::sort(course);
            set.world.sensors[i].clip = course[static_cast<std::size_t>(0.97 * static_cast<double>(course.size()))];
        }
    }
}

}  // namespace

DirtyDrive dirty_logged(const DirtyDrive& drive, const DirtyInputs& inputs) {
    DirtyDrive logged = drive;
    for (std::size_t i = 0; i < drive.size(); ++i) {
        const double t = static_cast<double>(i) * dirty_step;
        logged.speed[i] = drive.speed[i] / inputs.speed_gain;
        logged.vertical_load[i] = dirty_value(drive.vertical_load, t - inputs.load_delay) / inputs.load_gain;
        logged.slip_angle[i] = dirty_value(drive.slip_angle, t - inputs.slip_delay) / inputs.slip_gain;
        if (!inputs.road_is_measured) {
            logged.road_temperature[i] = inputs.road_assumed;
        }
    }
    return logged;
}

std::vector<std::vector<std::vector<double>>> dirty_courses(const DirtySet& set, const DirtyWorld& world,
                                                            std::size_t n_runs, bool as_logged) {
    std::vector<std::vector<std::vector<double>>> courses(n_runs);
    for (std::size_t run = 0; run < n_runs; ++run) {
        const DirtyDrive drive = as_logged ? dirty_logged(set.drives[run], world.inputs) : set.drives[run];
        DirtyTire tire = world.tire;
        tire.shift_surface += set.shifts[run].first;
        tire.shift_bulk += set.shifts[run].second;
        const DirtyTrace trace = drive_dirty_tire(tire, drive);
        for (const DirtySensor& sensor : world.sensors) {
            courses[run].push_back(dirty_course(sensor, trace, drive));
        }
    }
    return courses;
}

DirtySet draw_dirty_set(std::uint64_t seed) {
    Random random(seed * 7919 + 17);
    DirtySet set;
    set.seed = seed;
    set.two_node = random.uniform() < 0.6;
    set.laps = random.uniform() < 0.65;
    const double style = random.uniform();
    set.style = style < 0.12 ? "structure" : style < 0.55 ? "dominant" : "many";
    set.wide_list = random.uniform() < 0.3;
    set.loss_is_free = random.uniform() < 0.6;
    constexpr double intervals[] = {0.2, 0.5, 0.5, 0.5, 1.0, 1.0};
    set.interval = intervals[whole(random, 0, 5)];
    set.n_runs = static_cast<std::size_t>(whole(random, 1, 3));
    set.world.tire.lambda_h = 1.0 + 0.07 * random.normal();
    (set.loss_is_free ? set.world.tire.lambda_sel : set.world.tire.lambda_y) = 1.0 + 0.07 * random.normal();
    draw_sensors(set, random);
    draw_structure(set, random);
    draw_causes(set, random);
    const DirtyTrack track = draw_dirty_track(seed * 104729 + 3, set.laps);
    // 5 to 40 minutes at 1 to 5 Hz: the longer the slower, so that a diagnosis takes some ten seconds of the processor.
    const double longest = std::max(6.0, (set.laps ? 20.0 : 40.0) * set.interval / static_cast<double>(set.n_runs));
    for (std::size_t run = 0; run <= set.n_runs; ++run) {
        const double surface = 2.0 * random.normal();
        const double bulk = set.two_node ? 2.0 * random.normal() : surface;
        set.shifts.emplace_back(surface, bulk);
        set.drives.push_back(
            draw_dirty_drive(track, std::round(5.0 * std::pow(longest / 5.0, random.uniform())), seed * 1299709 + run));
    }
    set.world.inputs.road_assumed = set.drives.front().air_temperature.front() + set.world.inputs.road_over_air;
    place_clipping(set);
    measure_dirty_causes(set);
    return set;
}

}  // namespace hidden_effects
