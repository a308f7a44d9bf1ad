// SPDX-License-Identifier: BSD-3-Clause
// Collects the regressors of an experiment and evaluates them at a sample: time, inputs, slip power, simulated rise and
// unused log columns.

#include "diagnosis/compare/comparison_regressors.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "physics/celsius.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double absent = std::numeric_limits<double>::quiet_NaN();

bool any_run_gives(const input::Experiment& experiment, std::string_view signal) {
    return std::any_of(experiment.runs.begin(), experiment.runs.end(), [&](const input::MeasuredRun& run) {
        return run.problem.input_signals.gives(*physics::find_signal(signal));
    });
}

double slip_power(const SampleContext& moment) {
    const physics::Inputs& u = moment.inputs;
    return std::abs(u.lateral_force * u.speed * std::tan(u.slip_angle)) +
           std::abs(u.longitudinal_force * u.speed * u.slip_ratio);
}

/// A column of the log that may be missing in some runs.
Regressor unused(const input::Experiment& experiment, const std::string& name, const std::string& unit) {
    std::vector<solver::SharedSamples> of_runs;
    for (const input::MeasuredRun& run : experiment.runs) {
        const auto found = std::ranges::find(run.unused, name, &input::UnusedSignal::name);
        of_runs.push_back(found == run.unused.end() ? solver::SharedSamples{} : found->value);
    }
    return {.name = name, .unit = unit, .column = std::move(of_runs)};
}

}  // namespace

std::vector<Regressor> regressors_of(const input::Experiment& experiment) {
    std::vector<Regressor> regressors;
    regressors.push_back({.name = "time since start", .unit = "s", .value = [](const SampleContext& moment) {
                              return moment.run.time[moment.sample] - moment.run.problem.settings.start;
                          }});
    const auto add = [&](const char* signal, const char* name, const char* unit, auto value) {
        if (any_run_gives(experiment, signal)) {
            regressors.push_back({.name = name, .unit = unit, .value = value});
        }
    };
    add("speed", "speed", "km/h", [](const SampleContext& m) { return 3.6 * m.inputs.speed; });
    add("vertical_load", "vertical load", "N", [](const SampleContext& m) { return m.inputs.vertical_load; });
    if (any_run_gives(experiment, "lateral_force") || any_run_gives(experiment, "longitudinal_force")) {
        regressors.push_back({.name = "slip power", .unit = "W", .value = slip_power});
    }
    add("camber", "camber", "deg", [](const SampleContext& m) { return m.inputs.camber * 45.0 / std::atan(1.0); });
    add("inflation_pressure", "inflation pressure", "kPa",
        [](const SampleContext& m) { return 1e-3 * m.inputs.inflation_pressure; });
    add("laser_power", "laser power", "W", [](const SampleContext& m) { return m.inputs.laser_power; });
    add("wet", "wet", "-", [](const SampleContext& m) { return m.inputs.wet; });
    add("air_temperature", "air temperature", "degC",
        [](const SampleContext& m) { return celsius(m.inputs.air_temperature); });
    add("road_temperature", "road temperature", "degC",
        [](const SampleContext& m) { return celsius(m.inputs.road_temperature); });
    add("air_temperature", "simulated rise over air", "K",
        [](const SampleContext& m) { return m.is_temperature ? m.simulated - m.inputs.air_temperature : absent; });
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const input::UnusedSignal& signal : run.unused) {
            const bool known = std::any_of(regressors.begin(), regressors.end(),
                                           [&](const Regressor& r) { return r.name == signal.name; });
            const bool is_reading = signal.kind == input::ColumnKind::temperature_of_tire;  // no cause of another
            if (!known && !is_reading) {
                regressors.push_back(unused(experiment, signal.name, signal.unit));
            }
        }
    }
    return regressors;
}

void add_values(const std::vector<Regressor>& regressors, const SampleContext& moment,
                std::vector<std::vector<double>>& into) {
    for (std::size_t r = 0; r < regressors.size(); ++r) {
        if (regressors[r].value) {
            into[r].push_back(regressors[r].value(moment));
        }
    }
}

void add_columns(const std::vector<Regressor>& regressors, std::size_t run, std::span<const std::size_t> samples,
                 std::vector<std::vector<double>>& into) {
    for (std::size_t r = 0; r < regressors.size(); ++r) {
        if (!regressors[r].value) {
            const solver::SharedSamples& column = regressors[r].column[run];
            std::ranges::transform(samples, std::back_inserter(into[r]),
                                   [&](std::size_t i) { return column.empty() ? absent : column[i]; });
        }
    }
}

}  // namespace tiretherm::diagnosis
