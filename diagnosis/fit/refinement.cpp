// SPDX-License-Identifier: BSD-3-Clause
// Simulates over halved steps, and on the finer grid where one is given, and extrapolates the change.

#include "diagnosis/fit/refinement.hpp"

#include <algorithm>
#include <utility>

#include "diagnosis/fit/fit.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Simulates an experiment's runs over given steps, at some values of the model's numbers.
ModelPrediction simulate_over(const Model& model, const input::Experiment& experiment,
                              std::vector<std::vector<double>> steps) {
    const input::Experiment still = frozen_at(experiment, Simulator(experiment, model.observations), model.values);
    Simulator simulator(still, model.observations);
    simulator.take_steps(std::move(steps));
    return simulator.at(simulator.start());
}

std::vector<std::vector<double>> halved(const Model& model) {
    std::vector<std::vector<double>> all;
    for (std::size_t r = 0; r < model.steps.size(); ++r) {
        double begin = model.experiment.runs[r].problem.settings.start;
        std::vector<double>& ends = all.emplace_back();
        for (const double end : model.steps[r]) {
            ends.push_back(0.5 * (begin + end));
            ends.push_back(end);
            begin = end;
        }
    }
    return all;
}

}  // namespace

input::Experiment frozen_at(const input::Experiment& experiment, const Simulator& numbers,
                            const Eigen::VectorXd& values) {
    input::Experiment still = experiment;
    for (std::size_t r = 0; r < still.runs.size(); ++r) {
        still.runs[r].problem = numbers.problem(r, values);
    }
    still.parameters.clear();
    return still;
}

Eigen::VectorXd change_by_refinement(const Model& model, const input::Experiment* finer) {
    constexpr double second_order = 4.0 / 3.0;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(model.simulated.size());
    const auto add = [&](const ModelPrediction& better) {
        if (better.status.ok()) {
            change += second_order * (better.simulated - model.simulated);
        }
    };
    add(simulate_over(model, model.experiment, halved(model)));
    if (finer != nullptr) {
        add(simulate_over(model, *finer, model.steps));
    }
    return change;
}

std::vector<double> largest_changes(const Observations& observations, const Eigen::VectorXd& change) {
    std::vector<double> largest(observations.channels.size(), 0.0);
    for (const NoiseBlock& block : observations.blocks) {
        if (block.channel >= 0) {
            double& most = largest[static_cast<std::size_t>(block.channel)];
            most = std::max(most, change(Eigen::seqN(block.first, block.rows())).cwiseAbs().maxCoeff());
        }
    }
    return largest;
}

std::vector<GridError> grid_errors(const input::Experiment& experiment, const input::Experiment& finer) {
    input::Experiment still = experiment;
    still.parameters.clear();
    input::Experiment still_finer = finer;
    still_finer.parameters.clear();
    const Observations observations = observe(still);
    Simulator simulator(still, observations);
    const Eigen::VectorXd values = simulator.start();
    const ModelPrediction& base = simulator.at(values);
    if (!base.status.ok()) {
        return {};
    }
    const std::vector<double> largest =
        largest_changes(observations, change_by_refinement({.experiment = still,
                                                            .observations = observations,
                                                            .values = values,
                                                            .simulated = base.simulated,
                                                            .steps = simulator.steps()},
                                                           &still_finer));
    std::vector<GridError> errors;
    for (std::size_t c = 0; c < largest.size(); ++c) {
        errors.push_back({.channel = observations.channels[c], .largest = largest[c]});
    }
    return errors;
}

}  // namespace tiretherm::diagnosis
