// SPDX-License-Identifier: BSD-3-Clause
// Runs of a table with effects switched on, numbers moved, readings bent or the other mesh taken.

#include "diagnosis/quoted/trials.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "diagnosis/quoted/trial_candidates.hpp"
#include "diagnosis/validation/validation_rows.hpp"
#include "solver/channel_unit.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis::quoted {

namespace {

constexpr const char* not_run = "not simulated";

void add_once(std::vector<std::size_t>& all, const std::vector<std::size_t>& more) {
    for (const std::size_t one : more) {
        if (std::ranges::find(all, one) == all.end()) {
            all.push_back(one);
        }
    }
}

}  // namespace

Trials::Trials(const input::Validation& validation, std::size_t model, unsigned threads,
               std::function<void(long)> progress)
    : validation_(validation), model_(model), threads_(threads), progress_(std::move(progress)) {
    base_.traces.resize(validation.runs.size());
    base_.failures.assign(validation.runs.size(), not_run);
    std::vector<std::size_t> runs = nominal_runs(model);
    candidates_.resize(validation.runs.size());
    for (const std::size_t run : runs) {
        candidates_[run] = candidates_in(validation.runs[run].problem);
    }
    for (const input::ValidationNumber& number : validation.numbers) {
        for (const input::NumberInput& input : number.inputs) {
            for (const auto& models : input.at_ends) {
                if (models[model]) {
                    add_once(runs, models[model]->runs());
                }
            }
        }
    }
    run_as_they_are(runs);
    table_ = validation_rows(validation_, base_);
}

void Trials::simulate_runs(const std::vector<input::ValidationRun>& chosen, const std::vector<std::size_t>& places,
                           RunResults& into) {
    const long before = simulations_;
    RunResults results = run_all(chosen, threads_, [&](std::size_t done) {
        if (progress_) {
            progress_(before + static_cast<long>(done));
        }
    });
    simulations_ += static_cast<long>(chosen.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        into.traces[places[i]] = std::move(results.traces[i]);
        into.failures[places[i]] = results.failures[i];
    }
}

void Trials::run_as_they_are(const std::vector<std::size_t>& runs) {
    std::vector<input::ValidationRun> chosen;
    std::vector<std::size_t> places;
    for (const std::size_t run : runs) {
        if (base_.failures[run] == not_run) {
            chosen.push_back(validation_.runs[run]);
            places.push_back(run);
        }
    }
    simulate_runs(chosen, places, base_);
}

std::vector<std::size_t> Trials::nominal_runs(std::size_t model) const {
    std::vector<std::size_t> runs;
    for (const input::ValidationNumber& number : validation_.numbers) {
        if (number.models[model] && number.models[model_]) {
            add_once(runs, number.models[model]->runs());
        }
    }
    return runs;
}

std::vector<std::string> Trials::failures() const {
    std::vector<std::string> found;
    std::ranges::copy_if(base_.failures, std::back_inserter(found),
                         [](const std::string& failure) { return !failure.empty() && failure != not_run; });
    return found;
}

std::size_t Trials::model_of(const std::vector<Applied>& applied) const {
    const auto other = std::ranges::find_if(
        applied, [](const Applied& one) { return one.addition->kind == AdditionKind::mesh && one.value > 0.0; });
    return other != applied.end() ? other->addition->model : model_;
}

std::string Trials::source_word(std::size_t number) const {
    const std::string& source = validation_.numbers[number].source;
    return source.substr(0, source.find_first_of(" ,:;"));
}

bool Trials::apply(const Applied& applied, std::size_t run, solver::Problem& problem) const {
    const Addition& addition = *applied.addition;
    if ((addition.kind != AdditionKind::effect && addition.kind != AdditionKind::number) ||
        applied.value == addition.absent) {
        return false;
    }
    const std::vector<Candidate>& mine = candidates_[run];
    const auto found = std::ranges::find_if(mine, [&](const Candidate& one) { return is_of(one, addition, problem); });
    if (found == mine.end()) {
        return false;
    }
    input::Experiment alone;
    alone.runs.emplace_back();
    alone.runs.front().problem = std::move(problem);
    problem = std::move(with(std::move(alone), {*found}, {applied.value}).runs.front().problem);
    return true;
}

