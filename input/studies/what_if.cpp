// SPDX-License-Identifier: BSD-3-Clause
// Moves an input in its course, or writes a value into the document of the case and reads it again.

#include "input/studies/what_if.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "input/parameters/effect_names.hpp"
#include "input/parameters/parameter_path.hpp"
#include "input/parameters/study_value.hpp"
#include "input/text/quantity.hpp"
#include "physics/effect.hpp"
#include "physics/signals.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view of_drive = "drive.";

/// A change as it is written.
struct WrittenChange {
    bool is_added = false;
    bool is_share = false;
    bool is_value = false;  ///< a number with its unit that takes the value's place
    Measure measure{};      ///< of these
    std::string text;       ///< "+0.5 deg"
};

/// "KEY=+0.5 deg" cut at its first "=".
struct ChangeText {
    LocatedString key;
    LocatedString change;
};

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

SourceLocation place_at(int file, std::size_t column, std::size_t length) {
    return {.file = file,
            .line = 1,
            .column = static_cast<int>(column),
            .length = static_cast<int>(std::max<std::size_t>(1, length))};
}

std::optional<ChangeText> cut(const std::string& text, int file, InputErrors& errors) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || trimmed(text.substr(equals + 1)).empty()) {
        return errors.add(place_at(file, 2, text.size()), "a key and its change are wanted",
                          "write such as \"drive.inflation_pressure=+0.1 bar\"");
    }
    return ChangeText{
        .key = {trimmed(text.substr(0, equals)), place_at(file, 1, equals + 1)},
        .change = {trimmed(text.substr(equals + 1)), place_at(file, equals + 3, text.size() - equals - 1)}};
}

std::optional<WrittenChange> step_of(const LocatedString& change, const std::string& sign, InputErrors& errors) {
    const std::string rest =
        sign.empty() ? change.text : trimmed(change.text.substr(change.text.find_first_not_of("+-")));
    const std::optional<Number> number = leading_number(rest);
    const double value = number ? number->value : std::nan("");
    const std::string unit = number ? std::string(number->rest) : "";
    const bool is_share = !sign.empty() && unit == "%";
    const bool is_number = std::isfinite(value) && (is_share || is_unit(unit));
    if (!sign.empty() && !is_number) {
        return errors.add(
            change.place, fmt::format("\"{}\" is no number with a unit", change.text),
            "write such as \"+0.1 bar\", \"-5 K\" or \"+10 %\"; a value without a sign takes the place of the case's");
    }
    std::optional<WrittenChange> step(std::in_place);
    step->text = sign + rest;
    step->is_added = !sign.empty();
    step->is_share = is_share;
    step->is_value = sign.empty() && is_number;
    if (is_number) {
        step->measure.number = sign == "-" ? -value : value;
        step->measure.unit = unit;
        step->measure.place = change.place;
    }
    return step;
}

/// Lowest and highest value of an input in its course.
std::pair<double, double> range_of(const solver::InputSignals& inputs, const physics::Signal& signal) {
    const double constant = inputs.constants().*signal.member;
    std::pair<double, double> range{constant, constant};
    for (const solver::Series& series : inputs.series()) {
        if (series.signal == &signal && !series.value.empty()) {
            const auto [low, high] = std::ranges::minmax(series.value);
            range = {low, high};
        }
    }
    return range;
}

/// Moves an input of the tire in all of its course, or gives it one value.
void move_input(const physics::Signal& signal, const WrittenChange& step, ChangedRuns& into,
                const std::vector<RunOfCase>& chosen, InputErrors& errors) {
    double by = 0.01 * step.measure.number;
    if (!step.is_share) {
        const std::optional<double> si =
            in_unit(step.measure, std::string(signal.unit), step.is_added, signal.name, errors);
        if (!si) {
            return;
        }
        by = *si;
    }
    into.runs = chosen;
    for (RunOfCase& run : into.runs) {
        solver::InputSignals& inputs = run.problem.input_signals;
        const auto [low_before, high_before] = range_of(inputs, signal);
        inputs.move(signal, step.is_share ? 1.0 + by : step.is_added ? 1.0 : 0.0, step.is_share ? 0.0 : by);
        const auto [low, high] = range_of(inputs, signal);
        if ((low < signal.low && low_before >= signal.low) || (high > signal.high && high_before <= signal.high)) {
            errors.add(step.measure.place,
                       fmt::format("{} would be {:.4g} {}, and {:.4g} to {:.4g} are possible", signal.name,
                                   low < signal.low ? low : high, signal.unit, signal.low, signal.high),
                       "change it less, or by a share such as +10 %");
            return;
        }
    }
}

/// The value of the case with the step added.
std::optional<TomlValue> moved(const TomlValue& value, const std::string& key, const WrittenChange& step,
                               InputErrors& errors) {
    const StudyValue known = study_value(value);
    if (!std::isfinite(known.number)) {
        return errors.add(step.measure.place, fmt::format("{} is {}, to which nothing can be added", key, shown(value)),
                          "give a value without a sign, which takes its place");
    }
    const std::string unit = unit_of(value);
    if (step.is_share) {
        return study_value(known.number * (1.0 + 0.01 * step.measure.number), unit, false, step.measure.place).node;
    }
    const std::optional<double> by = in_unit(step.measure, unit, true, key, errors);
    return by ? std::optional(study_value(known.number + *by, unit, false, step.measure.place).node) : std::nullopt;
}

