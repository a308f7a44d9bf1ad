// SPDX-License-Identifier: BSD-3-Clause
// Reads the requested columns of a CSV file and reports lines with the wrong number of fields.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "input/loggers/clock_times.hpp"
#include "input/loggers/csv_layout.hpp"
#include "input/tables/csv.hpp"
#include "input/text/error_limiter.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t most_errors = 500;  // of a file; who made it reads no more

/// Numbers with decimal commas beside numbers with points. @param marks of some columns, the first of each
void report_both_marks(const Csv& csv, const CsvRows::Mark& comma, const CsvRows::Mark& point, InputErrors& errors) {
    if (comma.field.empty() || point.field.empty()) {
        return;
    }
    const bool comma_is_later = comma.line.number > point.line.number;
    const CsvRows::Mark& later = comma_is_later ? comma : point;
    const CsvRows::Mark& first = comma_is_later ? point : comma;
    errors.add(csv.place(later.line, later.field),
               fmt::format("\"{}\" has a decimal {}, \"{}\" in line {} a decimal {}", later.field,
                           comma_is_later ? "comma" : "point", first.field, first.line.number,
                           comma_is_later ? "point" : "comma"),
               "export the file with one of them, and without marks between thousands");
}

void take_earlier(CsvRows::Mark& earliest, const CsvRows::Mark& mark) {
    earliest = mark.line.number < earliest.line.number ? mark : earliest;
}

}  // namespace

void Csv::report_lines(InputErrors& errors) const {
    const std::vector<CsvRows::Ragged>& ragged = rows_->ragged();
    if (ragged.empty() && rows_->size() == 0) {
        errors.add({.file = file_}, "the file has headings but no numbers");
    }
    const auto is_log = [&] {
        return std::ranges::any_of(heads_,
                                   [](const ColumnHead& head) { return head.is_clock || head.heading.name == "time"; });
    };
    ErrorLimiter limiter(errors);
    for (const auto& [line, fields] : ragged) {
        const bool is_last = trim({line.text.end(), body_.end()}).empty();
        if (fields < heads_.size() && is_last && rows_->size() > 0 && is_log()) {
            errors.warn(place(line, line.text),
                        fmt::format("the last line has {} of {} values: the logger stopped in it, and it is left out",
                                    fields, heads_.size()));
            continue;
        }
        if (limiter.only_counts()) {
            limiter.add({}, {});
            continue;
        }
        const bool too_many_commas = separates_by_commas() && fields > heads_.size();
        limiter.add(place(line, line.text),
                    {fmt::format("the line has {} values, the first line names {} columns", fields, heads_.size()),
                     too_many_commas
                         ? "if the numbers have decimal commas, export the file with semicolons or with decimal points"
                         : "complete or remove the line"});
    }
    limiter.close("the number of values");
}

void Csv::parse_all() const {
    std::vector<int> all(heads_.size());
    std::iota(all.begin(), all.end(), 0);
    rows_->parse(all, heads_);
}

std::optional<std::vector<double>> Csv::times_of(const ColumnRequest& request, InputErrors& errors) const {
    const ColumnHead& head = heads_[static_cast<std::size_t>(request.column)];
    const CsvRows::Column& column = rows_->column(request.column);
    const bool is_time = request.purpose == Purpose::clock;
    if (head.form != FieldForm::number) {
        const bool is_picture = request.purpose == Purpose::frame || request.purpose == Purpose::point;
        ClockTimes found = clock_times(column.stamp, head.form, head.heading, !is_picture);
        for (const std::string& remark : is_time ? found.remarks : std::vector<std::string>{}) {
            errors.warn(head.place, remark);
        }
        if (is_time && found.question) {
            errors.add(head.place, std::move(*found.question));
        }
        return std::move(found.seconds);
    }
    // Of numbers, two at one time are a jump and three a mistake, unless the clock is too coarse for all the lines.
    constexpr std::size_t least = 3;
    constexpr std::size_t looked_at = 5000;  // lines, before all are
    const std::vector<double>& written = column.number;
    const auto first = static_cast<std::ptrdiff_t>(is_time ? std::min(looked_at, written.size()) : 0);
    std::vector<double> times(written.begin(), written.begin() + first);
    if (share_out(times, least).empty()) {
        return std::nullopt;
    }
    times = written;
    const std::string remark = share_out(times, least);
    if (remark.empty()) {
        return std::nullopt;
    }
    errors.warn(head.place, fmt::format("{}: {}", head.heading.name, remark));
    return times;
}

std::vector<std::vector<double>> Csv::read(const std::vector<ColumnRequest>& requests, InputErrors& errors,
                                           bool last) const {
    const std::size_t before = errors.count();
    std::vector<int> wanted;
    std::ranges::transform(requests, std::back_inserter(wanted), &ColumnRequest::column);
    rows_->parse(wanted, heads_);
    report_lines(errors);
    CsvRows::Mark comma;
    CsvRows::Mark point;
    std::vector<std::vector<double>> values;
    for (const ColumnRequest& request : requests) {
        if (errors.count() > before + most_errors) {
            errors.add({.file = file_}, fmt::format("after {} errors the file is read no further", most_errors),
                       "correct those first");
            break;
        }
        const CsvRows::Column& column = rows_->column(request.column);
        const bool is_used = request.purpose != Purpose::unused;
        ColumnReader reader(heads_[static_cast<std::size_t>(request.column)], request, errors);
        const std::optional<std::vector<double>> times = times_of(request, errors);
        const std::vector<double>& numbers = times ? *times : column.number;
        reader.values.reserve(numbers.size());
        auto text = column.text.begin();
        for (std::size_t row = 0; row < numbers.size(); ++row) {
            const bool is_unread = text != column.text.end() && *text == row;
            text += is_unread ? 1 : 0;
            const bool is_no_day =
                row < column.stamp.size() && !std::isnan(column.stamp[row].seconds) && std::isnan(numbers[row]);
            reader.take(numbers[row], !is_unread && !is_no_day, [&] {
                const Line line = rows_->row(row);
                const std::string_view field = rows_->field(line, request.column);
                std::string room;
                const std::string_view number = separates_by_commas() ? field : with_point(field, room);
                return ColumnReader::FieldLocation{.place = place(line, field), .text = std::string(number)};
            });
        }
        reader.close();
        values.push_back(std::move(reader.values));
        if (is_used) {
            take_earlier(comma, column.comma);
            take_earlier(point, column.point);
        }
        if (last) {
            rows_->forget(request.column);
        }
    }
    report_both_marks(*this, comma, point, errors);
    return errors.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
