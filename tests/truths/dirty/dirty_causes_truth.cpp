// SPDX-License-Identifier: BSD-3-Clause
// Draws the sizes of causes and says how each is taken out again.

#include "dirty/dirty_causes_truth.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hidden_effects {

namespace {

using World = DirtyWorld;

/// A cause of the tire: one number that is set, and its neutral value.
void add_tire(DirtySet& set, const std::string& id, const std::string& key, double DirtyTire::*number, double value) {
    const double neutral = set.world.tire.*number;
    set.world.tire.*number = value;
    set.causes.push_back({.id = id,
                          .channel = {},
                          .parameters = {{key, value}},
                          .accepted = {},
                          .remove = [number, neutral](World& world) { world.tire.*number = neutral; }});
}

void add_input(DirtySet& set, const std::string& id, const std::string& key, double DirtyInputs::*number, double value,
               bool timing) {
    const double neutral = set.world.inputs.*number;
    set.world.inputs.*number = value;
    set.causes.push_back({.id = id,
                          .channel = {},
                          .parameters = {{key, value}},
                          .is_timing = timing,
                          .accepted = {},
                          .remove = [number, neutral](World& world) { world.inputs.*number = neutral; }});
}

/// A cause of sensors: of all infrared ones, or of one.
void add_sensor(DirtySet& set, DirtyCause cause, double DirtySensor::*number, double value,
                const std::vector<std::size_t>& which) {
    const double neutral = DirtySensor{}.*number;
    for (const std::size_t i : which) {
        set.world.sensors[i].*number = value;
    }
    cause.channel = which.size() > 1 ? "infrared" : set.world.sensors[which.front()].name;
    cause.remove = [which, number, neutral](World& world) {
        for (const std::size_t i : which) {
            world.sensors[i].*number = neutral;
        }
    };
    set.causes.push_back(std::move(cause));
}

std::vector<std::size_t> infrared(const DirtySet& set) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < set.world.sensors.size(); ++i) {
        if (set.world.sensors[i].is_infrared()) {
            which.push_back(i);
        }
    }
    return which;
}

bool has(const DirtySet& set, const std::string& id) {
    return std::ranges::any_of(set.causes, [&](const DirtyCause& cause) { return cause.id == id; });
}

double of_either_sign(Random& random, double size) { return random.uniform() < 0.5 ? -size : size; }

void add_physical(DirtySet& set, const std::string& word, double s, Random& random) {
    if (word == "sidewall_convection") {
        add_tire(set, word, "conductance", &DirtyTire::sidewall, 12.0 * s);
    } else if (word == "radiation") {
        add_tire(set, word, "emissivity", &DirtyTire::emissivity, 0.4 + 0.55 * s);
    } else if (word == "cornering_loss") {
        add_tire(set, word, "coefficient", &DirtyTire::cornering, 5e-6 * s);
    } else if (word == "load_exponent_of_loss") {
        add_tire(set, word, "exponent", &DirtyTire::load_exponent, of_either_sign(random, 0.4 * s));
    } else if (word == "loss_tangent_slope") {
        add_tire(set, word, "slope", &DirtyTire::loss_slope, of_either_sign(random, 0.01 * s));
    } else if (word == "convection_exponent") {
        add_tire(set, word, "exponent", &DirtyTire::film_exponent, 0.571 + of_either_sign(random, 0.25 * s));
    } else if (word == "partition_speed") {
        add_tire(set, word, "slope", &DirtyTire::partition_slope, -0.2 * s);
    } else if (word == "resolved_contact") {
        add_tire(set, word, "scale", &DirtyTire::contact, 0.7 * s);
        set.causes.back().accepted = {"travelling_contact", "road_contact"};
    } else if (word == "layer_conductivity") {
        add_tire(set, word, "scale", &DirtyTire::carcass_conductivity, 1.0 + of_either_sign(random, 0.35 * s));
    } else if (word == "shoulder_asymmetry") {
        add_tire(set, word, "share", &DirtyTire::asymmetry, of_either_sign(random, 0.25 * s));
        set.causes.back().in_catalogue = false;
        set.causes.back().accepted = {"camber_asymmetry"};
    } else if (word == "standing_wave") {
        set.world.tire.wave = 4e-4 * s;
        set.world.tire.critical = random.uniform(110.0, 150.0);
        set.causes.push_back(
            {.id = word,
             .channel = {},
             .parameters = {{"gain", set.world.tire.wave}, {"critical_speed", set.world.tire.critical}},
             .accepted = {},
             .remove = [](World& world) { world.tire.wave = 0.0; }});
    } else if (word == "inner_gas") {
        set.world.tire.liner = 14.0 * s;
        set.world.tire.gas_rim = 7.0 * s;
        set.causes.push_back({.id = word,
                              .channel = {},
                              .parameters = {{"liner", 14.0 * s}, {"rim", 7.0 * s}},
                              .accepted = {},
                              .remove = [](World& world) { world.tire.liner = world.tire.gas_rim = 0.0; }});
    } else if (word == "brake_heat") {
        set.world.tire.bead = 6.0 * s;
        set.world.tire.brake_share = random.uniform(0.02, 0.12);
        set.causes.push_back({.id = word,
                              .channel = {},
                              .parameters = {{"bead", 6.0 * s}},
                              .in_catalogue = false,
                              .accepted = {"rim_conduction", "unknown"},
                              .remove = [](World& world) { world.tire.bead = world.tire.brake_share = 0.0; }});
    }
}