void Trials::read_instrument(const Applied& applied, RunResults& results) const {
    const Addition& addition = *applied.addition;
    for (std::size_t run = 0; run < results.traces.size(); ++run) {
        const std::vector<solver::Channel>& channels = validation_.runs[run].problem.channels;
        for (std::size_t c = 0; c < channels.size() && results.failures[run].empty(); ++c) {
            if (channels[c].quantity != solver::Quantity::temperature ||
                instrument_of(channels[c].name) != addition.id) {
                continue;
            }
            const bool is_gain = addition.key == gain_key;
            results.traces[run].correct(c, is_gain ? 1.0 + applied.value : 1.0, gain_reference,
                                        is_gain ? 0.0 : applied.value);
        }
    }
}

std::vector<std::size_t> Trials::runs_of(std::size_t model, const std::vector<Applied>& applied) const {
    std::vector<std::size_t> runs = nominal_runs(model);
    for (const Applied& one : applied) {
        for (const input::ValidationNumber& number : validation_.numbers) {
            for (const input::NumberInput& input : number.inputs) {
                const bool is_it = one.addition->kind == AdditionKind::input &&
                                   validation_.inputs[input.input].name == one.addition->id;
                for (std::size_t end = 0; is_it && end < input.at_ends.size(); ++end) {
                    if (input.at_ends[end][model]) {
                        add_once(runs, input.at_ends[end][model]->runs());
                    }
                }
            }
        }
    }
    return runs;
}

RunResults Trials::run(const std::vector<Applied>& applied) {
    const std::vector<std::size_t> runs = runs_of(model_of(applied), applied);
    run_as_they_are(runs);
    for (const std::size_t run : runs) {
        candidates_[run] = candidates_[run].empty() ? candidates_in(validation_.runs[run].problem) : candidates_[run];
    }
    std::vector<input::ValidationRun> changed;
    std::vector<std::size_t> places;
    for (const std::size_t run : runs) {
        input::ValidationRun copy = validation_.runs[run];
        bool any = false;
        for (const Applied& one : applied) {
            any = apply(one, run, copy.problem) || any;
        }
        if (any) {
            changed.push_back(std::move(copy));
            places.push_back(run);
        }
    }
    RunResults all{.traces = std::vector<input::Trace>(validation_.runs.size()),
                   .failures = std::vector<std::string>(validation_.runs.size(), not_run),
                   .warnings = {}};
    for (const std::size_t run : runs) {
        all.traces[run] = base_.traces[run];
        all.failures[run] = base_.failures[run];
    }
    simulate_runs(changed, places, all);
    if (applied.size() == 1 && applied.front().addition->kind == AdditionKind::instrument) {
        read_instrument(applied.front(), all);
    }
    return all;
}

double Trials::more_by_inputs(const std::vector<Applied>& applied, const std::vector<ValidationRow>& table,
                              std::size_t number) const {
    double sum = 0.0;
    for (const Applied& one : applied) {
        const auto known = std::ranges::find(validation_.inputs, one.addition->id, &input::ValidationInput::name);
        if (one.addition->kind != AdditionKind::input || known == validation_.inputs.end()) {
            continue;
        }
        const auto change = [&](const ValidationRow& row) -> std::optional<double> {
            const auto effect = std::ranges::find(row.inputs, one.addition->id, &InputEffect::name);
            if (effect == row.inputs.end() || effect->at_ends[model_].size() != 2 || !row.models[model_].value ||
                !effect->at_ends[model_][0] || !effect->at_ends[model_][1]) {
                return std::nullopt;
            }
            const double value = *row.models[model_].value;
            const std::vector<double> at{effect->numbers[0], known->number, effect->numbers[1]};
            const std::vector<double> there{*effect->at_ends[model_][0], value, *effect->at_ends[model_][1]};
            return physics::Curve::table(at, there).value(one.value) - value;
        };
        const std::optional<double> with = change(table[number]);
        const std::optional<double> alone = change(table_[number]);
        sum += with && alone ? *with - *alone : 0.0;
    }
    return sum;
}

