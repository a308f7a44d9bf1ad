// SPDX-License-Identifier: BSD-3-Clause
// Reads the requested columns of a CSV file and reports lines with the wrong number of fields.

#include <fmt/format.h>

#include "input/tables/csv.hpp"
#include "input/text/error_limiter.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

std::vector<std::vector<double>> Csv::read(const std::vector<ColumnRequest>& requests, InputErrors& errors) const {
    const std::size_t before = errors.count();
    std::vector<ColumnReader> readings;
    readings.reserve(requests.size());
    for (const ColumnRequest& request : requests) {
        readings.emplace_back(heads_[static_cast<std::size_t>(request.column)], request, errors);
    }
    ErrorLimiter ragged(errors);
    std::vector<std::string_view> fields;
    std::string_view rest = body_;
    bool empty = true;
    for (Line line{{}, first_line_}; const auto text = next_line(rest); ++line.number) {
        line.text = *text;
        if (trim(line.text).empty()) {
            continue;
        }
        empty = false;
        split_fields(line.text, separator_, fields);
        const bool trailing = fields.size() == heads_.size() + 1 && fields.back().empty();
        if (fields.size() != heads_.size() && !trailing) {
            const bool too_many_commas = has_commas() && fields.size() > heads_.size();
            ragged.add(
                place(line, line.text),
                {fmt::format("the line has {} values, the first line names {} columns", fields.size(), heads_.size()),
                 too_many_commas ? "if the numbers have decimal commas, export the file with decimal points"
                                 : "complete or remove the line"});
            continue;
        }
        for (std::size_t i = 0; i < requests.size(); ++i) {
            const std::string_view field = fields[static_cast<std::size_t>(requests[i].column)];
            readings[i].take(field, [&] { return ColumnReader::FieldLocation{place(line, field)}; });
        }
    }
    if (empty) {
        errors.add({.file = file_}, "the file has headings but no numbers");
    }
    ragged.close("the number of values");
    std::vector<std::vector<double>> values;
    for (ColumnReader& reading : readings) {
        reading.close();
        values.push_back(std::move(reading.values));
    }
    return errors.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
