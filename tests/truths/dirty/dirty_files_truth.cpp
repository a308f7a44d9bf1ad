// SPDX-License-Identifier: BSD-3-Clause
// Logs of a set of dirty data with decoy columns, and its answer.

#include <cmath>
#include <fstream>
#include <iomanip>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "dirty/dirty_case_truth.hpp"
#include "numerics/random_truth.hpp"
#include "numerics/table_truth.hpp"
#include "numerics/units_truth.hpp"

namespace hidden_effects {

namespace {

std::vector<double> sampled(const std::vector<double>& signal, double interval, double scale, double shift = 0.0) {
    std::vector<double> out;
    const double end = static_cast<double>(signal.size() - 1) * dirty_step;
    for (std::size_t i = 0; static_cast<double>(i) * interval <= end + 1e-9; ++i) {
        out.push_back(scale * dirty_value(signal, static_cast<double>(i) * interval) + shift);
    }
    return out;
}

std::vector<double> in_celsius(std::vector<double> T) {
    for (double& value : T) {
        value -= celsius;
    }
    return T;
}

std::vector<Column> inputs(const DirtyDrive& logged, double interval, bool road) {
    std::vector<double> times;
    for (std::size_t i = 0; i < sampled(logged.speed, interval, 1.0).size(); ++i) {
        times.push_back(static_cast<double>(i) * interval);
    }
    std::vector<Column> columns{
        {"time [s]", 2, times},
        {"speed [km/h]", 2, sampled(logged.speed, interval, 3.6)},
        {"vertical_load [N]", 1, sampled(logged.vertical_load, interval, 1.0)},
        {"slip_angle [deg]", 4, sampled(logged.slip_angle, interval, 180.0 / std::numbers::pi)},
        {"lateral_force [N]", 1, sampled(logged.lateral_force, interval, 1.0)},
        {"air_temperature [degC]", 2, sampled(logged.air_temperature, interval, 1.0, -celsius)}};
    if (road) {
        columns.push_back({"road_temperature [degC]", 2, sampled(logged.road_temperature, interval, 1.0, -celsius)});
    }
    return columns;
}

/// Columns that no case uses: some follow the driving, some repeat a reading, some are results of another program.
void add_decoys(std::vector<Column>& columns, const DirtySet& set, const DirtyDrive& drive,
                const std::vector<std::vector<double>>& courses, std::uint64_t seed) {
    Random which(set.seed + 11);  // the same columns in all runs
    const double interval = set.interval;
    const auto wanted = [&] { return which.uniform() < 0.6; };
    if (wanted()) {
        columns.push_back({"throttle", 3, sampled(drive.throttle, interval, 1.0)});
    }
    if (wanted() && set.laps) {
        columns.push_back({"brake_pressure [bar]", 1, sampled(drive.brake_power, interval, 5e-4)});
    }
    if (wanted() && set.laps) {
        columns.push_back({"gear", 0, sampled(drive.gear, interval, 1.0)});
        columns.push_back({"lap_distance [m]", 1, sampled(drive.lap_distance, interval, 1.0)});
    }
    if (wanted()) {
        DirtySensor neighbour = set.world.sensors.front();
        neighbour.offset += 1.5;
        columns.push_back(
            {"ir_neighbour [degC]", 2, in_celsius(dirty_log(neighbour, courses.front(), interval, seed + 71))});
    }
    if (wanted()) {
        columns.push_back({"copy_of_" + set.world.sensors.back().name + " [degC]", 1,
                           sampled(courses.back(), interval, 1.0, -celsius)});
    }
    if (wanted()) {
        std::vector<double> power = sampled(drive.speed, interval, 1.0);
        const std::vector<double> load = sampled(drive.vertical_load, interval, 1.0);
        for (std::size_t i = 0; i < power.size(); ++i) {
            power[i] *= 0.011 * load[i];
        }
        columns.push_back({"rolling_power [W]", 1, power});
    }
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    std::ofstream out(file);
    out << text;
    if (!out.flush()) {
        throw std::runtime_error(file.string() + " cannot be written");
    }
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    out += text;
    return out + "\"";
}

std::string object(const std::vector<std::pair<std::string, double>>& numbers) {
    std::ostringstream out;
    out << std::setprecision(8) << "{";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        out << (i > 0 ? ", " : "") << quoted(numbers[i].first) << ": " << numbers[i].second;
    }
    out << "}";
    return out.str();
}

std::string list(const std::vector<std::string>& words) {
    std::string out = "[";
    for (std::size_t i = 0; i < words.size(); ++i) {
        out += (i > 0 ? ", " : "") + quoted(words[i]);
    }
    return out + "]";
}

const char* boolean(bool x) { return x ? "true" : "false"; }

}  // namespace

