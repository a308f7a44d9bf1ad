// SPDX-License-Identifier: BSD-3-Clause
// Takes the rows of the observations apart by channel and run.

#include "diagnosis/compare/observed_comparison.hpp"

#include <map>
#include <string>
#include <utility>

#include "diagnosis/compare/comparison_regressors.hpp"

namespace tiretherm::diagnosis {

namespace {

/// One channel of one run.
ComparedSeries series_of(const input::Experiment& experiment, const Observations& observations, const NoiseBlock& block,
                         const Eigen::VectorXd& simulated, const std::vector<Regressor>& regressors) {
    const Observations::Row& first = observations.rows[static_cast<std::size_t>(block.first)];
    const input::MeasuredRun& run = experiment.runs[first.run];
    const bool is_temperature = run.problem.channels[first.channel].quantity == solver::Quantity::temperature;
    ComparedSeries series;
    series.run = first.run;
    series.corner = run.corner;
    series.regressor.resize(regressors.size());
    for (std::size_t i = 0; i < block.time.size(); ++i) {
        const Eigen::Index row = block.first + static_cast<Eigen::Index>(i);
        const physics::Inputs inputs = run.problem.input_signals.at(block.time[i], solver::JumpSide::after);
        series.time.push_back(block.time[i]);
        series.measured.push_back(observations.measured[row]);
        series.simulated.push_back(simulated[row]);
        series.surroundings.push_back(0.0);
        series.phase.push_back(phase_at(run.problem, block.time[i], inputs, has_forces(run)));
        const SampleContext moment{.run = run,
                                   .sample = block.sample[i],
                                   .inputs = inputs,
                                   .simulated = simulated[row],
                                   .is_temperature = is_temperature};
        add_values(regressors, moment, series.regressor);
    }
    add_columns(regressors, first.run, block.sample, series.regressor);
    return series;
}

}  // namespace

std::vector<ComparedChannel> compare_observed(const input::Experiment& experiment, const Observations& observations,
                                              const Eigen::VectorXd& simulated) {
    const std::vector<Regressor> regressors = regressors_of(experiment);
    std::vector<std::pair<std::string, std::string>> names;
    for (const Regressor& regressor : regressors) {
        names.emplace_back(regressor.name, regressor.unit);
    }
    std::vector<std::vector<input::Lap>> laps;
    for (const input::MeasuredRun& run : experiment.runs) {
        laps.push_back(run.laps);
    }
    std::map<std::size_t, ComparedChannel> channels;  // in the case's order
    for (const NoiseBlock& block : observations.blocks) {
        if (block.channel < 0 || block.time.empty()) {
            continue;
        }
        const Observations::Row& first = observations.rows[static_cast<std::size_t>(block.first)];
        if (first.image >= 0) {
            continue;  // a coefficient of a camera's frames
        }
        const solver::Channel& channel = experiment.runs[first.run].problem.channels[first.channel];
        ComparedChannel& compared = channels[first.channel];
        compared.name = channel.name;
        compared.unit = solver::shown_unit(channel.quantity);
        compared.sensor = channel.standard_deviation.value_or(0.0);
        compared.sensor_is_stated = channel.standard_deviation.has_value();
        compared.series.push_back(series_of(experiment, observations, block, simulated, regressors));
    }
    std::vector<ComparedChannel> result;
    for (auto& [index, channel] : channels) {
        evaluate(channel, names, laps);
        result.push_back(std::move(channel));
    }
    return result;
}

}  // namespace tiretherm::diagnosis
