// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the expression of each number on the simulated channels of each model, in the unit in which it is shown.

#include "diagnosis/validation/validation_rows.hpp"

#include <string>

#include "solver/channel_unit.hpp"

namespace tiretherm::diagnosis {

namespace {

/// The unit in which a number is shown.
solver::ShownUnit unit_of(const input::ValidationNumber& number) {
    solver::ShownUnit unit = solver::shown_unit(number.quantity);
    switch (number.meaning) {
        case input::Meaning::value:
            return unit;
        case input::Meaning::difference:
            unit.zero = 0.0;
            unit.name = number.quantity == solver::Quantity::temperature ? "K" : unit.name;
            return unit;
        case input::Meaning::ratio:
            return {.name = "1"};
        case input::Meaning::time:
            return {.name = "s"};
    }
    return unit;
}

ModelValue model_value(const input::Expression& expression, const RunResults& results, const solver::ShownUnit& unit) {
    ModelValue found{.applicable = true, .value = std::nullopt, .failure = {}};
    for (const std::size_t run : expression.runs()) {
        found.failure = results.failures[run].empty() ? found.failure : results.failures[run];
    }
    if (found.failure.empty()) {
        found.value = unit.value(expression.value(results.traces));
    }
    return found;
}

InputEffect input_effect(const input::NumberInput& of_number, const input::ValidationInput& input, std::size_t n_models,
                         const RunResults& results, const solver::ShownUnit& unit) {
    InputEffect effect{.name = input.name,
                       .meaning = input.meaning,
                       .standing = input::standing_names[static_cast<std::size_t>(input.standing)],
                       .inferred_from_it = of_number.inferred_from_it,
                       .value = input.value,
                       .ends = input.ends,
                       .unit = input.unit,
                       .numbers = input.numbers,
                       .at_ends = std::vector<std::vector<std::optional<double>>>(n_models)};
    for (const auto& models : of_number.at_ends) {
        for (std::size_t m = 0; m < n_models; ++m) {
            if (models[m]) {
                effect.at_ends[m].push_back(model_value(*models[m], results, unit).value);
            }
        }
    }
    return effect;
}

/// @param table its inputs
ValidationRow row_of(const input::ValidationNumber& number, const input::Validation& table, const RunResults& results) {
    const solver::ShownUnit unit = unit_of(number);
    ValidationRow row{.id = number.id,
                      .what = number.what,
                      .unit = unit.name,
                      .source = number.source,
                      .is_measured = number.is_measured,
                      .low = unit.value(number.low),
                      .high = unit.value(number.high),
                      .uncertainty = unit.difference(number.total_uncertainty()),
                      .parts = {},
                      .models = {},
                      .inputs = {}};
    for (const auto& [name, part] : number.uncertainty) {
        row.parts.emplace_back(name, unit.difference(part));
    }
    for (const std::optional<input::Expression>& expression : number.models) {
        row.models.push_back(expression ? model_value(*expression, results, unit) : ModelValue{});
    }
    for (const input::NumberInput& input : number.inputs) {
        row.inputs.push_back(input_effect(input, table.inputs[input.input], table.models.size(), results, unit));
    }
    return row;
}

}  // namespace

std::vector<ValidationRow> validation_rows(const input::Validation& table, const RunResults& results) {
    std::vector<ValidationRow> rows;
    for (const input::ValidationNumber& number : table.numbers) {
        rows.push_back(row_of(number, table, results));
    }
    return rows;
}

}  // namespace tiretherm::diagnosis
