// SPDX-License-Identifier: BSD-3-Clause
// Simulates the runs of an experiment and puts the simulated values beside the measured samples, single numbers and
// images.

#include "diagnosis/compare/comparison.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "diagnosis/compare/comparison_regressors.hpp"
#include "diagnosis/fit/refinement.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double not_read = std::numeric_limits<double>::quiet_NaN();

/// Every time at which a run is to be read. @returns s, ascending, each once
std::vector<double> times_of(const input::MeasuredRun& run) {
    std::vector<double> times = run.time;
    for (const input::MeasuredNumber& number : run.numbers) {
        times.push_back(number.time);
    }
    for (const input::MeasuredFrames& frames : run.frames) {
        times.insert(times.end(), frames.time.begin(), frames.time.end());
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

std::size_t index_of(const std::vector<double>& times, double time) {
    return static_cast<std::size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
}

/// One run simulated, and what of it was measured put beside.
struct Beside {
    const input::MeasuredRun& run;
    std::size_t index = 0;
    std::vector<double> times;
    solver::Prediction prediction;
    const std::vector<Regressor>& regressors;

    [[nodiscard]] ComparedSeries series(const input::MeasuredSeries& measured) const;
    [[nodiscard]] ComparedNumber number(const input::MeasuredNumber& measured) const;
};

ComparedSeries Beside::series(const input::MeasuredSeries& measured) const {
    ComparedSeries result;
    result.run = index;
    result.corner = run.corner;
    result.regressor.resize(regressors.size());
    const bool is_temperature = run.problem.channels[measured.channel].quantity == solver::Quantity::temperature;
    const bool has_air = run.problem.input_signals.gives(*physics::find_signal("air_temperature"));
    const std::size_t n = run.time.size();
    for (std::vector<double>* column : {&result.time, &result.measured, &result.simulated, &result.surroundings}) {
        column->reserve(n);
    }
    result.phase.reserve(n);
    std::ranges::for_each(result.regressor, [&](std::vector<double>& values) { values.reserve(n); });
    const bool forces = has_forces(run);
    std::vector<std::size_t> known;  // samples
    known.reserve(n);
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (std::isnan(measured.value[i])) {
            continue;
        }
        known.push_back(i);
        const double t = run.time[i];
        while (times[at] < t) {
            ++at;
        }
        const physics::Inputs inputs = run.problem.input_signals.at(t, solver::JumpSide::after);
        const double simulated = prediction.at(at, measured.channel);
        result.time.push_back(t);
        result.measured.push_back(measured.value[i]);
        result.simulated.push_back(simulated);
        result.surroundings.push_back(!is_temperature ? 0.0 : has_air ? inputs.air_temperature : not_read);
        result.phase.push_back(phase_at(run.problem, t, inputs, forces));
        const SampleContext moment{
            .run = run, .sample = i, .inputs = inputs, .simulated = simulated, .is_temperature = is_temperature};
        add_values(regressors, moment, result.regressor);
    }
    add_columns(regressors, index, known, result.regressor);
    return result;
}

ComparedNumber Beside::number(const input::MeasuredNumber& measured) const {
    const solver::Channel& channel = run.problem.channels[measured.channel];
    return {.channel = channel.name,
            .unit = solver::shown_unit(channel.quantity),
            .run = index,
            .time = measured.time,
            .at_end = measured.time == run.problem.settings.end,
            .measured = measured.value,
            .uncertainty = measured.standard_deviation,
            .simulated = prediction.at(index_of(times, measured.time), measured.channel),
            .source = measured.source};
}

/// What goes into the tire of a run up to the end of each step.
RunHeat heat_of(const input::MeasuredRun& run, const solver::Prediction& prediction) {
    RunHeat heat{.run = run.name,
                 .corner = run.corner,
                 .laps = run.laps,
                 .start = run.problem.settings.start,
                 .end = run.problem.settings.end,
                 .friction = friction_energy(run.problem)};
    if (prediction.joules.empty()) {
        return heat;
    }
    for (const physics::ActiveEffect& active : run.problem.effects) {
        heat.heat.names.emplace_back(active.title());
    }
    heat.heat.time = prediction.step_ends;
    heat.heat.time.insert(heat.heat.time.begin(), heat.start);
    heat.heat.joules.assign(heat.heat.names.size(), 0.0);
    std::ranges::transform(prediction.joules, std::back_inserter(heat.heat.joules),
                           [&](double joules) { return run.problem.symmetry * joules; });
    return heat;
}

/// A reading that is not a number would spoil every figure without a word.
solver::Status finite(const input::MeasuredRun& run, const std::vector<double>& times,
                      const solver::Prediction& prediction) {
    for (std::size_t t = 0; t < times.size(); ++t) {
        for (std::size_t c = 0; c < prediction.n_channels; ++c) {
            if (!std::isfinite(prediction.at(t, c))) {
                return {.outcome = solver::Outcome::not_finite,
                        .message = fmt::format("simulated {} at {:.6g} s is not a number", run.problem.channels[c].name,
                                               times[t])};
            }
        }
    }
    return {};
}

}  // namespace

