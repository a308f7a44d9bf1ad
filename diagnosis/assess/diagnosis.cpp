// SPDX-License-Identifier: BSD-3-Clause
// Runs the parts of a diagnosis in order: score tests, correction of the discretisation error, search of hypotheses,
// missing heat, gain on held-out data, next experiment.

#include "diagnosis/assess/diagnosis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/detect/discretisation_error.hpp"
#include "diagnosis/fit/fit.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Standard deviations of the discretisation error: from the first on it is corrected; the correction leaves a quarter
/// of it at most, as another halving would change a quarter of what the last one did; from the last on nothing can be
/// said.
constexpr double noticed = 0.3;
constexpr double left_over = 0.25;
constexpr double too_coarse = 3.0;

/// What stands against a diagnosis before anything is simulated; empty: nothing.
std::string too_little(const input::Experiment& experiment, const Observations& observations) {
    std::vector<std::string> frozen;
    for (const input::MeasuredRun& run : experiment.runs) {
        for (const input::MeasuredSeries& series : run.series) {
            if (series.frozen) {
                frozen.push_back(fmt::format("{} of {}", run.problem.channels[series.channel].name, run.name));
            }
        }
    }
    const auto values = static_cast<long>(observations.rows.size());
    if (values == 0) {
        return fmt::format("no sensor changes ({}).", fmt::join(frozen, ", "));
    }
    // A stated number may stand against what was known of a parameter before. Where the noise is estimated from what is
    // left, there must be more values than free numbers, and each channel's noise takes one more.
    const auto without_prior = std::ranges::count_if(experiment.parameters, [](const solver::FreeParameter& parameter) {
        return std::isinf(parameter.standard_deviation);
    });
    const bool stated = observations.channels.empty();
    const auto free = stated ? static_cast<long>(without_prior) : static_cast<long>(experiment.parameters.size());
    const auto numbers = free + static_cast<long>(observations.channels.size());
    if (values <= numbers && !(stated && free == 0)) {
        return fmt::format(
            "{} values for {} free numbers and {} noises leave nothing to judge the model by. Longer runs, more "
            "sensors or fewer free numbers would help.",
            values, free, observations.channels.size());
    }
    return "";
}

/// The model at the values of its case, beside data that say no more.
Diagnosis cannot_tell(Diagnosis result, const input::Experiment& experiment, const Observations& observations) {
    Fit fit(experiment, observations);
    fit.take_stated_noise();
    result.values = fit.simulator().start();
    if (!fit.move_to(result.values)) {
        result.status = fit.now().status;
    }
    result.base = result.extended = fit.now().simulated;
    result.noise = fit.covariance().channels;
    result.verdict = Verdict::cannot_tell;
    result.simulations = fit.simulator().simulations();
    return result;
}

/// @param stage out: what is being done
void diagnose(const input::Experiment& experiment, const Observations& observations, const DiagnosisOptions& choice,
              Diagnosis& result, const char*& stage) {
    result.reason = too_little(experiment, observations);
    if (!result.reason.empty()) {
        result = cannot_tell(std::move(result), experiment, observations);
        return;
    }
    const input::Experiment fine = with_fine_steps(experiment);
    DiagnosisState state;
    state.score_data = prepare_score_tests(fine, observations, candidates_of(fine, fine.candidates), choice.progress);
    result.status = state.score_data.status;
    Observations corrected = observations;
    bool is_coarse = false;
    if (result.status.ok() && !observations.channels.empty()) {
        stage = "estimate of the grid's error";
        const DiscretisationError error = estimate_discretisation_error(state.score_data, choice.finer);
        result.numerical_error_sigma = error.sigma;
        if (error.sigma > noticed) {
            corrected.measured -= error.change;
            state.score_data.take_observations(corrected);
            result.status = state.score_data.status;
            result.numerical_error_sigma = left_over * error.sigma;
            is_coarse = result.numerical_error_sigma > too_coarse;
        }
    }
    if (result.status.ok() && is_coarse) {
        result.base = result.extended = state.score_data.base.simulated;
        result.values = state.score_data.base.values;
        result.noise = state.score_data.noise.channels;
        result.simulations = state.score_data.simulations;
        result.verdict = Verdict::cannot_tell;
    } else if (result.status.ok()) {
        stage = "search of causes";
        search_hypotheses(state);
        report(state, result);
        stage = "search of missing heat";
        estimate_missing_heat(state, result);
        if (choice.measure_gain) {
            stage = "test of the gain on data that were left out";
            measure_gain(state, result);
        }
        if (choice.plan_next) {
            stage = "plan of the next experiment";
            plan_next(state, result);
        }
    }
}

}  // namespace

std::string_view word_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::named:
            return "named";
        case Verdict::confounded:
            return "confounded";
        case Verdict::unknown:
            return "unknown";
        case Verdict::consistent:
            return "consistent";
        case Verdict::cannot_tell:
            return "cannot_tell";
    }
    return "";
}

Diagnosis diagnose(const input::Experiment& experiment, const Observations& observations,
                   const DiagnosisOptions& choice) {
    const auto begin = std::chrono::steady_clock::now();
    Diagnosis result;
    const char* stage = "fit and the score tests of the candidates";
    try {
        diagnose(experiment, observations, choice, result, stage);
    } catch (const solver::Interrupted&) {
        result.status = {solver::Outcome::stopped, fmt::format("stopped during the {}", stage)};
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
