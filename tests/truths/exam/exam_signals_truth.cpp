// SPDX-License-Identifier: BSD-3-Clause
// Draws unknown heat sources with the signals that they follow, and columns unrelated to heat.

#include "exam/exam_signals_truth.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hidden_effects {

namespace {

/// What the source follows at a sample of a run.
double followed(const HiddenSource& source, const RigProgramme& p, std::size_t run, std::size_t i) {
    if (source.signals.empty()) {
        return run == source.run && p.time[i] >= source.from && p.time[i] <= source.to ? 1.0 : 0.0;
    }
    double value = 1.0;
    for (const std::string& signal : source.signals) {
        value *= signal == "throttle" || signal == "lamp" ? p.throttle[i]
                 : signal == "time"                       ? p.time[i]
                 : signal == "speed"                      ? p.speed[i]
                 : signal == "vertical_load"              ? p.vertical_load[i]
                                                          : std::abs(p.slip_angle[i]);
    }
    return value;
}

Column risen(const Programme& programme, Random& random) {
    const double rise = random.uniform(20.0, 60.0);
    const double time_constant = random.uniform(150.0, 1500.0);
    Column column{"gearbox_temperature [degC]", 1, {}};
    for (const double t : programme.time) {
        column.value.push_back(programme.air_temperature.front() - 273.15 +
                               rise * (1.0 - std::exp(-t / time_constant)) + 0.2 * random.normal());
    }
    return column;
}

Column switched(const Programme& programme, Random& random) {
    Column column{"pump [-]", 0, {}};
    double next = 0.0;
    double state = random.uniform() < 0.5 ? 0.0 : 1.0;
    for (const double t : programme.time) {
        if (t >= next) {
            state = 1.0 - state;
            next = t + random.uniform(60.0, 400.0);
        }
        column.value.push_back(state);
    }
    return column;
}

Column wandering(const Programme& programme, Random& random) {
    Column column{"humidity [%]", 2, {}};
    double value = random.uniform(40.0, 60.0);
    for (std::size_t i = 0; i < programme.time.size(); ++i) {
        value += 0.1 * random.normal();
        column.value.push_back(value);
    }
    return column;
}

/// Wheel revolutions, half the load, or the angle at the steering wheel.
Column proportional(const Programme& programme, int which) {
    const auto scaled = [](std::vector<double> x, double factor) {
        std::transform(x.begin(), x.end(), x.begin(), [&](double value) { return factor * value; });
        return x;
    };
    if (which == 0) {
        return {"wheel_revolutions [1/min]", 1, scaled(programme.speed, 60.0 / (2.0 * std::numbers::pi * 0.33))};
    }
    if (which == 1) {
        return {"hub_force [N]", 0, scaled(programme.vertical_load, 0.5)};
    }
    return {"steering_wheel [deg]", 2, scaled(programme.slip_angle, 15.0 * 180.0 / std::numbers::pi)};
}

}  // namespace

std::vector<RigProgramme> driven_by(const HiddenSource& source, std::vector<RigProgramme> logged) {
    double largest = 0.0;
    for (std::size_t run = 0; run < logged.size(); ++run) {
        std::vector<double> signal;
        for (std::size_t i = 0; i < logged[run].time.size(); ++i) {
            signal.push_back(followed(source, logged[run], run, i));
            largest = std::max(largest, std::abs(signal.back()));
        }
        logged[run].throttle = signal;
    }
    for (RigProgramme& programme : logged) {
        for (double& value : programme.throttle) {
            value /= largest > 0.0 ? largest : 1.0;
        }
    }
    return logged;
}

HiddenSource draw_source(const Rig& rig, Kind kind, std::size_t n_runs, Random& random) {
    const RigSource& offered =
        rig.sources[static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(rig.sources.size())))];
    HiddenSource source{.id = offered.id, .place = offered.place, .or_at = offered.or_at, .signals = {offered.signal}};
    if (kind == Kind::unknown) {
        return source;
    }
    static const std::vector<std::vector<std::string>> combinations{
        {}, {"slip_angle", "speed"}, {"slip_angle"}, {"vertical_load", "vertical_load"}, {"throttle", "speed"}};
    // Every second one is a time window.
    const double which =
        random.uniform(-static_cast<double>(combinations.size()), static_cast<double>(combinations.size()));
    source.signals = combinations[static_cast<std::size_t>(std::max(0.0, which))];
    if (source.signals.empty()) {
        source.run = static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(n_runs)));
        source.from = std::round(random.uniform(120.0, 1900.0));
        source.to = source.from + std::round(random.uniform(200.0, 400.0));
    }
    return source;
}

void add_decoys(std::vector<std::vector<Column>>& logs, const std::vector<RigProgramme>& programmes, Random& random) {
    const bool is_proportional = random.uniform() < 0.4;
    const int which = static_cast<int>(random.uniform(0.0, 3.0));
    for (std::size_t run = 0; run < logs.size(); ++run) {
        if (is_proportional) {
            logs[run].push_back(proportional(programmes[run], which));
            continue;
        }
        logs[run].push_back(risen(programmes[run], random));
        logs[run].push_back(switched(programmes[run], random));
        logs[run].push_back(wandering(programmes[run], random));
    }
}

}  // namespace hidden_effects
