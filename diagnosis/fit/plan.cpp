// SPDX-License-Identifier: BSD-3-Clause
// Plans an experiment: the intervals that a fit would give, from the linearised model and the stated sensor noise,
// without any measured data.

#include <chrono>

#include "diagnosis/fit/doubt.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/fit/fit_assessment.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

input::Experiment planned(input::Experiment experiment) {
    for (input::MeasuredRun& run : experiment.runs) {
        const solver::Settings& settings = run.problem.settings;
        if (run.time.empty() && settings.steady) {
            run.time = {settings.end};
        }
        if (run.time.empty()) {
            const double length = settings.end - settings.start;
            const double interval = settings.output_interval > 0.0 ? settings.output_interval : 0.01 * length;
            for (int i = 0; i * interval <= length * (1.0 + 1e-12); ++i) {
                run.time.push_back(settings.start + i * interval);
            }
        }
        run.series.clear();
        for (std::size_t c = 0; c < run.problem.channels.size(); ++c) {
            if (run.problem.channels[c].standard_deviation) {
                run.series.push_back({.channel = c, .value = std::vector<double>(run.time.size())});
            }
        }
    }
    return experiment;
}

std::vector<Noise> stated_noise(const input::Experiment& /*experiment*/, const Observations& observations,
                                double correlation_time, double white_share) {
    std::vector<Noise> noise;
    for (const double stated : observations.stated) {
        noise.push_back({.sigma = stated > 0.0 ? stated : 1.0,
                         .correlation_time = correlation_time,
                         .white_share = correlation_time > 0.0 ? white_share : 1.0});
    }
    return noise;
}

Identification plan(const input::Experiment& experiment, const Observations& observations,
                    const std::vector<Noise>& noise) {
    const auto begin = std::chrono::steady_clock::now();
    Identification result;
    Fit fit(experiment, observations);
    try {
        if (!fit.move_to(fit.simulator().start())) {
            result.status = fit.now().status;
            return result;
        }
    } catch (const solver::Interrupted& stopped) {
        result.status = {solver::Outcome::stopped, stopped.what()};
        return result;
    }
    fit.take_noise(noise);
    result.converged = true;
    result.values = fit.values();
    result.before = result.after = fit.now().simulated;
    assess_parameters(fit, result, false);
    doubt_input_numbers(experiment.parameters, result);
    result.simulations = fit.simulator().simulations();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