/// A number of an effect that is on and that the case leaves to its standard, as the case would have it.
std::optional<TomlValue> standard_value(const std::string& key, const solver::Problem& problem,
                                        const SourceLocation& place) {
    const std::optional<CatalogueEntry> entry = find_in_catalogue(key);
    for (const physics::ActiveEffect& active : problem.effects) {
        if (entry && entry->parameter && active.effect == entry->effect) {
            const std::string_view unit = active.effect->parameters[*entry->parameter].unit;
            return study_value(active[*entry->parameter], unit == "1" ? "" : std::string(unit), false, place).node;
        }
    }
    return std::nullopt;
}

/// Writes the value into the document and reads the case again.
void change_document(const std::filesystem::path& file, const std::string& run, const ChangeText& asked,
                     const std::vector<RunOfCase>& chosen, const WrittenChange& step, ChangedRuns& into,
                     InputErrors& errors) {
    std::optional<TomlValue> document = read_document(file, errors);
    const std::optional<ParameterPath> path =
        document ? ParameterPath::parse(asked.key, *document, errors) : std::nullopt;
    if (!path) {
        return;
    }
    std::optional<TomlValue> value = value_of(asked.change);
    if (step.is_added) {
        const TomlValue* given = path->find(*document);
        const std::optional<TomlValue> known =
            given != nullptr ? *given : standard_value(asked.key.text, chosen.front().problem, asked.change.place);
        if (!known) {
            errors.add(asked.key.place, fmt::format("the case does not give {}", asked.key.text),
                       "give a value without a sign, which the case then has");
            return;
        }
        value = moved(*known, asked.key.text, step, errors);
    }
    if (value && path->set(*document, *value, errors)) {
        into.runs = runs_of_document(*document, file, run, errors);
    }
}

bool reads_signal(const physics::Effect& effect, std::string_view signal) {
    return std::ranges::find(effect.reads, signal) != effect.reads.end() ||
           std::ranges::find(effect.may_read, signal) != effect.may_read.end();
}

}  // namespace

std::vector<std::string> standard_changes() {
    return {"drive.inflation_pressure=+-0.1 bar", "drive.camber=+-0.5 deg", "drive.air_temperature=+-5 K",
            "drive.road_temperature=+-5 K"};
}

std::vector<ChangedRuns> change_runs(const std::filesystem::path& file, const std::string& run,
                                     const std::vector<RunOfCase>& chosen, const std::string& text) {
    InputErrors asked_errors;
    const int call = asked_errors.add_file("--change", fmt::format("\"{}\"", text));
    const std::optional<ChangeText> asked = cut(text, call, asked_errors);
    if (!asked) {
        return {{.key = text, .change = {}, .errors = asked_errors.in_order()}};
    }
    const std::string& change = asked->change.text;
    std::vector<std::string> signs{""};
    if (change.starts_with("+-")) {
        signs = {"+", "-"};
    } else if (change.starts_with('+') || change.starts_with('-')) {
        signs = {change.substr(0, 1)};
    }
    std::vector<ChangedRuns> found;
    for (const std::string& sign : signs) {
        ChangedRuns& one = found.emplace_back(ChangedRuns{.key = asked->key.text, .change = change});
        InputErrors errors = asked_errors;
        if (const std::optional<WrittenChange> step = step_of(asked->change, sign, errors)) {
            one.change = step->text;
            const physics::Signal* signal =
                one.key.starts_with(of_drive) ? physics::find_signal(std::string_view(one.key).substr(of_drive.size()))
                                              : nullptr;
            const bool is_given = signal != nullptr && std::ranges::any_of(chosen, [&](const RunOfCase& one_run) {
                                      return one_run.problem.input_signals.gives(*signal);
                                  });
            if (signal != nullptr && !is_given && step->is_added) {
                one.nothing_to_change = "is not given by the case: nothing follows it";
            } else if (is_given && (step->is_added || step->is_value)) {
                move_input(*signal, *step, one, chosen, errors);
            } else {
                change_document(file, run, *asked, chosen, *step, one, errors);
            }
        }
        one.errors = errors.in_order();
        if (!one.errors.empty()) {
            one.runs.clear();
            found.resize(1);  // the other sign has the same
            break;
        }
    }
    return found;
}

std::vector<std::string> readers_of(const solver::Problem& problem, std::string_view signal) {
    std::vector<std::string> names;
    for (const physics::ActiveEffect& active : problem.effects) {
        if (reads_signal(*active.effect, signal)) {
            names.emplace_back(active.title());
        }
    }
    return names;
}

std::vector<std::string> would_read(const solver::Problem& problem, std::string_view signal) {
    std::vector<std::string> names;
    for (const physics::Effect* effect : physics::catalogue()) {
        const bool is_on = std::ranges::any_of(
            problem.effects, [&](const physics::ActiveEffect& active) { return active.effect == effect; });
        if (!is_on && reads_signal(*effect, signal) && effect->input_correction() == nullptr) {
            names.emplace_back(effect->id);
        }
    }
    return names;
}

}  // namespace tiretherm::input
