// SPDX-License-Identifier: BSD-3-Clause
// Puts numbers of single runs into the models of a diagnosis, and takes them out of the case that goes on.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "diagnosis/assess/diagnosis_state.hpp"
#include "diagnosis/assess/linear_prediction.hpp"
#include "diagnosis/assess/prediction_gain.hpp"
#include "diagnosis/assess/run_changes.hpp"

namespace tiretherm::diagnosis {

namespace {

std::string name_in_run(const std::string& name, const input::MeasuredRun& run) { return name + " of " + run.name; }

/// A run's own value of a free number: nothing was known of it before.
void add_own_number(input::Experiment& experiment, std::size_t number, std::size_t run) {
    solver::FreeParameter own = experiment.parameters[number];
    own.name = name_in_run(own.name, experiment.runs[run]);
    own.runs = {run};
    own.standard_deviation = std::numeric_limits<double>::infinity();
    solver::FreeParameter& of_others = experiment.parameters[number];
    if (of_others.runs.empty()) {
        of_others.runs.resize(experiment.runs.size());
        std::iota(of_others.runs.begin(), of_others.runs.end(), 0);
    }
    std::erase(of_others.runs, run);
    experiment.parameters.push_back(std::move(own));
}

/// A cause that acts in some runs alone: switched on in all, and a number of each of those.
void add_own_cause(input::Experiment& experiment, const RunChange& change) {
    experiment = with(std::move(experiment), {*change.candidate}, {change.candidate->absent});
    solver::FreeParameter number = experiment.parameters.back();
    experiment.parameters.pop_back();
    std::tie(number.low, number.high) = plausible_bounds(*change.candidate);
    for (const std::size_t run : change.runs) {
        solver::FreeParameter& own = experiment.parameters.emplace_back(number);
        own.name = name_in_run(number.name, experiment.runs[run]);
        own.runs = {run};
    }
}

/// The fit with the changes that the diagnosis goes on with where it adds nothing to it.
const Refit& fit_beside_changes(const DiagnosisState& state) {
    const bool is_fitted = state.search && state.search->base.base != BaseModel::as_it_stands;
    return is_fitted ? state.search->base.hypothesis.fit : state.score_data.base;
}

/// What blocks within the runs are missed by, each predicted from the rest in the linearised model.
HeldOutErrors out_of_blocks(const Refit& fit, const Observations& observations) {
    HeldOutErrors out{
        .left = Eigen::VectorXd::Constant(observations.measured.size(), std::numeric_limits<double>::quiet_NaN()),
        .ok = true};
    const LinearisedModel model = linearise(fit, observations);
    const std::vector<bool> none(static_cast<std::size_t>(fit.values.size()), false);
    for (const Fold& fold : folds_within_recordings(observations)) {
        out.left(fold.test) = left_of(model, solve(model, fold.rest), fold.test, none);
    }
    return out;
}

/// What the changes gain by themselves, on blocks within the runs: a run that has a number of its own cannot be left out whole.
PredictionGain gain_of_changes(const DiagnosisState& state) {
    const Observations& observations = *state.score_data.observations;
    return compare_predictions(out_of_blocks(*state.without_changes, observations),
                               out_of_blocks(state.score_data.base, observations), observations,
                               state.score_data.noise.channels, observations.stated);
}

/// The value of a free number with its interval, where the work came as far as that.
CauseNumber number_of(const DiagnosisState& state, const Diagnosis& found, const std::string& name) {
    if (const auto at = std::ranges::find(found.free_numbers, name, &FreeNumber::name);
        at != found.free_numbers.end()) {
        return {.key = name, .unit = at->unit, .value = at->value, .low = at->low, .high = at->high};
    }
    const std::vector<solver::FreeParameter>& all = state.score_data.experiment->parameters;
    const auto at = std::ranges::find(all, name, &solver::FreeParameter::name);
    const double value = fit_beside_changes(state).values[at - all.begin()];
    return {.key = name, .unit = at->unit, .value = value, .low = value, .high = value};
}

/// What else may be another one in a run, of a number of the case.
Remark likely_reason(std::string_view effect) {
    if (effect == "strain_energy_loss") {
        return remark::other_compound();
    }
    if (effect == "air_convection") {
        return remark::other_air();
    }
    return effect == "sliding_friction" ? remark::other_road() : remark::other_setup();
}

/// What a change is of: the effect's id and the key of its number.
Cause cause_of(const RunChange& change, const input::Experiment& original) {
    const solver::Problem& problem = original.runs.front().problem;
    Cause cause{.id = change.name(original), .in_set = true};
    cause.numbers.emplace_back().key = cause.id;
    const auto take = [&](const physics::Effect& effect, std::size_t parameter) {
        cause.id = effect.id;
        cause.numbers.front().key = effect.parameters[parameter].key;
    };
    if (change.candidate) {
        take(*change.candidate->effect, change.candidate->parameter);
        cause.channel = sensors_of(*change.candidate, problem);
    } else if (const solver::FreeParameter& number = original.parameters[change.number];
               number.kind == solver::FreeParameter::Kind::effect) {
        take(*problem.effects[number.effect].effect, number.parameter);
    }
    return cause;
}

/// Whether two runs at least share each number that changes: else no run has predicted the value that the next one has.
bool is_shared_by_two_runs(const DiagnosisState& state) {
    return std::ranges::all_of(state.run_changes, [&](const RunChange& change) {
        std::set<std::size_t> odd;
        for (const RunChange& other : state.run_changes) {
            if (other.name(*state.unchanged) == change.name(*state.unchanged)) {
                odd.insert(other.runs.begin(), other.runs.end());
            }
        }
        return odd.size() + 2 <= state.unchanged->runs.size();
    });
}

/// A change as the causes of its runs, and its remark.
void describe(const DiagnosisState& state, const RunChange& change, std::vector<Cause>& causes, Diagnosis& into) {
    const std::string name = change.name(*state.unchanged);
    const double common = change.candidate ? change.candidate->absent : number_of(state, into, name).value;
    const std::size_t first = causes.size();
    for (const std::size_t run : change.runs) {
        Cause& cause = causes.emplace_back(cause_of(change, *state.unchanged));
        cause.run = state.unchanged->runs[run].name;
        cause.instead_of = common;
        CauseNumber own = number_of(state, into, name_in_run(name, state.unchanged->runs[run]));
        own.key = cause.numbers.front().key;
        const double deviation = (own.high - own.low) / (2.0 * 1.959964);
        cause.sigma = deviation > 0.0 ? std::abs(own.value - common) / deviation : 0.0;
        cause.numbers.front() = std::move(own);
    }
    const Cause& one = causes[first];
    const CauseNumber& own = one.numbers.front();
    if (change.is_trend) {
        into.remarks.push_back(remark::changes_from_run_to_run(name, own.value, common));
    } else if (change.candidate) {
        into.remarks.push_back(
            remark::reading_of_run_differs(one.run, name, own.key, own.value, own.low, own.high, own.unit));
    } else {
        const CauseNumber others = number_of(state, into, name);
        const double times = own.value / common;
        const double half =
            0.5 * std::hypot((own.high - own.low) / common, times * (others.high - others.low) / common);
        into.remarks.push_back(
            remark::number_of_run_differs(one.run, name, times, times - half, times + half, {likely_reason(one.id)}));
    }
}

/// Puts causes before all others, into every hypothesis.
void put_first(std::vector<Cause> causes, Diagnosis& into) {
    const std::size_t n = causes.size();
    const auto shift = [&](std::vector<std::size_t>& members) {
        for (std::size_t& member : members) {
            member += n;
        }
        for (std::size_t k = n; k-- > 0;) {
            members.insert(members.begin(), k);
        }
    };
    std::ranges::for_each(into.hypotheses, shift);
    for (HeldOutGain& gain : into.held_out_gains) {
        for (std::size_t& member : gain.causes) {
            member += n;
        }
    }
    for (Cause& cause : into.causes) {
        cause.rank += static_cast<int>(n);
    }
    for (std::size_t k = 0; k < n; ++k) {
        causes[k].rank = static_cast<int>(k) + 1;
    }
    into.causes.insert(into.causes.begin(), std::make_move_iterator(causes.begin()),
                       std::make_move_iterator(causes.end()));
    if (into.hypotheses.empty() && into.verdict != Verdict::unknown) {
        shift(into.hypotheses.emplace_back());
        into.verdict = into.verdict == Verdict::consistent ? Verdict::named : Verdict::partial;
        into.reason.reset();
        into.limits.clear();
    }
}

/// The gain of the changes, which is that of the whole answer where nothing else was found.
void add_gain(const DiagnosisState& state, std::size_t n_causes, bool is_alone, Diagnosis& into) {
    const PredictionGain gain = gain_of_changes(state);
    HeldOutGain& one = into.held_out_gains.emplace_back();
    one.removed = gain.removed;
    one.low = gain.low;
    one.high = gain.high;
    for (std::size_t k = 0; k < n_causes; ++k) {
        one.causes.push_back(k);
    }
    if (!is_alone) {
        return;
    }
    into.gain = {.within_run = true, .over = BaseModel::correlated_noise};
    take_gain(gain, into.gain);
    into.gain.confirmed = gain.low > 0.0 && is_confirmed(gain, into.gain);
    if (gain.low <= 0.0 && into.verdict == Verdict::named) {
        into.verdict = Verdict::partial;
    }
}

}  // namespace

input::Experiment with_run_changes(input::Experiment experiment, const std::vector<RunChange>& changes) {
    for (const RunChange& change : changes) {
        if (change.candidate) {
            add_own_cause(experiment, change);
            continue;
        }
        for (const std::size_t run : change.runs) {
            add_own_number(experiment, change.number, run);
        }
    }
    return experiment;
}

input::Experiment without_run_changes(input::Experiment experiment, const input::Experiment& original,
                                      const std::vector<RunChange>& changes, Eigen::VectorXd& values) {
    std::vector<double> kept(values.begin(), values.end());
    const auto erase = [&](const std::string& name) {
        const auto at = std::ranges::find(experiment.parameters, name, &solver::FreeParameter::name);
        const std::size_t effect = at->effect;
        kept.erase(kept.begin() + (at - experiment.parameters.begin()));
        experiment.parameters.erase(at);
        return effect;
    };
    for (const RunChange& change : changes) {
        const std::string name = change.name(original);
        std::size_t effect = 0;
        for (const std::size_t run : change.runs) {
            effect = erase(name_in_run(name, original.runs[run]));
        }
        if (!change.candidate) {
            experiment.parameters[change.number].runs = original.parameters[change.number].runs;
            continue;
        }
        for (input::MeasuredRun& run : experiment.runs) {
            run.problem.effects.erase(run.problem.effects.begin() + static_cast<std::ptrdiff_t>(effect));
        }
        for (solver::FreeParameter& parameter : experiment.parameters) {
            const bool is_later = parameter.kind == solver::FreeParameter::Kind::effect && parameter.effect > effect;
            parameter.effect -= is_later ? 1 : 0;
        }
    }
    values = Eigen::Map<const Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size()));
    return experiment;
}

