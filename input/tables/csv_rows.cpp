// SPDX-License-Identifier: BSD-3-Clause
// Splits the lines and parses their fields; finds a row again from the last one that was marked.

#include "input/tables/csv_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/text/characters.hpp"
#include "input/text/error_limiter.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t marked_rows = 256;  // from one row that is marked to the next

/// A column that is being parsed.
class ColumnParser {
public:
    ColumnParser(TableColumn& into, std::size_t column, bool may_have_commas)
        : into_(&into), column_(column), commas_(may_have_commas) {}

    void reserve(std::size_t rows) {
        into_->head.form == FieldForm::number ? into_->number.reserve(rows) : into_->stamp.reserve(rows);
    }
    void take(const std::vector<std::string_view>& fields, const CsvLine& line) {
        into_->head.form == FieldForm::number ? take_number(fields[column_], line)
                                              : take_clock(fields[column_], fields);
    }

private:
    void take_number(std::string_view field, const CsvLine& line) {
        const std::string_view point = commas_ ? with_point(field, room_) : field;
        const std::optional<Number> number = leading_number(point);
        const bool is_number = number && number->rest.empty();
        if (!is_number && !is_no_reading(field)) {
            into_->text.push_back(static_cast<std::uint32_t>(into_->number.size()));
        }
        into_->number.push_back(is_number ? number->value : std::numeric_limits<double>::quiet_NaN());
        if (commas_) {
            const bool is_comma = field.data() != point.data();
            DecimalMark& mark = is_comma ? into_->comma : into_->point;
            if (mark.place.line == 0 && (is_comma || (is_number && field.find('.') != std::string_view::npos))) {
                mark = {.place = place_in(line, field), .field = std::string(field)};
            }
        }
    }

    void take_clock(std::string_view written, const std::vector<std::string_view>& fields) {
        const std::string_view field = is_no_reading(written) ? std::string_view() : written;
        std::string_view clock = field;
        if (into_->head.date_column >= 0 && !field.empty()) {
            room_.assign(fields[static_cast<std::size_t>(into_->head.date_column)]).append(" ").append(field);
            clock = room_;
        }
        const Stamp stamp = read_stamp(clock, into_->head.form);
        if (std::isnan(stamp.seconds) && !field.empty()) {
            into_->text.push_back(static_cast<std::uint32_t>(into_->stamp.size()));
        }
        into_->stamp.push_back(stamp);
    }

    TableColumn* into_;
    std::size_t column_;
    bool commas_;
    std::string room_;
};

/// Whether fields in quotes have decimal commas although commas separate the columns: "12,5". Three digits may stand behind a mark
/// between thousands as well.
bool has_quoted_commas(std::string_view body) {
    constexpr std::size_t looked_at = 100'000;  // bytes
    body = body.substr(0, looked_at);
    std::string room;
    std::vector<std::string_view> fields;
    while (const auto line = body.find('"') == std::string_view::npos ? std::nullopt : next_line(body)) {
        split_fields(*line, ',', fields);
        const bool has_one = std::ranges::any_of(fields, [&](std::string_view field) {
            const std::size_t comma = field.find(',');
            return comma != std::string_view::npos && with_point(field, room).data() != field.data() &&
                   field.find_first_not_of("0123456789", comma + 1) == std::string_view::npos &&
                   field.size() - comma - 1 != 3;
        });
        if (has_one) {
            return true;
        }
    }
    return false;
}

}  // namespace

bool next_row(std::string_view& rest, std::string_view names, CsvLine& line) {
    while (const auto text = next_line(rest)) {
        line = {*text, line.number + 1};
        if (!is_blank(line.text) && !is_comment(line.text) && line.text != names) {
            return true;
        }
    }
    return false;
}

bool CsvRows::is_row(const std::vector<std::string_view>& fields) const {
    return fields.size() == n_columns_ || (fields.size() == n_columns_ + 1 && fields.back().empty());
}

void CsvRows::parse(std::vector<TableColumn>& columns, InputErrors& errors) {
    n_columns_ = columns.size();
    const std::shared_ptr<const std::string> text = source_->get();
    const std::string_view body = std::string_view(*text).substr(body_);
    const auto lines = static_cast<std::size_t>(std::ranges::count(body, '\n')) + 1;
    has_commas_ = separator_ != ',' || has_quoted_commas(body);
    std::vector<ColumnParser> parsers;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        parsers.emplace_back(columns[i], i, has_commas_).reserve(std::min(lines, body.size() / n_columns_ + 1));
    }
    std::vector<Ragged> ragged;
    using Fields = std::vector<std::string_view>;
    each(
        [&](const CsvLine& line, const Fields& fields) {
            if (n_rows_ % marked_rows == 0) {
                marked_.push_back({static_cast<std::size_t>(line.text.data() - text->data()), line.number});
            }
            for (ColumnParser& parser : parsers) {
                parser.take(fields, line);
            }
            ++n_rows_;
        },
        [&](const CsvLine& line, const Fields& fields) {
            ragged.push_back({line, fields.size()});
        });
    const auto is_time = [](const TableColumn& column) {
        return column.head.is_clock || column.head.heading.name == "time";
    };
    report(ragged, text->data() + text->size(), std::ranges::any_of(columns, is_time), errors);
}

void CsvRows::report(const std::vector<Ragged>& ragged, const char* end, bool is_log, InputErrors& errors) const {
    if (ragged.empty() && n_rows_ == 0) {
        errors.add({.file = 0}, "the file has headings but no numbers");
    }
    ErrorLimiter limiter(errors);
    for (const auto& [line, fields] : ragged) {
        const bool is_last = trim({line.text.data() + line.text.size(), end}).empty();
        if (fields < n_columns_ && is_last && n_rows_ > 0 && is_log) {
            errors.warn(place_in(line, line.text), "the last line has {} of {} values: it is incomplete and left out",
                        fields, n_columns_);
            continue;
        }
        if (limiter.only_counts()) {
            limiter.add({}, {});
            continue;
        }
        limiter.add(place_in(line, line.text),
                    {fmt::format("the line has {} values, the first line names {} columns", fields, n_columns_),
                     separator_ == ',' && fields > n_columns_
                         ? "if the numbers have decimal commas, export the file with semicolons or with decimal points"
                         : "complete or remove the line"});
    }
    limiter.close("the number of values");
}

CsvLine CsvRows::line_of(std::size_t row, std::string_view text) const {
    const Mark& mark = marked_[row / marked_rows];
    std::string_view rest = text.substr(mark.begin);
    CsvLine line{next_line(rest).value_or(""), mark.number};
    std::vector<std::string_view> fields;
    for (std::size_t left = row % marked_rows; left > 0 && next_row(rest, names_, line);) {
        split_fields(line.text, separator_, fields);
        left -= is_row(fields) ? 1 : 0;
    }
    return line;
}

FieldLocation CsvRows::where(std::size_t row, int column) const {
    const std::shared_ptr<const std::string> text = source_->get();
    if (text->empty()) {
        return {.place = {.file = 0}};
    }
    const CsvLine line = line_of(row, *text);
    if (column < 0) {
        return {.place = place_in(line, line.text)};
    }
    std::vector<std::string_view> fields;
    split_fields(line.text, separator_, fields);
    const std::string_view field = fields[static_cast<std::size_t>(column)];
    std::string room;
    return {.place = place_in(line, field), .text = std::string(has_commas_ ? with_point(field, room) : field)};
}

}  // namespace tiretherm::input
