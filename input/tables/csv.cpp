// SPDX-License-Identifier: BSD-3-Clause
// Splits lines into fields (separator, quotes, blanks), reads the headings and finds the place of a row.

#include "input/tables/csv.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/loggers/clock_columns.hpp"
#include "input/loggers/clock_words.hpp"
#include "input/loggers/csv_layout.hpp"
#include "input/loggers/heading_names.hpp"
#include "input/text/suggestions.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::input {

namespace {

std::string_view unquoted(std::string_view field) {
    field = trim(field);
    return field.size() > 1 && field.front() == '"' && field.back() == '"' ? trim(field.substr(1, field.size() - 2))
                                                                           : field;
}

/// Where the first field of a line ends. A quote that is not closed before a separator is a character like any other.
std::size_t end_of_field(std::string_view line, char separator) {
    const std::size_t first = line.find_first_not_of(" \t");
    if (first != std::string_view::npos && line[first] == '"') {
        std::size_t closing = line.find('"', first + 1);
        while (closing != std::string_view::npos && line.substr(closing + 1).starts_with('"')) {  // a quote within
            closing = line.find('"', closing + 2);
        }
        const std::size_t after =
            closing == std::string_view::npos ? closing : line.find_first_not_of(' ', closing + 1);
        if (closing != std::string_view::npos && (after == std::string_view::npos || line[after] == separator)) {
            return std::min(after, line.size());
        }
    }
    return std::min(line.find(separator), line.size());
}

}  // namespace

int count_characters(std::string_view text) {
    int count = 0;
    bool open = false;  // a character of several bytes is under way
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (!open || (byte & 0xC0U) != 0x80U) {
            ++count;
            open = byte >= 0x80U;
        }
    }
    return count;
}

std::string_view with_point(std::string_view field, std::string& room) {
    const std::size_t comma = field.find(',');
    const auto digit = [&](std::size_t i) { return i < field.size() && field[i] >= '0' && field[i] <= '9'; };
    if (comma == std::string_view::npos || comma == 0 || !digit(comma - 1) || !digit(comma + 1) ||
        field.find_first_not_of("+-.eE0123456789,") != std::string_view::npos ||
        field.find_first_of(",.", comma + 1) != std::string_view::npos || field.find('.') < comma) {
        return field;
    }
    room.assign(field);
    room[comma] = '.';
    return room;
}

char separator_of(std::string_view headings) {
    for (const char candidate : {'\t', ';'}) {
        if (headings.find(candidate) != std::string_view::npos) {
            return candidate;
        }
    }
    return ',';
}

std::optional<std::string_view> next_line(std::string_view& text) {
    solver::leave_reading_if_stopped();
    if (text.empty()) {
        return std::nullopt;
    }
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    return line;
}

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\",;") == std::string_view::npos; }

namespace {

template <typename IsEmpty>
Csv::Line next_line_but(std::string_view& text, int last, IsEmpty is_empty) {
    for (int number = last + 1; const auto line = next_line(text); ++number) {
        if (!is_empty(*line)) {
            return {*line, number};
        }
    }
    return {};
}

}  // namespace

Csv::Line next_filled_line(std::string_view& text, int last) { return next_line_but(text, last, is_blank); }

Csv::Line next_written_line(std::string_view& text, int last) {
    return next_line_but(text, last, [](std::string_view line) { return trim(line).empty(); });
}

void split_fields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    if (separator == ' ') {
        line = trim(line);
    }
    while (true) {
        const std::size_t end = end_of_field(line, separator);
        fields.push_back(unquoted(line.substr(0, end)));
        if (end == line.size()) {
            return;
        }
        line.remove_prefix(end + 1);
        if (separator == ' ') {  // several blanks are one
            line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
        }
    }
}

SourceLocation Csv::place(const Line& line, std::string_view field) const {
    const std::string_view before = line.text.substr(0, static_cast<std::size_t>(field.data() - line.text.data()));
    return {.file = file_,
            .line = line.number,
            .column = count_characters(before) + 1,
            .length = std::max(1, count_characters(field))};
}

std::vector<SourceLocation> Csv::places(const Line& line, const std::vector<std::string_view>& fields) const {
    std::vector<SourceLocation> found;
    found.reserve(fields.size());
    int column = 1;
    const char* from = line.text.data();
    for (const std::string_view field : fields) {
        column += count_characters({from, static_cast<std::size_t>(field.data() - from)});
        from = field.data();
        found.push_back(
            {.file = file_, .line = line.number, .column = column, .length = std::max(1, count_characters(field))});
    }
    return found;
}