DiagnosisOptions take_run_changes(DiagnosisState& state, const DiagnosisOptions& choice) {
    DiagnosisOptions options = choice;
    if (!state.run_changes.empty()) {
        return options;
    }
    ScoreTestData& score_data = state.score_data;
    std::vector<RunChange> changes = find_run_changes(score_data);
    if (changes.empty()) {
        return options;
    }
    const input::Experiment& original = *score_data.experiment;
    const input::Experiment& changed = state.changed_models.emplace_back(with_run_changes(original, changes));
    ScoreTestData beside = prepare_score_tests(changed, *score_data.observations,
                                               candidates_of(changed, changed.candidates), score_data.progress);
    beside.simulations += score_data.simulations;
    if (!beside.status.ok()) {
        score_data.simulations = beside.simulations;
        return options;
    }
    state.without_changes = score_data.base;
    state.unchanged = &original;
    score_data = std::move(beside);
    state.run_changes = std::move(changes);
    for (std::vector<RicherModel>* meshes : {&options.richer, &options.much_finer}) {
        for (RicherModel& one : *meshes) {
            one.experiment = &state.changed_models.emplace_back(with_run_changes(*one.experiment, state.run_changes));
        }
    }
    return options;
}

void report_run_changes(const DiagnosisState& state, Diagnosis& into) {
    if (state.run_changes.empty() || into.base.size() == 0) {
        return;
    }
    std::vector<Cause> causes;
    for (const RunChange& change : state.run_changes) {
        describe(state, change, causes, into);
    }
    const std::size_t n = causes.size();
    const bool is_unproven = into.verdict == Verdict::partial && into.gain.measured && into.gain.removed_low <= 0.0;
    const bool is_alone = state.best() == nullptr || is_unproven;
    if (is_unproven) {  // what was found beside them may be chance: they are the answer
        into.hypotheses.clear();
        into.held_out_gains.clear();
        std::ranges::for_each(into.causes, [](Cause& cause) { cause.in_set = false; });
    }
    put_first(std::move(causes), into);
    const Refit& fit = fit_beside_changes(state);
    if (is_alone) {
        into.extended = fit.simulated;
        into.extended_model = *state.score_data.experiment;
        into.extended_values = fit.values;
    }
    if (into.extended_model) {
        into.extended_model = without_run_changes(std::move(*into.extended_model), *state.unchanged, state.run_changes,
                                                  into.extended_values);
    }
    into.base = state.without_changes->simulated;
    into.values = state.without_changes->values;
    if (!state.score_data.observations->channels.empty()) {
        add_gain(state, n, is_alone, into);
    }
    into.gain.confirmed = into.gain.confirmed && is_shared_by_two_runs(state);
}

}  // namespace tiretherm::diagnosis