std::string dirty_answer(const DirtySet& set) {
    std::ostringstream out;
    std::vector<std::string> runs;
    std::vector<std::string> sensors;
    std::vector<std::string> cameras;
    std::vector<std::string> stuck;
    for (std::size_t i = 0; i < set.n_runs; ++i) {
        runs.push_back("run" + std::to_string(i + 1) + ".csv");
    }
    for (const DirtySensor& sensor : set.world.sensors) {
        sensors.push_back(sensor.name);
        if (sensor.is_infrared()) {
            cameras.push_back(sensor.name);
        }
        if (sensor.stuck_from < 1e8) {
            stuck.push_back(sensor.name);
        }
    }
    std::vector<std::pair<std::string, double>> free{{"air_convection.lambda_h", set.world.tire.lambda_h}};
    if (set.loss_is_free) {
        free.emplace_back("strain_energy_loss.tan_delta_a", 2.14e15 * set.world.tire.lambda_sel);
    } else {
        free.emplace_back("sliding_friction.lambda_y", set.world.tire.lambda_y);
    }
    std::vector<std::pair<std::string, double>> sigma;
    for (const DirtySensor& sensor : set.world.sensors) {
        sigma.emplace_back(sensor.name, sensor.sigma);
    }
    out << "{\"seed\": " << set.seed << ", \"base\": " << quoted(set.two_node ? "two_node" : "layers")
        << ", \"style\": " << quoted(set.style) << ", \"programme\": " << quoted(set.laps ? "laps" : "steps")
        << ", \"interval\": " << set.interval << ",\n \"runs\": " << list(runs) << ", \"kept\": \"kept.csv\""
        << ", \"lists_candidates\": " << boolean(set.wide_list) << ",\n \"sensors\": " << list(sensors)
        << ", \"infrared\": " << list(cameras) << ", \"stuck\": " << list(stuck) << ", \"sigma\": " << object(sigma)
        << ",\n \"free\": " << object(free) << ",\n \"causes\": [";
    for (std::size_t i = 0; i < set.causes.size(); ++i) {
        const DirtyCause& cause = set.causes[i];
        out << (i > 0 ? "," : "") << "\n  {\"id\": " << quoted(cause.id)
            << ", \"channel\": " << (cause.channel.empty() ? "null" : quoted(cause.channel))
            << ", \"parameters\": " << object(cause.parameters) << ", \"rms\": " << cause.rms
            << ", \"rms_left\": " << cause.rms_left << ", \"timing\": " << boolean(cause.is_timing)
            << ", \"in_catalogue\": " << boolean(cause.in_catalogue) << ", \"accepted\": " << list(cause.accepted)
            << "}";
    }
    out << "\n ]}\n";
    return out.str();
}

void write_dirty_set(const DirtySet& set, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    write_text(folder / "tire.toml", dirty_tire_table());
    write_text(folder / "case.toml", dirty_case(set, false));
    write_text(folder / "fine.toml", dirty_case(set, true));
    write_text(folder / "answer.json", dirty_answer(set));
    const auto courses = dirty_courses(set, set.world, set.n_runs + 1);
    DirtyWorld perfect = set.world;
    for (DirtySensor& sensor : perfect.sensors) {
        DirtySensor sound;
        sound.name = sensor.name;
        sound.place = sensor.place;
        sensor = sound;
    }
    const auto true_courses = dirty_courses(set, perfect, set.n_runs);
    for (std::size_t run = 0; run <= set.n_runs; ++run) {
        const bool kept = run == set.n_runs;
        const DirtyDrive logged = dirty_logged(set.drives[run], set.world.inputs);
        std::vector<Column> columns = inputs(logged, set.interval, set.world.inputs.road_is_measured);
        const std::uint64_t seed = set.seed * 6151 + 97 * run;
        for (std::size_t i = 0; i < set.world.sensors.size(); ++i) {
            const DirtySensor& sensor = set.world.sensors[i];
            columns.push_back({sensor.name + " [degC]", 3,
                               in_celsius(dirty_log(sensor, courses[run][i], set.interval, seed + i + 1))});
        }
        add_decoys(columns, set, set.drives[run], courses[run], seed);
        write(folder / (kept ? "kept.csv" : "run" + std::to_string(run + 1) + ".csv"), columns);
        if (!kept) {
            std::vector<Column> sound = inputs(set.drives[run], set.interval, true);
            for (std::size_t i = 0; i < perfect.sensors.size(); ++i) {
                sound.push_back({perfect.sensors[i].name + " [degC]", 4,
                                 sampled(true_courses[run][i], set.interval, 1.0, -celsius)});
            }
            write(folder / ("perfect" + std::to_string(run + 1) + ".csv"), sound);
        }
    }
}

}  // namespace hidden_effects