void Csv::read_heads(const CsvLayout& layout) {
    std::vector<std::string_view> fields;
    split_fields(layout.lines.names.text, separator_, fields);
    heads_.reserve(fields.size());
    for (const SourceLocation& spot : places(layout.lines.names, fields)) {
        std::string field(fields[heads_.size()]);
        for (std::size_t at = 0; (at = field.find("\"\"", at)) != std::string::npos; ++at) {
            field.erase(at, 1);  // a quote within quotes
        }
        heads_.push_back({.heading = layout.round_brackets ? read_round_heading(field) : read_heading_of_logger(field),
                          .place = spot});
    }
    read_units(layout);
    for (ColumnHead& head : heads_) {
        const auto known = std::ranges::find(layout.known, head.heading.name, &KnownColumn::heading);
        if (known != layout.known.end()) {
            head.heading.name = known->name.empty() ? head.heading.name : std::string(known->name);
            head.heading.unit = head.heading.unit ? head.heading.unit : std::optional<std::string>(known->unit);
        }
    }
    if (layout.sources.number > 0) {
        split_fields(layout.sources.text, separator_, fields);
        distinguish(heads_, fields);
    }
    if (description_.format != LogDescription().format) {
        number_duplicates(heads_);
    }
}

void Csv::read_units(const CsvLayout& layout) {
    for (std::size_t i = 0; i < std::min(layout.units.size(), heads_.size()); ++i) {
        if (!layout.units[i].empty()) {
            heads_[i].heading.unit = layout.units[i];
        }
    }
    if (layout.lines.units.text.empty()) {
        return;
    }
    std::vector<std::string_view> fields;
    split_fields(layout.lines.units.text, separator_, fields);
    const std::vector<SourceLocation> spots = places(layout.lines.units, fields);
    for (std::size_t i = 0; i < std::min(fields.size(), heads_.size()); ++i) {
        ColumnHead& head = heads_[i];
        // An empty unit in a line of units is as good as none: the pure numbers of loggers are mostly unknown units.
        if (!head.heading.unit && !fields[i].empty()) {
            const Heading bracketed = read_heading(fields[i]);
            head.heading.unit = bracketed.name.empty() && bracketed.unit ? *bracketed.unit : std::string(fields[i]);
            head.unit_place = spots[i];
        }
    }
}

void Csv::visit_column(std::size_t column, const FieldVisitor& take) const {
    CsvLine line;
    std::string_view rest = body_;
    std::vector<std::string_view> fields;
    while (next_row(rest, names_, line)) {
        split_fields(line.text, separator_, fields);
        if (column >= fields.size() || !take(fields[column])) {
            return;
        }
    }
}

void Csv::find_clocks() {
    std::string_view rest = body_;
    Line first;
    static_cast<void>(next_row(rest, names_, first));
    take_time_units(heads_);
    std::vector<std::string_view> fields;
    split_fields(first.text, separator_, fields);
    fields.resize(std::min(fields.size(), heads_.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) {
        ColumnHead& head = heads_[i];
        const bool is_vbox = description_.west_is_positive && head.heading.name == "time" && !is_clock(fields[i]);
        head.form = is_vbox ? FieldForm::digits
                            : form_of(head, fields[i], [&](const FieldVisitor& take) { visit_column(i, take); });
        if (head.form != FieldForm::number && !clock_spelling(head.heading.unit.value_or(""))) {
            head.heading.unit = "s";
            head.unit_place = {};
        }
    }
    mark_clock(heads_);
    find_dates(heads_, fields);
}

std::optional<Csv> Csv::open(const TextFile& file, InputErrors& errors) {
    Csv csv;
    csv.file_ = file.number;
    std::string_view text = file.text;
    if (text.starts_with("\xEF\xBB\xBF")) {
        text.remove_prefix(3);
    }
    CsvLayout layout = find_csv_layout(text);
    if (layout.defect) {
        errors.add({.file = file.number, .line = layout.defect_line, .column = 1, .length = 1},
                   std::move(*layout.defect));
        return std::nullopt;
    }
    csv.names_ = layout.lines.names.text;
    csv.body_ = layout.lines.body;
    csv.separator_ = layout.separator;
    csv.description_ = std::move(layout.description);
    csv.read_heads(layout);
    if (leading_number(csv.heads_.front().heading.name)) {
        errors.add(csv.heads_.front().place, "the first line holds numbers; it must name the columns",
                   "write a first line such as time [s],speed [km/h]");
        return std::nullopt;
    }
    for (const ColumnHead& head : csv.heads_) {
        constexpr std::size_t longest = 1000;  // bytes; every page and message repeats it
        const std::size_t size = std::max(head.heading.name.size(), head.heading.unit.value_or("").size());
        if (size > longest) {
            errors.add(head.place, fmt::format("the heading of a column has {} characters", size),
                       "name each column in a few words, as in time [s],speed [km/h]");
            return std::nullopt;
        }
    }
    csv.find_clocks();
    csv.rows_ = errors.rows(csv.file_);
    if (!csv.rows_) {
        const int last = std::max({layout.lines.names.number, layout.lines.units.number, layout.sources.number});
        csv.rows_ = std::make_shared<CsvRows>(csv.body_, last + 1, csv.separator_, csv.names_, csv.heads_.size());
        errors.rows(csv.file_) = csv.rows_;
    }
    return csv;
}

SourceLocation Csv::row(std::size_t index) const {
    const Line line = rows_->row(index);
    return place(line, line.text);
}

int Csv::find(std::string_view name) const {
    const auto found =
        std::find_if(heads_.begin(), heads_.end(), [&](const ColumnHead& head) { return head.heading.name == name; });
    return found == heads_.end() ? -1 : static_cast<int>(found - heads_.begin());
}

}  // namespace tiretherm::input
