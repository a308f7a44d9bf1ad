// SPDX-License-Identifier: BSD-3-Clause
// Finds what an input of an experiment changes in the document of a case, and writes an end of its range there: keys,
// entries of a schedule's column, or the lengths of parts of the schedule with all times that follow.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/parameters/parameter_path.hpp"
#include "input/tables/columns.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/validation/input_definition.hpp"

namespace tiretherm::input {

namespace {

/// Whether a number of a case and the value of an input are the same, up to the rounding of their units.
bool is_same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

/// Calls visit(cell, conversion to SI) for each number of the columns of the schedules that have this name.
template <typename Visit>
void visit_column(TomlValue& document, std::string_view name, const QuantitySpec& spec, const Visit& visit) {
    TomlValue* schedules = document.find({"drive", "schedule"});
    for (std::size_t s = 0; schedules != nullptr && s < schedules->items.size(); ++s) {
        const TomlValue* columns = schedules->items[s].find("columns");
        TomlValue* rows = schedules->items[s].find("rows");
        for (std::size_t c = 0; columns != nullptr && rows != nullptr && c < columns->items.size(); ++c) {
            const Heading heading = read_heading(columns->items[c].text);
            if (heading.name != name) {
                continue;
            }
            const UnitRead unit = read_heading_unit(heading, spec);
            for (TomlValue& row : rows->items) {
                if (!unit.error && c < row.items.size() && row.items[c].is_number()) {
                    visit(row.items[c], unit.conversion);
                }
            }
        }
    }
}

QuantitySpec spec_of(const std::string& signal) { return quantity_specs::of(*physics::find_signal(signal)); }

/// A value of the input in SI, as a column of that signal counts it.
double si_value(const Measure& measure, const QuantitySpec& spec) {
    InputErrors unheard;
    return in_unit(measure, std::string(spec.unit), false, "value", unheard).value_or(measure.number);
}

void write_number(TomlValue& cell, double number) {
    cell.kind = TomlValue::Kind::real;
    cell.number = number;
}

/// Whether a value of a case is that of the input.
bool has_value(const TomlValue& node, const Measure& value) {
    InputErrors unheard;
    const StudyValue written = study_value(node);
    const Measure measure{.number = written.number, .unit = unit_of(node), .whole = false, .place = {}};
    const std::optional<double> number = in_unit(measure, value.unit, false, "value", unheard);
    return number && is_same(*number, value.number);
}

}  // namespace

double moved_moment(double t, const std::vector<SchedulePart>& parts, double length) {
    double moved = t;
    for (const SchedulePart& part : parts) {
        const double old_length = part.end - part.begin;
        moved += (length - old_length) * std::clamp((t - part.begin) / old_length, 0.0, 1.0);
    }
    return moved;
}

double length_of(const InputDefinition& input, std::size_t end) {
    return si_value(input.ends[end], quantity_specs::moment);
}

InputTrace find_in_case(const InputDefinition& input, const TomlValue& document) {
    InputTrace trace;
    TomlValue copy = document;
    switch (input.action) {
        case InputAction::keys:
            for (const LocatedString& key : input.keys) {
                InputErrors unheard;
                const auto path = ParameterPath::parse(key, document, unheard);
                const TomlValue* node = path ? path->find(document) : nullptr;
                trace.acts = trace.acts || node != nullptr || (path && input.adds_keys);
                if (node != nullptr && !has_value(*node, input.value)) {
                    trace.other_value = shown(*node);
                }
            }
            break;
        case InputAction::signal: {
            const QuantitySpec spec = spec_of(input.signal);
            const double value = si_value(input.value, spec);
            visit_column(copy, input.signal, spec, [&](const TomlValue& cell, const Conversion& unit) {
                trace.acts = trace.acts || is_same(unit.to_si(cell.number), value);
            });
            break;
        }
        case InputAction::parts:
            visit_column(copy, "time", quantity_specs::moment, [&](const TomlValue& cell, const Conversion& unit) {
                trace.acts = trace.acts || (!input.parts.empty() && unit.to_si(cell.number) >= input.parts.front().end);
            });
            break;
        case InputAction::none:
        case InputAction::channel:
        case InputAction::of_case:
        case InputAction::time_to:
            break;
    }
    return trace;
}

void change_case(const InputDefinition& input, std::size_t end, TomlValue& document, InputErrors& errors) {
    // Numbers that stand beside a run belong to the unchanged test: their times may be beyond the end of this one.
    document.remove("measured");
    document.remove("pyrometer");
    const Measure& value = input.ends[end];
    if (input.action == InputAction::keys) {
        for (const LocatedString& key : input.keys) {
            const auto path = ParameterPath::parse(key, document, errors);
            if (path && (input.adds_keys || path->find(document) != nullptr)) {
                static_cast<void>(
                    path->set(document, study_value(value.number, value.unit, false, value.place).node, errors));
            }
        }
    } else if (input.action == InputAction::signal) {
        const QuantitySpec spec = spec_of(input.signal);
        const double old_value = si_value(input.value, spec);
        const double new_value = si_value(value, spec);
        visit_column(document, input.signal, spec, [&](TomlValue& cell, const Conversion& unit) {
            if (is_same(unit.to_si(cell.number), old_value)) {
                write_number(cell, unit.from_si(new_value));
            }
        });
    } else if (input.action == InputAction::parts) {
        const double length = length_of(input, end);
        visit_column(document, "time", quantity_specs::moment, [&](TomlValue& cell, const Conversion& unit) {
            write_number(cell, unit.from_si(moved_moment(unit.to_si(cell.number), input.parts, length)));
        });
        if (TomlValue* last = document.find({"time", "end"}); last != nullptr && last->kind == TomlValue::Kind::text) {
            const ParsedQuantity old_end = parse_quantity(last->text, quantity_specs::moment, "end");
            last->text = fmt::format("{:.17g} s", moved_moment(old_end.value, input.parts, length));
        }
    }
}

}  // namespace tiretherm::input
