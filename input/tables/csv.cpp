// SPDX-License-Identifier: BSD-3-Clause
// Splits lines into fields (separator, quotes, blanks) and counts characters.

#include "input/tables/csv.hpp"

#include <algorithm>
#include <array>

#include "input/text/characters.hpp"
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
    std::size_t first = 0;
    while (first < line.size() && (line[first] == ' ' || line[first] == '\t')) {
        ++first;
    }
    if (first < line.size() && line[first] == '"') {
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
CsvLine next_line_but(std::string_view& text, int last, IsEmpty is_empty) {
    for (int number = last + 1; const auto line = next_line(text); ++number) {
        if (!is_empty(*line)) {
            return {*line, number};
        }
    }
    return {};
}

}  // namespace

CsvLine next_filled_line(std::string_view& text, int last) { return next_line_but(text, last, is_blank); }

CsvLine next_written_line(std::string_view& text, int last) {
    return next_line_but(text, last, [](std::string_view line) { return trim(line).empty(); });
}

bool is_no_reading(std::string_view field) {
    constexpr std::array<std::string_view, 11> words{"",    "-",    "--", "---", "\u2013", "\u2014",
                                                     "n/a", "#n/a", "na", "nan", "null"};
    return std::ranges::find(words, in_small_letters(field)) != words.end();
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

SourceLocation place_in(const CsvLine& line, std::string_view field) {
    const std::string_view before = line.text.substr(0, static_cast<std::size_t>(field.data() - line.text.data()));
    return {.file = 0,
            .line = line.number,
            .column = count_characters(before) + 1,
            .length = std::max(1, count_characters(field))};
}

}  // namespace tiretherm::input
