#include "diagnosis/own_error.hpp"

namespace tiretherm::diagnosis {

namespace {

/// What an experiment's runs say over given steps, at the fitted values.
Forecast say(const Evidence& evidence, const cases::Experiment& experiment, std::vector<std::vector<double>> steps) {
    const Simulator numbers(experiment, *evidence.observations);
    cases::Experiment still = experiment;
    for (std::size_t r = 0; r < still.runs.size(); ++r) {
        still.runs[r].problem = numbers.problem(r, evidence.base.values);
    }
    still.parameters.clear();
    Simulator simulator(still, *evidence.observations);
    simulator.take_steps(std::move(steps));
    return simulator.at(simulator.start());
}

std::vector<std::vector<double>> halved(const Evidence& evidence) {
    std::vector<std::vector<double>> all;
    for (std::size_t r = 0; r < evidence.steps.size(); ++r) {
        double begin = evidence.experiment->runs[r].problem.settings.start;
        std::vector<double>& ends = all.emplace_back();
        for (const double end : evidence.steps[r]) {
            ends.push_back(0.5 * (begin + end));
            ends.push_back(end);
            begin = end;
        }
    }
    return all;
}

}  // namespace

OwnError find_own_error(Evidence& evidence, const cases::Experiment* finer) {
    constexpr double second_order = 4.0 / 3.0;
    OwnError error{.change = Eigen::VectorXd::Zero(evidence.base.simulated.size())};
    const auto add = [&](const Forecast& better) {
        evidence.count(static_cast<long>(evidence.experiment->runs.size()));
        if (better.status.ok()) {
            error.change += second_order * (better.simulated - evidence.base.simulated);
        }
    };
    add(say(evidence, *evidence.experiment, halved(evidence)));
    if (finer != nullptr) {
        add(say(evidence, *finer, evidence.steps));
    }
    Eigen::MatrixXd whitened = error.change;
    whiten(evidence.observations->blocks, evidence.noise, whitened);
    error.sigma = Remainder(evidence.base.slopes, evidence.base.precision).of(whitened).norm();
    return error;
}

}  // namespace tiretherm::diagnosis
