// SPDX-License-Identifier: BSD-3-Clause
// CSV exports of AiM RaceStudio and MoTeC i2. Both begin with "Format","... CSV File"; the names of the columns follow the
// first empty line.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/text/characters.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr int most_details = 500;  ///< lines

/// The format that the first line names; empty for another file.
std::string format_of(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    split_fields(line, separator, fields);
    if (fields.size() < 2 || fields[0] != "Format") {
        return {};
    }
    if (distance(fields[1], "AiM CSV File") == 0) {
        return "AiM CSV";
    }
    return distance(fields[1], "MoTeC CSV File") == 0 ? "MoTeC CSV" : "";
}

/// Times of the marks: one in each field, or all in one field with blanks between them.
/// @param markers out: s, ascending  @returns what is no time; empty: nothing
std::string read_markers(const std::vector<std::string>& fields, std::vector<double>& markers) {
    std::string room;
    for (const std::string& field : fields) {
        std::string_view rest = trim(field);
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            const auto number = leading_number(with_point(rest.substr(0, end), room));
            if (!number || !number->rest.empty() || !std::isfinite(number->value)) {
                return std::string(rest.substr(0, end));
            }
            markers.push_back(number->value);
            rest = trim(rest.substr(end));
        }
    }
    std::ranges::sort(markers);
    return {};
}

/// Whether a line of units is one of values: the first field, the time, is a number.
bool has_values(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    split_fields(line, separator, fields);
    return leading_number(fields.front()).has_value();
}

std::string first_field(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    split_fields(line, separator, fields);
    return std::string(fields.front());
}

/// Whether a line has the names of the columns although no empty line stands above it: the next one has the unit of the time.
bool has_names(std::string_view line, std::string_view rest, char separator) {
    const std::string_view next = next_line(rest).value_or("");
    const std::string unit = first_field(next, separator);
    return first_field(line, separator) == "Time" && (unit == "s" || unit == "sec");
}

}  // namespace

std::optional<CsvLayout> find_key_value_layout(std::string_view text) {
    std::string_view rest = text;
    const std::optional<std::string_view> first = next_line(rest);
    const char separator = first ? separator_of(*first) : ',';
    const std::string format = first ? format_of(*first, separator) : "";
    if (format.empty()) {
        return std::nullopt;
    }
    CsvLayout layout;
    layout.separator = separator;
    layout.description.format = format;
    const auto refuse = [&](int line, std::string what, std::string remedy) {
        layout.defect_line = line;
        layout.defect = ErrorText{std::move(what), std::move(remedy)};
        return layout;
    };
    int number = 1;
    bool ended = false;
    while (!ended && number < most_details) {
        const std::optional<std::string_view> line = next_line(rest);
        ++number;
        if (!line) {
            return refuse(number - 1, fmt::format("the file ends within the head of an {} file", format),
                          "export the session again: names, units and values of the channels follow an empty line");
        }
        if (has_names(*line, rest, separator)) {
            layout.lines.names = {*line, number};
        }
        ended = is_blank(*line) || layout.lines.names.number > 0;
        if (!ended) {
            const std::vector<std::string> values = read_detail(*line, separator, layout.description);
            if (line->find("Beacon Markers") < 3) {
                const std::string wrong = read_markers(values, layout.description.markers);
                if (!wrong.empty() && layout.description.markers.empty() && values.size() == 1) {
                    layout.description.details.push_back(
                        {"Beacon markers", fmt::format("none, but \"{}\"", printable(wrong))});
                } else if (!wrong.empty()) {
                    return refuse(number, fmt::format("the beacon marker \"{}\" is no time", wrong),
                                  "write it in seconds, as 145.982, or remove it");
                }
                std::erase_if(layout.description.details,
                              [](const LogDetail& detail) { return detail.name == "Beacon Markers"; });
            }
        }
    }
    if (layout.lines.names.number == 0) {
        layout.lines.names = next_filled_line(rest, number);
    }
    layout.lines.units = next_written_line(rest, layout.lines.names.number);
    layout.lines.body = rest;
    if (layout.lines.names.number == 0 || layout.lines.units.number == 0) {
        return refuse(number, fmt::format("the {} file has no channels", format),
                      "export the session with its channels: names, units and values follow an empty line");
    }
    if (has_values(layout.lines.names.text, separator)) {
        return refuse(
            layout.lines.names.number, "values stand where the names of the channels are expected",
            fmt::format("in an {} file the empty line is followed by a line of names, then one of units", format));
    }
    if (has_values(layout.lines.units.text, separator)) {
        return refuse(layout.lines.units.number, "values stand where the units of the channels are expected",
                      fmt::format("in an {} file a line of units follows the names: export the session again", format));
    }
    return layout;
}

}  // namespace tiretherm::input