void add_wrong_input(DirtySet& set, const std::string& word, double s, Random& random) {
    if (word == "load_input_gain") {
        add_input(set, word, "gain", &DirtyInputs::load_gain, 1.0 + of_either_sign(random, 0.05 * s), false);
    } else if (word == "speed_input_gain") {
        add_input(set, word, "gain", &DirtyInputs::speed_gain, 1.0 + of_either_sign(random, 0.03 * s), false);
    } else if (word == "slip_input_gain") {
        add_input(set, word, "gain", &DirtyInputs::slip_gain, 1.0 + of_either_sign(random, 0.1 + 0.2 * s), false);
    } else if (word == "late_load") {
        add_input(set, "input_delay", "vertical_load", &DirtyInputs::load_delay, 0.1 + 0.9 * s, true);
    } else if (word == "late_slip") {
        add_input(set, "input_delay", "slip_angle", &DirtyInputs::slip_delay, 0.1 + 0.9 * s, true);
    } else if (word == "road_temperature") {
        set.world.inputs.road_is_measured = false;
        set.world.inputs.road_over_air = of_either_sign(random, 10.0 * s) + 7.0;
        set.causes.push_back({.id = word,
                              .channel = {},
                              .parameters = {},
                              .in_catalogue = false,
                              .accepted = {"road_temperature_drift"},
                              .remove = [](World& world) { world.inputs.road_is_measured = true; }});
    }
}

