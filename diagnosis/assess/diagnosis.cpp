// SPDX-License-Identifier: BSD-3-Clause
// Runs the parts of a diagnosis in order: score tests, correction of the discretisation error, search of hypotheses,
// missing heat, gain on held-out data, next experiment.

#include "diagnosis/assess/diagnosis.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/instrument_doubt.hpp"
#include "diagnosis/assess/lookalikes.hpp"
#include "diagnosis/assess/window_names.hpp"
#include "diagnosis/detect/discretisation_error.hpp"
#include "diagnosis/findings/parameter_findings.hpp"
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

/// What stands against a diagnosis before anything is simulated, if anything does.
std::optional<Remark> too_little(const input::Experiment& experiment, const Observations& observations) {
    const auto values = static_cast<long>(observations.rows.size());
    if (values == 0) {
        Remarks frozen;
        for (const input::MeasuredRun& run : experiment.runs) {
            for (const input::MeasuredSeries& series : run.series) {
                if (series.frozen) {
                    frozen.push_back(remark::sensor_of_run(run.problem.channels[series.channel].name, run.name));
                }
            }
        }
        return remark::no_sensor_changes(std::move(frozen));
    }
    // A stated number may stand against what was known of a parameter before. Where the noise is estimated from what is
    // left, there must be more values than free parameters, and each channel's noise takes one more.
    const auto without_prior = std::ranges::count_if(experiment.parameters, [](const solver::FreeParameter& parameter) {
        return std::isinf(parameter.standard_deviation);
    });
    const bool stated = observations.channels.empty();
    const auto free = stated ? static_cast<long>(without_prior) : static_cast<long>(experiment.parameters.size());
    const auto noises = static_cast<long>(observations.channels.size());
    if (values <= free + noises && !(stated && free == 0)) {
        return remark::too_few_values(values, free, noises);
    }
    return std::nullopt;
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

/// What the parameters of the base fit say, where nothing is added to the model.
std::vector<ParameterFinding> findings_of(const input::Experiment& experiment, const Refit& base) {
    const Eigen::VectorXd deviations = base.deviations();
    std::vector<FittedParameter> fitted;
    std::vector<double> before;
    for (std::size_t j = 0; j < experiment.parameters.size(); ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        fitted.push_back({.value = base.values[i], .standard_deviation = deviations[i], .at_bound = base.at_bound[j]});
        before.push_back(solver::value_of(experiment.runs.front().problem, experiment.parameters[j]));
    }
    return parameter_findings(experiment, fitted, before);
}

/// Searches causes and says what they are worth. Where the model has errors of its own, or what the likelihood named does not
/// predict better, the search is by prediction.
/// @param coarse the grid is too coarse for the likelihood to be asked
void find_causes(DiagnosisState& state, const DiagnosisOptions& asked, Diagnosis& result, Part& part, bool coarse) {
    result.remarks = untried(*state.score_data.experiment);
    const bool can_leave_out = !state.score_data.observations->channels.empty() && asked.measure_gain;
    part = Part::causes;
    const DiagnosisOptions choice = can_leave_out ? take_run_changes(state, asked) : asked;
    // The base is the experiment's own, whatever mesh is taken later.
    const input::Experiment& experiment = *state.score_data.experiment;
    const Refit base = state.score_data.base;
    if (can_leave_out && (coarse || has_model_error(state.score_data))) {
        search_beside_model_error(state, choice.richer);
        if (state.search->accepted.empty()) {
            accept_unknown_source(state);
        }
    } else {
        search_hypotheses(state);
        const bool is_plausible = state.set.empty() || std::ranges::any_of(state.set, &FittedHypothesis::plausible);
        if (can_leave_out && (state.something_left || !is_plausible || !unknown_source_predicts(state))) {
            search_for_more(state, choice.richer);
        }
    }
    report(state, result);
    result.base = state.without_changes ? state.without_changes->simulated : base.simulated;
    result.values = base.values;
    for (const ParameterFinding& finding : findings_of(experiment, base)) {
        result.remarks.push_back(remark::without_cause({finding.remark}));
    }
    if (!choice.only_verdict) {
        part = Part::missing_heat;
        estimate_missing_heat(state, result);
        name_window(experiment, result);
    }
    if (can_leave_out) {
        part = Part::gain;
        measure_gain(state, result);
    }
    describe_model_error(state, result);
    if (withdraw_what_may_be_absent(result)) {
        state.set.clear();
        state.verdict = result.verdict;
        describe_model_error(state, result);
    }
    widen_by_instruments(state, result);
    if (!choice.only_verdict) {
        part = Part::next_experiment;
        state.score_data.say({.doing = Work::next_experiment});
        plan_next(state, result);
    }
    result.simulations = state.score_data.simulations;
}

/// The best answer that there is when the work is stopped: nothing more is simulated.
void finish_early(DiagnosisState& state, Part part, Diagnosis& result) {
    const ScoreTestData& score_data = state.score_data;
    result.stopped = part;
    result.stopped_at = score_data.stage;
    result.rest_of_stage = score_data.rest_of_stage();
    if (result.base.size() > 0) {  // reported; what was not yet tested on data that were left out is not proven
        if (!result.gain.measured && (result.verdict == Verdict::named || result.verdict == Verdict::confounded)) {
            result.verdict = Verdict::partial;
        }
        return;
    }
    take_what_was_found(state);
    report(state, result);
    result.base = score_data.base.simulated;
    result.reason.reset();
    if (result.hypotheses.empty()) {
        result.verdict = Verdict::cannot_tell;
        std::string first;
        for (const std::size_t k : by_score(score_data, 3)) {
            first += (first.empty() ? "" : ", ") + name_of(score_data.candidates[k], *score_data.experiment);
        }
        if (!first.empty()) {
            result.reason = remark::best_so_far(first);
        }
    } else {
        result.verdict = Verdict::partial;
    }
}

/// @param part out: what is being done
void diagnose(const input::Experiment& experiment, const Observations& observations, const DiagnosisOptions& choice,
              DiagnosisState& state, Observations& corrected, const input::Experiment& fine, Diagnosis& result,
              Part& part) {
    result.reason = too_little(experiment, observations);
    if (result.reason) {
        result = cannot_tell(std::move(result), experiment, observations);
        return;
    }
    state.score_data.progress = choice.progress;
    state.score_data.course.richer = std::ssize(choice.richer);
    prepare_score_tests(fine, observations, candidates_of(fine, fine.candidates), state.score_data);
    result.status = state.score_data.status;
    corrected = observations;
    bool is_coarse = false;
    if (result.status.ok() && !observations.channels.empty()) {
        part = Part::grid_error;
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
    if (result.status.ok() && is_coarse && choice.measure_gain && !choice.much_finer.empty()) {
        // A correction that is as large as this is none, and a finer grid needs none.
        state.score_data.take_observations(observations);
        DiagnosisOptions finer = choice;
        std::ranges::copy(choice.much_finer, std::back_inserter(finer.richer));
        const double sigma = result.numerical_error_sigma;
        result.numerical_error_sigma = 0.0;
        find_causes(state, finer, result, part, true);
        if (!state.mesh.empty()) {
            return;
        }
        // No gain with the finer grid: the data do not show the error of the case's own, and it is kept.
        if (state.search && state.search->accepted.empty() && !has_model_error(state.score_data)) {
            state.search.reset();
            state.set.clear();
            result = Diagnosis();
            find_causes(state, choice, result, part, false);
        }
        result.remarks.push_back(remark::grid_is_kept(sigma, choice.much_finer.front().name));
        result.numerical_error_sigma = sigma;
        if (result.verdict == Verdict::named || result.verdict == Verdict::confounded) {
            result.verdict = Verdict::partial;
            result.gain.confirmed = false;
        }
        return;
    }
    if (result.status.ok() && is_coarse) {
        result.base = result.extended = state.score_data.base.simulated;
        result.values = state.score_data.base.values;
        result.noise = state.score_data.noise.channels;
        result.simulations = state.score_data.simulations;
        result.verdict = Verdict::cannot_tell;
    } else if (result.status.ok()) {
        find_causes(state, choice, result, part, false);
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
        case Verdict::partial:
            return "partial";
    }
    return "";
}

Verdict Diagnosis::overall() const {
    if (data_faults.empty()) {
        return verdict;
    }
    return verdict == Verdict::consistent    ? Verdict::named
           : verdict == Verdict::cannot_tell ? Verdict::partial
                                             : verdict;
}

void take_data_faults(DataFaults faults, const input::Experiment& experiment, Diagnosis& into) {
    into.simulations += faults.simulations;
    into.data_faults = std::move(faults.found);
    if (!faults.corrections.mirrored.empty()) {  // no key of a case says it
        into.extended_model.reset();
    } else if (!into.data_faults.empty() && !into.extended_model && into.values.size() > 0) {
        into.extended_model = experiment;
        into.extended_values = into.values;
    }
}

Diagnosis diagnose(const input::Experiment& experiment, const Observations& observations,
                   const DiagnosisOptions& choice) {
    const auto begin = std::chrono::steady_clock::now();
    Diagnosis result;
    const input::Experiment fine = with_fine_steps(experiment);
    Observations corrected;
    DiagnosisState state;
    Part part = Part::score_tests;
    try {
        diagnose(experiment, observations, choice, state, corrected, fine, result, part);
    } catch (const solver::Interrupted&) {
        if (state.score_data.base.values.size() > 0) {
            finish_early(state, part, result);
        } else {
            result.status = {solver::Outcome::stopped, "stopped during the first simulation"};
        }
    }
    report_run_changes(state, result);
    if (result.base.size() > 0) {
        result.cannot_see = lookalikes_of(state.score_data);
        remark_on_lookalikes(result);
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

}  // namespace tiretherm::diagnosis