std::vector<double> ComparedSeries::difference() const {
    std::vector<double> result(time.size());
    std::transform(simulated.begin(), simulated.end(), measured.begin(), result.begin(), std::minus<>());
    return result;
}

Comparison compare(const input::Experiment& experiment, const std::string& name, const input::Experiment* finer) {
    using Clock = std::chrono::steady_clock;
    Comparison result;
    result.name = name;
    result.not_driven = input::not_driven(experiment);
    const std::vector<Regressor> regressors = regressors_of(experiment);
    std::vector<std::pair<std::string, std::string>> names;
    for (const Regressor& regressor : regressors) {
        names.emplace_back(regressor.name, regressor.unit);
    }
    std::map<std::size_t, ComparedChannel> channels;  // in the case's order
    for (std::size_t r = 0; r < experiment.runs.size(); ++r) {
        const input::MeasuredRun& run = experiment.runs[r];
        result.extrapolations.add(run.problem);
        result.runs.push_back(run.name);
        result.inputs.push_back(run.problem.input_signals);
        result.laps.push_back(run.laps);
        result.files.push_back(run.file);
        Beside beside{.run = run, .index = r, .times = times_of(run), .prediction = {}, .regressors = regressors};
        const Clock::time_point begin = Clock::now();
        beside.prediction = solver::predict(run.problem, {.times = beside.times});
        result.seconds += std::chrono::duration<double>(Clock::now() - begin).count();
        result.status = beside.prediction.status;
        if (result.status.ok()) {
            result.status = finite(run, beside.times, beside.prediction);
        }
        if (!result.status.ok()) {
            result.status.message = fmt::format("run \"{}\": {}", run.name, result.status.message);
            return result;
        }
        result.heat.push_back(heat_of(run, beside.prediction));
        for (const input::MeasuredSeries& series : run.series) {
            const solver::Channel& channel = run.problem.channels[series.channel];
            ComparedChannel& compared = channels[series.channel];
            compared.name = channel.name;
            compared.unit = solver::shown_unit(channel.quantity);
            compared.sensor = channel.standard_deviation.value_or(0.0);
            compared.sensor_is_stated = channel.standard_deviation.has_value();
            compared.series.push_back(beside.series(series));
        }
        for (const input::MeasuredNumber& number : run.numbers) {
            result.numbers.push_back(beside.number(number));
        }
        for (const input::MeasuredFrames& frames : run.frames) {
            result.images.push_back(compare_images(run, r, frames, beside.times, beside.prediction));
        }
    }
    if (finer != nullptr) {
        for (const GridError& error : grid_errors(experiment, *finer)) {
            channels[error.channel].grid_error = error.largest;
        }
    }
    for (auto& [index, channel] : channels) {
        evaluate(channel, names, result.laps);
        if (channel.figures.samples > 0) {
            result.channels.push_back(std::move(channel));
        }
    }
    return result;
}

}  // namespace tiretherm::diagnosis