void add_imperfect_sensor(DirtySet& set, const std::string& word, double s, Random& random) {
    const std::vector<std::size_t> cameras = infrared(set);
    const auto one = [&](std::size_t from) {
        return from +
               static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(set.world.sensors.size() - from)));
    };
    DirtyCause cause{.id = word, .channel = {}, .parameters = {}, .accepted = {}, .remove = {}};
    if (word == "infrared_lag") {
        cause.id = "sensor_lag";
        cause.is_timing = true;
        cause.parameters = {{"tau", 0.2 + 0.8 * s}};
        add_sensor(set, cause, &DirtySensor::tau, 0.2 + 0.8 * s, cameras);
    } else if (word == "probe_lag") {
        cause.id = "sensor_lag";
        cause.parameters = {{"tau", 1.0 + 7.0 * s}};
        add_sensor(set, cause, &DirtySensor::tau, 1.0 + 7.0 * s, {one(cameras.size())});
    } else if (word == "clock_delay") {
        cause.is_timing = true;
        cause.parameters = {{"delay", 0.2 + 0.8 * s}};
        add_sensor(set, cause, &DirtySensor::delay, 0.2 + 0.8 * s, cameras);
    } else if (word == "camera_emissivity") {
        cause.parameters = {{"emissivity", 0.97 - 0.09 * s}};
        add_sensor(set, cause, &DirtySensor::emissivity, 0.97 - 0.09 * s, cameras);
    } else if (word == "sensor_offset") {
        const double kelvin = of_either_sign(random, 0.3 + 3.0 * s);
        cause.parameters = {{"kelvin", kelvin}};
        add_sensor(set, cause, &DirtySensor::offset, kelvin, {one(0)});
    } else {
        cause.in_catalogue = false;
        if (word == "quantised") {
            const double steps[] = {0.1, 0.2, 0.5, 1.0};
            const double resolution = steps[std::min(3, static_cast<int>(4.0 * s))];
            cause.parameters = {{"resolution", resolution}};
            add_sensor(set, cause, &DirtySensor::resolution, resolution, cameras);
        } else if (word == "upsampled") {
            const double interval = set.interval * (s > 0.5 ? 5.0 : 2.0);
            cause.parameters = {{"interval", interval}};
            add_sensor(set, cause, &DirtySensor::interval, interval, cameras);
        } else if (word == "clipped") {
            add_sensor(set, cause, &DirtySensor::clip, 0.0, cameras);  // the level follows from the readings, later
        } else if (word == "stuck") {
            add_sensor(set, cause, &DirtySensor::stuck_from, random.uniform() < 0.5 ? 0.0 : 120.0, {one(1)});
        }
    }
}

const std::vector<std::string> physical{
    "sidewall_convection", "inner_gas",       "brake_heat",         "radiation",
    "cornering_loss",      "standing_wave",   "loss_tangent_slope", "load_exponent_of_loss",
    "convection_exponent", "partition_speed", "resolved_contact",   "layer_conductivity",
    "shoulder_asymmetry"};
const std::vector<std::string> of_inputs{"load_input_gain", "speed_input_gain", "slip_input_gain",
                                         "late_load",       "late_slip",        "road_temperature"};
const std::vector<std::string> of_sensors{"infrared_lag",      "probe_lag",     "clock_delay",
                                          "camera_emissivity", "sensor_offset", "quantised",
                                          "upsampled",         "clipped",       "stuck"};

bool is_one_of(const std::vector<std::string>& words, const std::string& word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

const std::vector<std::string>& dirty_cause_words() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> words = physical;
        words.insert(words.end(), of_inputs.begin(), of_inputs.end());
        words.insert(words.end(), of_sensors.begin(), of_sensors.end());
        return words;
    }();
    return all;
}

bool dirty_cause_fits(const DirtySet& set, const std::string& word) {
    const std::size_t cameras = infrared(set).size();
    const std::string id = word == "infrared_lag" || word == "probe_lag" ? "sensor_lag"
                           : word == "late_load" || word == "late_slip"  ? "input_delay"
                                                                         : word;
    if (has(set, id)) {
        return false;
    }
    if (word == "inner_gas") {
        return !set.has_gas_sensor;
    }
    if (word == "probe_lag") {
        return cameras < set.world.sensors.size();
    }
    if (word == "stuck" || word == "sensor_offset") {
        return set.world.sensors.size() > 1;
    }
    if (word == "shoulder_asymmetry") {
        return cameras > 1;
    }
    if (word == "brake_heat") {
        return set.laps;
    }
    return true;
}

void add_dirty_cause(DirtySet& set, const std::string& word, double strength, Random& random) {
    if (is_one_of(physical, word)) {
        add_physical(set, word, strength, random);
    } else if (is_one_of(of_inputs, word)) {
        add_wrong_input(set, word, strength, random);
    } else if (is_one_of(of_sensors, word)) {
        add_imperfect_sensor(set, word, strength, random);
    } else {
        throw std::invalid_argument("no cause is called " + word);
    }
}

}  // namespace hidden_effects