std::vector<double> Trials::together(const std::vector<Applied>& applied, const Numbers& numbers) {
    const std::size_t model = model_of(applied);
    const std::vector<ValidationRow> table = validation_rows(validation_, run(applied));
    std::vector<double> changes(numbers.rows.size(), 0.0);
    for (std::size_t r = 0; r < changes.size(); ++r) {
        const std::size_t number = numbers.rows[r].number;
        const std::optional<double> now = table[number].models[model].value;
        if (!now && validation_.numbers[number].models[model]) {
            return {};
        }
        // A number that the other mesh does not have stays as it is.
        changes[r] = now ? *now - *table_[number].models[model_].value : 0.0;
        if (model == model_) {
            changes[r] += more_by_inputs(applied, table, number);
        }
        const Applied& first = applied.front();
        const bool other_source =
            first.addition->kind == AdditionKind::instrument && first.addition->what != source_word(number);
        if (applied.size() == 1 && other_source) {
            changes[r] = 0.0;
        }
    }
    for (const Applied& one : applied) {
        const bool adds_up = one.addition->kind == AdditionKind::input ||
                             (one.addition->kind == AdditionKind::instrument && applied.size() > 1);
        if (adds_up) {
            const std::vector<std::vector<double>> of_one = one.addition->table();
            const double share = (one.value - one.addition->low) / (one.addition->high - one.addition->low);
            const auto at = static_cast<std::size_t>(std::lround(share * static_cast<double>(of_one.size() - 1)));
            for (std::size_t r = 0; r < changes.size(); ++r) {
                changes[r] += of_one[at][r];
            }
        }
    }
    return changes;
}

void Trials::simulate(Addition& addition, const Numbers& numbers) {
    if (addition.kind == AdditionKind::input) {
        return;
    }
    addition.changes.clear();
    std::vector<double> nodes;
    for (const double node : addition.nodes) {
        if (solver::stop_requested()) {
            return;
        }
        std::vector<double> changes(numbers.rows.size(), 0.0);
        if (node != addition.absent) {
            changes = together({{.addition = &addition, .value = node}}, numbers);
            if (changes.empty()) {
                continue;  // beyond what the solver can do: the range ends before
            }
        }
        nodes.push_back(node);
        addition.changes.push_back(std::move(changes));
    }
    if (nodes.size() < 2) {
        addition.is_simulated = false;
    }
    addition.nodes = nodes;
    addition.low = std::max(addition.low, nodes.front());
    addition.high = std::min(addition.high, nodes.back());
}

std::vector<ChannelEnd> Trials::ends(const std::vector<Applied>& applied, const std::vector<std::size_t>& of) {
    RunResults results = run(applied);
    for (const Applied& one : applied) {
        if (applied.size() > 1 && one.addition->kind == AdditionKind::instrument) {
            read_instrument(one, results);
        }
    }
    std::vector<std::size_t> runs;
    for (const std::size_t number : of) {
        if (const auto& read = validation_.numbers[number].models[model_of(applied)]) {
            add_once(runs, read->runs());
        }
    }
    const auto last = [&](std::size_t run, std::size_t c) {
        const solver::Settings& settings = validation_.runs[run].problem.settings;
        return solver::shown_unit(solver::Quantity::temperature)
            .value(results.traces[run].read(c, {.from = settings.start, .to = settings.end}));
    };
    std::vector<ChannelEnd> found;
    for (const std::size_t run : runs) {
        const solver::Problem& problem = validation_.runs[run].problem;
        for (std::size_t c = 0; c < problem.n_sensors() && results.failures[run].empty(); ++c) {
            if (problem.channels[c].quantity != solver::Quantity::temperature) {
                continue;
            }
            double value = last(run, c);
            for (const Applied& one : applied) {
                if (const std::optional<InputEnd> moved = run_at_end(one, run);
                    moved && results.failures[moved->run].empty()) {
                    value += moved->share * (last(moved->run, c) - last(run, c));
                }
            }
            found.push_back({.run = problem.name, .channel = problem.channels[c].name, .value = value});
        }
    }
    return found;
}

std::optional<Trials::InputEnd> Trials::run_at_end(const Applied& input, std::size_t run) const {
    const auto known = std::ranges::find(validation_.inputs, input.addition->id, &input::ValidationInput::name);
    if (input.addition->kind != AdditionKind::input || known == validation_.inputs.end() ||
        input.value == known->number) {
        return std::nullopt;
    }
    const std::size_t end = input.value > known->number ? 1 : 0;
    const std::string changed = fmt::format("{} = {}", known->name, known->ends[end]);
    for (std::size_t other = 0; other < validation_.runs.size(); ++other) {
        if (validation_.runs[other].file == validation_.runs[run].file && validation_.runs[other].changed == changed) {
            return InputEnd{.run = other,
                            .share = (input.value - known->number) / (known->numbers[end] - known->number)};
        }
    }
    return std::nullopt;
}

}  // namespace tiretherm::diagnosis::quoted
