// SPDX-License-Identifier: BSD-3-Clause
// Reads one [[number]]: the measured value, range or limit, and its uncertainty in one or several independent parts.

#include <array>

#include <fmt/format.h>

#include "input/text/quantity_specs.hpp"
#include "input/validation/validation_reader.hpp"

namespace tiretherm::input {

namespace {

QuantitySpec wanted_of(const Evaluation& evaluation, solver::Quantity quantity) {
    switch (evaluation.meaning) {
        case Meaning::value:
            return quantity == solver::Quantity::temperature ? quantity_specs::temperature
                                                             : QuantitySpec{.unit = solver::unit_of(quantity)};
        case Meaning::difference:
            return {.unit = solver::unit_of(quantity), .scale = Scale::difference};
        case Meaning::ratio:
            return {.unit = "1"};
        case Meaning::time:
            return {.unit = "s"};
    }
    return {};
}

/// Standard uncertainty: one quantity, or its independent parts by name.
void read_uncertainty(TomlTable& table, QuantitySpec spec, ValidationNumber& number) {
    spec.scale = Scale::difference;
    spec.low = 0.0;
    spec.above = true;
    spec.usual_low = -std::numeric_limits<double>::infinity();
    spec.usual_high = std::numeric_limits<double>::infinity();
    const TomlValue* node = table.value("uncertainty");
    if (node != nullptr && node->kind == TomlValue::Kind::table) {
        TomlTable parts = table.subtable("uncertainty");
        for (const Entry& part : node->entries) {
            number.uncertainty.emplace_back(part.key, parts.quantity(part.key, spec).value_or(0.0));
        }
        if (node->entries.empty()) {
            table.add_error("uncertainty", "the uncertainty has no part", "write { sensor = ... }");
        }
        return;
    }
    const bool needed = table.has("value") || table.has("range");
    if (const auto one = table.quantity("uncertainty", spec, needed ? Need::required : Need::optional)) {
        number.uncertainty.emplace_back("whole", *one);
    }
}

void read_measured(TomlTable& table, const QuantitySpec& spec, ValidationNumber& number) {
    constexpr std::array<const char*, 4> keys{"value", "range", "above", "below"};
    table.declare_keys({"value", "range", "above", "below"});
    const char* given = nullptr;
    for (const char* key : keys) {
        if (table.has(key) && given != nullptr) {
            table.add_error(key, fmt::format("both {} and {} are given", given, key), "keep one of them");
        }
        given = table.has(key) ? key : given;
    }
    number.is_measured = given != nullptr;
    if (const std::optional<double> value = table.quantity("value", spec)) {
        number.low = number.high = *value;
    }
    if (const auto range = table.range("range", spec)) {
        number.low = (*range)[0];
        number.high = (*range)[1];
    }
    number.low = table.quantity("above", spec).value_or(number.low);
    number.high = table.quantity("below", spec).value_or(number.high);
    read_uncertainty(table, spec, number);
}

}  // namespace

ValidationNumber read_number(TomlTable& table, const std::vector<InputDefinition>& inputs, CaseCache& cache) {
    ValidationNumber number;
    number.id = table.text("id").value_or("");
    number.what = table.text("what").value_or("");
    Evaluation evaluation = read_evaluation(table, cache);
    number.meaning = evaluation.meaning;
    if (evaluation.quantity) {
        number.quantity = *evaluation.quantity;
        read_measured(table, wanted_of(evaluation, number.quantity), number);
    } else {
        table.declare_keys({"value", "range", "above", "below", "uncertainty"});
    }
    number.about_the_model = table.flag("about_the_model").value_or(false);
    number.source = table.text("source", number.is_measured ? Need::required : Need::optional).value_or("");
    number.inputs = read_number_inputs(table, inputs, evaluation, cache);
    number.models = std::move(evaluation.models);
    return number;
}

}  // namespace tiretherm::input
