// SPDX-License-Identifier: BSD-3-Clause
// Finds the line of names and the line of units in a CSV file below the logger's own text.

#include <algorithm>
#include <deque>

#include "input/clock/clock.hpp"
#include "input/loggers/csv_layout.hpp"
#include "input/tables/csv.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

constexpr int searched = 500;  // lines; no logger writes more about itself

/// What the fields of a line are.
struct Fields {
    std::size_t written = 0;
    std::size_t all = 0;  ///< without an empty one after a last separator
    std::size_t numbers = 0;
    std::size_t ones = 0;  ///< numbers that are 1, which is also a unit
    std::size_t texts = 0;

    [[nodiscard]] bool are_names() const { return all >= 2 && texts >= 2 && numbers == 0; }
    [[nodiscard]] bool are_units() const { return texts >= 1 && numbers == ones; }
    [[nodiscard]] bool are_data() const { return numbers >= 1; }
    /// The last of them may be empty, as the unit of a pure number.
    [[nodiscard]] bool are_as_many_as(const Fields& others) const {
        return all == others.all || written == others.written;
    }
};

Fields count(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    split_fields(line, separator, fields);
    Fields counted{.written = fields.size()};
    if (fields.size() > 1 && fields.back().empty()) {
        fields.pop_back();
    }
    counted.all = fields.size();
    for (const std::string_view field : fields) {
        const std::optional<Number> number = leading_number(field);
        if (is_clock(field)) {
            ++counted.numbers;
        } else if (number && (number->rest.empty() || number->rest.starts_with(','))) {
            ++counted.numbers;
            counted.ones += number->value == 1.0 && number->rest.empty() ? 1 : 0;
        } else if (!field.empty()) {
            ++counted.texts;
        }
    }
    return counted;
}

bool has_unit(std::string_view line) {
    std::vector<std::string_view> fields;
    split_fields(line, separator_of(line), fields);
    return std::any_of(fields.begin(), fields.end(), [](std::string_view field) {
        const Heading heading = read_heading(field);
        return !heading.name.empty() && heading.unit.has_value();
    });
}

/// A line and what follows it.
struct HeadStep {
    CsvLine line;
    std::string_view rest;
};

/// A table of numbers under a comment that names its columns: "# time [s], speed [km/h]".
std::optional<HeadLines> names_in_comment(const CsvLine& comment, const CsvLine& first, std::string_view text) {
    if (comment.number == 0 || first.number == 0) {
        return std::nullopt;
    }
    std::string_view names = trim(comment.text);
    names.remove_prefix(std::min(names.find_first_not_of("#/ \t"), names.size()));
    const char separator = separator_of(first.text);
    const Fields values = count(first.text, separator);
    const Fields named = count(names, separator);
    if (values.numbers != values.all || named.numbers > 0 || named.all != values.all || named.texts != named.all) {
        return std::nullopt;
    }
    const std::size_t end = text.find('\n', static_cast<std::size_t>(comment.text.data() - text.data()));
    return HeadLines{
        .names = {names, comment.number}, .units = {}, .body = text.substr(std::min(end, text.size() - 1) + 1)};
}

}  // namespace

HeadLines find_head_lines(std::string_view text) {
    std::deque<HeadStep> next;
    std::string_view rest = text;
    CsvLine comment;  // the last one above the table
    const auto step = [&] {
        const int last = next.empty() ? comment.number : next.back().line.number;
        const CsvLine line = next_filled_line(rest, last);
        next.push_back({line, rest});
    };
    step();
    while (is_comment(next.front().line.text)) {
        comment = next.front().line;
        next.clear();
        step();
    }
    if (const std::optional<HeadLines> named = names_in_comment(comment, next.front().line, text)) {
        return *named;
    }
    const HeadLines first{.names = next.front().line, .units = {}, .body = next.front().rest};
    if (has_unit(first.names.text)) {
        return first;
    }
    step();
    step();
    while (next[1].line.number > 0 && next[0].line.number <= searched) {
        const char separator = separator_of(next[0].line.text);
        const Fields names = count(next[0].line.text, separator);
        const Fields second = count(next[1].line.text, separator);
        if (names.are_names() && second.are_as_many_as(names)) {
            const Fields third = count(next[2].line.text, separator);
            if (second.are_units() && third.are_as_many_as(names) && third.are_data() && !third.are_units()) {
                return {.names = next[0].line, .units = next[1].line, .body = next[1].rest};
            }
            if (second.are_data() && !second.are_units()) {
                return {.names = next[0].line, .units = {}, .body = next[0].rest};
            }
        }
        next.pop_front();
        next.back().line.number > 0 ? step() : next.push_back(next.back());
    }
    return first;
}

}  // namespace tiretherm::input
