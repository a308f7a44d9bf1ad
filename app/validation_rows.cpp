#include "app/validation_rows.hpp"

#include <string>

#include "post/channel_unit.hpp"

namespace tiretherm::app {

namespace {

/// The unit in which a number is shown.
post::ShownUnit unit_of(const cases::ValidationNumber& number) {
    post::ShownUnit unit = post::shown_unit(number.quantity);
    switch (number.meaning) {
        case cases::Meaning::value:
            return unit;
        case cases::Meaning::difference:
            unit.zero = 0.0;
            unit.name = number.quantity == solver::Quantity::temperature ? "K" : unit.name;
            return unit;
        case cases::Meaning::ratio:
            return {.name = "1"};
        case cases::Meaning::time:
            return {.name = "s"};
    }
    return unit;
}

post::ModelValue model_value(const cases::Expression& expression, const RunResults& results,
                             const post::ShownUnit& unit) {
    post::ModelValue found{.asked = true, .value = std::nullopt, .failure = {}};
    for (const std::size_t run : expression.runs()) {
        found.failure = results.failures[run].empty() ? found.failure : results.failures[run];
    }
    if (found.failure.empty()) {
        found.value = unit.value(expression.value(results.traces));
    }
    return found;
}

post::ValidationRow row_of(const cases::ValidationNumber& number, const RunResults& results) {
    const post::ShownUnit unit = unit_of(number);
    post::ValidationRow row{.id = number.id,
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
    for (const std::optional<cases::Expression>& expression : number.models) {
        row.models.push_back(expression ? model_value(*expression, results, unit) : post::ModelValue{});
    }
    return row;
}

}  // namespace

std::vector<post::ValidationRow> validation_rows(const cases::Validation& table, const RunResults& results) {
    std::vector<post::ValidationRow> rows;
    for (const cases::ValidationNumber& number : table.numbers) {
        rows.push_back(row_of(number, results));
    }
    return rows;
}

}  // namespace tiretherm::app
