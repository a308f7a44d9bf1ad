// SPDX-License-Identifier: BSD-3-Clause
// Reads the requested columns of a CSV file and reports lines with the wrong number of fields.

#include <algorithm>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/tables/csv.hpp"
#include "input/text/error_limiter.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_errors = 500;  // of a file; who made it reads no more

/// Whether the numbers of a file have decimal points or commas: the first of each that was met.
class DecimalMarks {
public:
    /// @param field as written  @param number the same with a point
    void take(std::string_view field, std::string_view number, const Csv::Line& line) {
        const bool comma = field.data() != number.data();
        Seen& seen = comma ? comma_ : point_;
        if (seen.field.empty() && (comma || (field.find('.') != std::string_view::npos && is_number(field)))) {
            seen = {field, line};
        }
    }
    void report_both(const Csv& csv, InputErrors& errors) const {
        if (!comma_.field.empty() && !point_.field.empty()) {
            const bool comma_is_later = comma_.line.number > point_.line.number;
            const Seen& later = comma_is_later ? comma_ : point_;
            const Seen& first = comma_is_later ? point_ : comma_;
            errors.add(csv.place(later.line, later.field),
                       fmt::format("\"{}\" has a decimal {}, \"{}\" in line {} a decimal {}", later.field,
                                   comma_is_later ? "comma" : "point", first.field, first.line.number,
                                   comma_is_later ? "point" : "comma"),
                       "export the file with one of them, and without marks between thousands");
        }
    }

private:
    struct Seen {
        std::string_view field;
        Csv::Line line;
    };
    static bool is_number(std::string_view field) {
        const std::optional<Number> number = leading_number(field);
        return number && number->rest.empty();
    }
    Seen comma_;
    Seen point_;
};

}  // namespace

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
    bool has_rows = false;  // complete ones
    const bool is_log = std::ranges::any_of(
        heads_, [](const ColumnHead& head) { return head.is_clock || head.heading.name == "time"; });
    DecimalMarks marks;
    std::string room;
    for (Line line{{}, first_line_}; const auto text = next_line(rest); ++line.number) {
        line.text = *text;
        if (is_blank(line.text) || is_comment(line.text)) {
            continue;
        }
        empty = false;
        if (errors.count() > before + most_errors) {
            errors.add(place(line, line.text), fmt::format("after {} errors the file is read no further", most_errors),
                       "correct those above first");
            break;
        }
        split_fields(line.text, separator_, fields);
        const bool trailing = fields.size() == heads_.size() + 1 && fields.back().empty();
        if (fields.size() < heads_.size() && rest.empty() && has_rows && is_log) {
            errors.warn(place(line, line.text),
                        fmt::format("the last line has {} of {} values: the logger stopped in it, and it is left out",
                                    fields.size(), heads_.size()));
            continue;
        }
        if (fields.size() != heads_.size() && !trailing) {
            const bool too_many_commas = separates_by_commas() && fields.size() > heads_.size();
            ragged.add(
                place(line, line.text),
                {fmt::format("the line has {} values, the first line names {} columns", fields.size(), heads_.size()),
                 too_many_commas
                     ? "if the numbers have decimal commas, export the file with semicolons or with decimal points"
                     : "complete or remove the line"});
            continue;
        }
        has_rows = true;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            const std::string_view field = fields[static_cast<std::size_t>(requests[i].column)];
            const std::string_view number = separates_by_commas() ? field : with_point(field, room);
            if (!separates_by_commas() && requests[i].purpose != Purpose::unused) {
                marks.take(field, number, line);
            }
            readings[i].take(number, [&] { return ColumnReader::FieldLocation{place(line, field)}; });
        }
    }
    if (empty) {
        errors.add({.file = file_}, "the file has headings but no numbers");
    }
    ragged.close("the number of values");
    marks.report_both(*this, errors);
    std::vector<std::vector<double>> values;
    for (ColumnReader& reading : readings) {
        reading.close();
        values.push_back(std::move(reading.values));
    }
    return errors.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
