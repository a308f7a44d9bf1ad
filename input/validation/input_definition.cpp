// SPDX-License-Identifier: BSD-3-Clause
// Reads one [[input]]: where its value comes from, the ends of its range, and what it changes.

#include "input/validation/input_definition.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "physics/signals.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array reading_actions{InputAction::channel, InputAction::of_case, InputAction::time_to};
constexpr std::array action_keys{"keys", "signal", "between", "reads"};

/// keys = [...], signal = "...", between = [[...]] or reads = "...": one of them.
void read_action(TomlTable& table, InputDefinition& input) {
    table.declare_keys({"keys", "signal", "between", "reads", "cases", "adds_keys"});
    const char* given = nullptr;
    for (const char* key : action_keys) {
        if (table.has(key) && given != nullptr) {
            table.add_error(key, fmt::format("both {} and {} are given", given, key), "keep one of them");
        }
        given = table.has(key) ? key : given;
    }
    if (given == nullptr && input.shown.standing != Standing::printed) {
        table.add_error("", "nothing says what this input changes",
                        "add keys = [\"drive.air_temperature\"], signal, between or reads");
    }
    input.keys = table.texts("keys");
    input.adds_keys = table.flag("adds_keys").value_or(false);
    input.cases = table.texts("cases");
    if (!input.keys.empty()) {
        input.action = InputAction::keys;
    }
    if (const std::optional<std::string> signal = table.text("signal")) {
        input.signal = *signal;
        if (physics::find_signal(*signal) != nullptr) {
            input.action = InputAction::signal;
        } else {
            table.add_error("signal", fmt::format("\"{}\" is not an input of a drive", *signal),
                            suggest(*signal, names_of(physics::signals()), "inputs"));
        }
    }
    if (table.has("between")) {
        input.action = InputAction::parts;
    }
    if (const std::optional<std::size_t> reading = table.choice("reads")) {
        input.action = reading_actions[*reading];
    }
}

/// A number and its unit as a list has it; nothing after an error.
std::optional<Measure> measure_of(const TomlValue& node, InputErrors& errors) {
    Measure measure{.number = node.number,
                    .unit = unit_of(node),
                    .whole = node.kind == TomlValue::Kind::integer,
                    .place = node.place};
    const std::optional<Number> number = node.kind == TomlValue::Kind::text ? leading_number(node.text) : std::nullopt;
    measure.number = number ? number->value : node.number;
    if ((!number && !node.is_number()) || !is_unit(measure.unit)) {
        return errors.add(node.place, fmt::format("range has {}; a number with its unit is wanted", shown(node)),
                          "write such as \"300 s\", or 0.9 for a pure number");
    }
    return measure;
}

/// @returns whether there is a value
bool read_numbers(TomlTable& table, InputDefinition& input) {
    const std::optional<Measure> value = read_measure(table, "value", Need::required);
    const TomlValue* range = table.value("range");
    if (!value) {
        return false;
    }
    input.value = *value;
    input.shown.unit = value->unit;
    input.shown.number = value->number;
    input.shown.value = study_value(*table.value("value")).text;
    if (range == nullptr) {
        return true;
    }
    if (range->kind != TomlValue::Kind::array || range->items.size() != 2) {
        table.add_error("range", "a range has two ends", "write range = [\"lower end\", \"upper end\"]");
        return true;
    }
    for (const TomlValue& item : range->items) {
        const std::optional<Measure> end = measure_of(item, table.errors());
        const std::optional<double> number =
            end ? in_unit(*end, value->unit, false, "range", table.errors()) : std::nullopt;
        if (number) {
            input.ends.push_back({.number = *number, .unit = value->unit, .whole = false, .place = item.place});
            input.shown.ends.push_back(study_value(item).text);
            input.shown.numbers.push_back(*number);
        }
    }
    const std::vector<double>& ends = input.shown.numbers;
    if (ends.size() == 2 && !(ends[0] < ends[1] && ends[0] <= value->number && value->number <= ends[1])) {
        table.add_error("range", "the value is not within its range",
                        "let range = [lower end, upper end] include value");
    }
    return true;
}

/// The words of `reads`: a value and what may stand in its place.
void read_words(TomlTable& table, InputDefinition& input) {
    input.shown.value = table.text("value", Need::required).value_or("");
    input.words = table.texts("range");
    for (const LocatedString& word : input.words) {
        input.shown.ends.push_back(word.text);
    }
}

/// between = [["0 s", "80 s"], ["90 s", "170 s"]]: each as long as the value.
void read_parts(TomlTable& table, InputDefinition& input) {
    const TomlValue& list = *table.value("between");
    const auto wrong = [&](const SourceLocation& place) {
        table.errors().add(place, "between is not a list of parts, each with begin and end",
                           "write between = [[\"1200 s\", \"1230 s\"]]");
    };
    if (list.kind != TomlValue::Kind::array || list.items.empty()) {
        wrong(list.place);
        return;
    }
    const double length = in_unit(input.value, "s", false, "value", table.errors()).value_or(0.0);
    for (const TomlValue& item : list.items) {
        if (item.kind != TomlValue::Kind::array || item.items.size() != 2) {
            wrong(item.place);
            return;
        }
        const ParsedQuantity begin = parse_quantity(item.items[0].text, quantity_specs::moment, "between");
        const ParsedQuantity end = parse_quantity(item.items[1].text, quantity_specs::moment, "between");
        if (begin.error || end.error) {
            table.errors().add(item.place, begin.error ? *begin.error : *end.error);
            return;
        }
        const double before = input.parts.empty() ? begin.value : input.parts.back().end;
        if (begin.value < before || end.value <= begin.value) {
            table.errors().add(item.place, "the parts are not one after the other", "sort them by time");
            return;
        }
        if (std::abs(end.value - begin.value - length) > 1e-9 * length) {
            table.errors().add(item.place,
                               fmt::format("this part takes {:.6g} s, and the value is {}", end.value - begin.value,
                                           input.shown.value),
                               "let value be the length of each part");
        }
        input.parts.push_back({.begin = begin.value, .end = end.value});
    }
}

}  // namespace

InputDefinition read_input(TomlTable& table, const std::vector<InputDefinition>& known) {
    InputDefinition input;
    input.shown.name = table.text("name", Need::required).value_or("");
    input.place = table.place("value");
    if (std::ranges::any_of(known,
                            [&](const InputDefinition& other) { return other.shown.name == input.shown.name; })) {
        table.add_error("name", fmt::format("there are two inputs \"{}\"", input.shown.name), "rename one of them");
    }
    input.shown.meaning = table.text("meaning", Need::required).value_or("");
    const std::optional<std::size_t> standing = table.choice("standing");
    input.shown.standing = static_cast<Standing>(standing.value_or(0));
    const bool unknown = standing && input.shown.standing != Standing::printed;
    read_action(table, input);
    table.declare_keys({"value", "range"});
    if (unknown) {
        static_cast<void>(table.value("range", Need::required, "range = [\"lower end\", \"upper end\"]"));
    } else if (standing && table.has("range")) {
        table.add_error("range", "a printed input has no range", "remove it, or say inferred or assumed");
    }
    if (input.action == InputAction::none) {
        input.shown.value = table.has("value") ? study_value(*table.value("value")).text : "";
        static_cast<void>(table.value("value", Need::required, "value = \"100 km/h\""));
    } else if (input.action == InputAction::channel || input.action == InputAction::of_case) {
        read_words(table, input);
    } else if (read_numbers(table, input) && input.action == InputAction::parts) {
        read_parts(table, input);
    }
    return input;
}

}  // namespace tiretherm::input
