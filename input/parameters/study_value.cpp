// SPDX-License-Identifier: BSD-3-Clause
// Converts numbers between the units of the study and the case, and formats them for the case document.

#include "input/parameters/study_value.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "input/text/unit_text.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string spelt(std::string_view unit) { return spelt_out(unit); }

void put_at(const SourceLocation& place, TomlValue& value) {
    value.place = place;
    for (TomlValue& item : value.items) {
        put_at(place, item);
    }
}

/// A list as TOML has it. @returns nothing where it is none
std::optional<TomlValue> list_of(const LocatedString& written) {
    InputErrors not_said;
    const std::string text = "list = " + written.text;
    std::optional<TomlValue> document = parse_toml({.number = not_said.add_file("", text), .text = text}, not_said);
    if (!document || document->entries.size() != 1 || document->entries[0].value.kind != TomlValue::Kind::array) {
        return std::nullopt;
    }
    put_at(written.place, document->entries[0].value);
    return std::move(document->entries[0].value);
}

}  // namespace

std::optional<Measure> read_measure(TomlTable& table, std::string_view key, Need need) {
    const TomlValue* node = table.value(key, need, fmt::format("{} = \"...\", a number with its unit", key));
    if (node == nullptr) {
        return std::nullopt;
    }
    Measure measure{
        .number = node->number, .unit = {}, .whole = node->kind == TomlValue::Kind::integer, .place = node->place};
    const std::optional<Number> number =
        node->kind == TomlValue::Kind::text ? leading_number(node->text) : std::nullopt;
    if (number) {
        measure.number = number->value;
        measure.unit = std::string(number->rest);
    } else if (!node->is_number()) {
        return table.add_error(key, fmt::format("{} is {}; a number with its unit is wanted", key, shown(*node)),
                               "write such as \"80 km/h\", or 0.6 for a pure number");
    }
    if (!std::isfinite(measure.number)) {
        return table.add_error(key, fmt::format("{} is {}, not a finite number", key, shown(*node)));
    }
    if (!is_unit(measure.unit)) {
        return table.add_error(key, fmt::format("{} is {}: \"{}\" is not a unit", key, shown(*node), measure.unit),
                               "write such as \"80 km/h\", or 0.6 for a pure number");
    }
    return measure;
}

std::optional<double> in_unit(const Measure& measure, const std::string& unit, bool difference, std::string_view name,
                              InputErrors& errors) {
    const Scale scale = difference ? Scale::difference : Scale::absolute;
    const auto result = conversion(measure.unit, spelt(unit), scale);
    if (const auto* found = std::get_if<Conversion>(&result)) {
        return measure.unit == unit ? measure.number : found->to_si(measure.number);
    }
    return errors.add(measure.place,
                      fmt::format("{} is {}, but the quantity is {}", name, dimension(spelt(measure.unit), scale).name,
                                  dimension(spelt(unit), scale).name),
                      unit.empty() ? "write a pure number" : fmt::format("write it in {}", unit));
}

StudyValue study_value(double number, const std::string& unit, bool whole, const SourceLocation& place) {
    StudyValue value;
    value.text = fmt::format("{:.9g}", number);
    value.number = leading_number(value.text)->value;
    value.node.place = place;
    if (unit.empty()) {
        value.node.kind = whole ? TomlValue::Kind::integer : TomlValue::Kind::real;
        value.node.number = value.number;
        return value;
    }
    value.text += " " + unit;
    value.node.kind = TomlValue::Kind::text;
    value.node.text = value.text;
    return value;
}

TomlValue value_of(const LocatedString& written) {
    TomlValue value;
    value.place = written.place;
    const std::optional<Number> number = leading_number(written.text);
    if (number && number->rest.empty()) {
        value.kind = number->value == std::round(number->value) ? TomlValue::Kind::integer : TomlValue::Kind::real;
        value.number = number->value;
    } else if (written.text == "true" || written.text == "false") {
        value.kind = TomlValue::Kind::boolean;
        value.truth = written.text == "true";
    } else if (std::optional<TomlValue> list = list_of(written)) {
        value = std::move(*list);
    } else {
        value.kind = TomlValue::Kind::text;
        value.text = written.text;
    }
    return value;
}

StudyValue study_value(const TomlValue& node) {
    StudyValue value{.node = node, .text = node.text, .number = nan};
    if (node.is_number()) {
        value.text = fmt::format("{}", node.number);
        value.number = node.number;
    } else if (node.kind == TomlValue::Kind::boolean) {
        value.text = node.truth ? "true" : "false";
    } else if (const std::optional<Number> number = leading_number(node.text)) {
        value.number = number->value;
    }
    return value;
}

bool is_unit(const std::string& text) { return !has_number(spelt(text)) && !signature(spelt(text)).empty(); }

std::string unit_of(const TomlValue& node) {
    const std::optional<Number> number = node.kind == TomlValue::Kind::text ? leading_number(node.text) : std::nullopt;
    return number ? std::string(number->rest) : std::string();
}

}  // namespace tiretherm::input
