// SPDX-License-Identifier: BSD-3-Clause
// Splits the lines and parses the columns that are asked for; finds a row again from the last one that was marked.

#include "input/tables/csv_rows.hpp"

#include <algorithm>
#include <cmath>

#include "input/loggers/csv_layout.hpp"
#include "input/tables/csv.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t marked_rows = 256;  // from one row that is marked to the next

/// A column that is being parsed.
class ColumnParser {
public:
    ColumnParser(CsvRows::Column& into, int column, int date_column, bool may_have_commas)
        : into_(&into),
          column_(static_cast<std::size_t>(column)),
          date_column_(date_column),
          commas_(may_have_commas) {}

    void reserve(std::size_t rows) {
        into_->form == FieldForm::number ? into_->number.reserve(rows) : into_->stamp.reserve(rows);
    }
    void take(const std::vector<std::string_view>& fields, const CsvLine& line) {
        // A dash is what loggers of phones write where they have no value.
        const std::string_view field = fields[column_] == "-" ? std::string_view() : fields[column_];
        into_->form == FieldForm::number ? take_number(field, line) : take_clock(field, fields);
    }

private:
    void take_number(std::string_view field, const CsvLine& line) {
        const std::string_view point = commas_ ? with_point(field, room_) : field;
        const std::optional<Number> number = leading_number(point);
        const bool is_number = number && number->rest.empty();
        if (!is_number && !field.empty()) {
            into_->text.push_back(static_cast<std::uint32_t>(into_->number.size()));
        }
        into_->number.push_back(is_number ? number->value : std::numeric_limits<double>::quiet_NaN());
        if (commas_) {
            const bool is_comma = field.data() != point.data();
            CsvRows::Mark& mark = is_comma ? into_->comma : into_->point;
            if (mark.field.empty() && (is_comma || (is_number && field.find('.') != std::string_view::npos))) {
                mark = {field, line};
            }
        }
    }

    void take_clock(std::string_view field, const std::vector<std::string_view>& fields) {
        std::string_view clock = field;
        if (date_column_ >= 0 && !field.empty()) {
            room_.assign(fields[static_cast<std::size_t>(date_column_)]).append(" ").append(field);
            clock = room_;
        }
        const Stamp stamp = read_stamp(clock, into_->form);
        if (std::isnan(stamp.seconds) && !field.empty()) {
            into_->text.push_back(static_cast<std::uint32_t>(into_->stamp.size()));
        }
        into_->stamp.push_back(stamp);
    }

    CsvRows::Column* into_;
    std::size_t column_;
    int date_column_;
    bool commas_;
    std::string room_;
};

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

void CsvRows::parse(const std::vector<int>& columns, const std::vector<ColumnHead>& heads) {
    const std::lock_guard lock(parsing_);
    std::vector<ColumnParser> parsers;
    for (const int index : columns) {
        const ColumnHead& head = heads[static_cast<std::size_t>(index)];
        const auto [at, is_new] = columns_.try_emplace(index);
        if (is_new || at->second.form != head.form) {
            at->second = {.form = head.form};
            parsers.emplace_back(at->second, index, head.date_column, separator_ != ',');
        }
    }
    const bool is_first = lines_split_ == 0;
    if (parsers.empty() && !is_first) {
        return;
    }
    const auto lines = static_cast<std::size_t>(std::ranges::count(body_, '\n')) + 1;
    for (ColumnParser& parser : parsers) {
        parser.reserve(std::min(lines, body_.size() / n_columns_ + 1));
    }
    std::size_t row = 0;
    std::string_view rest = body_;
    std::vector<std::string_view> fields;
    for (CsvLine line{{}, first_line_ - 1}; next_row(rest, names_, line);) {
        split_fields(line.text, separator_, fields);
        ++lines_split_;
        if (!is_row(fields)) {
            if (is_first) {
                ragged_.push_back({line, fields.size()});
            }
            continue;
        }
        if (is_first && row % marked_rows == 0) {
            marked_.push_back(line);
        }
        for (ColumnParser& parser : parsers) {
            parser.take(fields, line);
        }
        ++row;
    }
    if (is_first) {
        size_ = row;
    }
}

CsvLine CsvRows::row(std::size_t index) const {
    CsvLine line = marked_[index / marked_rows];
    std::string_view rest = body_.substr(static_cast<std::size_t>(line.text.begin() - body_.begin()));
    static_cast<void>(next_line(rest));
    std::vector<std::string_view> fields;
    for (std::size_t left = index % marked_rows; left > 0 && next_row(rest, names_, line);) {
        split_fields(line.text, separator_, fields);
        left -= is_row(fields) ? 1 : 0;
    }
    return line;
}

std::string_view CsvRows::field(const CsvLine& row, int column) const {
    std::vector<std::string_view> fields;
    split_fields(row.text, separator_, fields);
    return fields[static_cast<std::size_t>(column)];
}

}  // namespace tiretherm::input
