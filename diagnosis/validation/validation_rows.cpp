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

ValidationRow row_of(const input::ValidationNumber& number, const RunResults& results) {
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
                      .models = {}};
    for (const auto& [name, part] : number.uncertainty) {
        row.parts.emplace_back(name, unit.difference(part));
    }
    for (const std::optional<input::Expression>& expression : number.models) {
        row.models.push_back(expression ? model_value(*expression, results, unit) : ModelValue{});
    }
    return row;
}

}  // namespace

std::vector<ValidationRow> validation_rows(const input::Validation& table, const RunResults& results) {
    std::vector<ValidationRow> rows;
    for (const input::ValidationNumber& number : table.numbers) {
        rows.push_back(row_of(number, results));
    }
    return rows;
}

}  // namespace tiretherm::diagnosis
