#include "diagnosis/detect/own_error.hpp"

namespace tiretherm::diagnosis {

namespace {

/// What an experiment's runs say over given steps, at some values of the model's numbers.
ModelPrediction say(const Model& model, const input::Experiment& experiment, std::vector<std::vector<double>> steps) {
    const Simulator numbers(experiment, model.observations);
    input::Experiment still = experiment;
    for (std::size_t r = 0; r < still.runs.size(); ++r) {
        still.runs[r].problem = numbers.problem(r, model.values);
    }
    still.parameters.clear();
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

Eigen::VectorXd change_by_refinement(const Model& model, const input::Experiment* finer) {
    constexpr double second_order = 4.0 / 3.0;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(model.simulated.size());
    const auto add = [&](const ModelPrediction& better) {
        if (better.status.ok()) {
            change += second_order * (better.simulated - model.simulated);
        }
    };
    add(say(model, model.experiment, halved(model)));
    if (finer != nullptr) {
        add(say(model, *finer, model.steps));
    }
    return change;
}

OwnError find_own_error(Evidence& evidence, const input::Experiment* finer) {
    OwnError error{.change = change_by_refinement({.experiment = *evidence.experiment,
                                                   .observations = *evidence.observations,
                                                   .values = evidence.base.values,
                                                   .simulated = evidence.base.simulated,
                                                   .steps = evidence.steps},
                                                  finer)};
    evidence.count(static_cast<long>(evidence.experiment->runs.size()) * (finer != nullptr ? 2 : 1));
    Eigen::MatrixXd whitened = error.change;
    whiten(evidence.observations->blocks, evidence.noise, whitened);
    error.sigma = Remainder(evidence.base.slopes, evidence.base.precision).of(whitened).norm();
    return error;
}

}  // namespace tiretherm::diagnosis
