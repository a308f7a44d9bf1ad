// SPDX-License-Identifier: BSD-3-Clause
// Files .vbo of Racelogic's VBOX. Sections: [header] titles of the columns, [channel units] of those that are not standard,
// [laptiming] lines across the track as two points (longitude and latitude in minutes, west positive), [column names],
// [data] separated by blanks.   Racelogic, "VBO file structure", developers.racelogic.co.uk

#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

struct Section {
    int line = 0;
    std::vector<Csv::Line> lines{};  ///< [channel units] keeps its empty ones
};

std::string lower(std::string_view text) {
    std::string result(text);
    for (char& c : result) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return result;
}

const std::map<std::string, std::string, std::less<>>& standard_units() {
    static const std::map<std::string, std::string, std::less<>> units{
        {"sats", "1"},         {"time", "s"},      {"lat", "arcminute"}, {"long", "arcminute"},
        {"velocity", "km/h"},  {"heading", "deg"}, {"height", "m"},      {"vert-vel", "km/h"},
        {"vertvel", "km/h"},   {"longacc", "g"},   {"latacc", "g"},      {"distance", "m"},
        {"por_distance", "m"}, {"event1", "s"},    {"event-1", "s"},     {"glonass_sats", "1"},
        {"solution_type", "1"}};
    return units;
}

/// What the columns that every VBOX has are in, where their title does not end in a unit.
std::string standard_unit(const std::string& name, std::string_view title) {
    struct Ending {
        std::string_view word;
        std::string_view unit;
    };
    constexpr std::array endings{Ending{"kmh", "km/h"},   Ending{"km/h", "km/h"}, Ending{"mph", "mph"},
                                 Ending{"knots", "knot"}, Ending{"m/s", "m/s"},   Ending{"g", "g"},
                                 Ending{"m", "m"},        Ending{"s", "s"},       Ending{"deg", "deg"}};
    const std::string text = lower(title);
    for (const Ending& ending : endings) {
        if (text.ends_with(" " + std::string(ending.word))) {
            return std::string(ending.unit);
        }
    }
    const auto found = standard_units().find(lower(name));
    return found == standard_units().end() ? std::string() : found->second;
}

bool is_standard(std::string_view name) { return standard_units().contains(lower(name)); }

/// "Start +5773.465840 +1832.282700 +5773.468800 +1832.204030 name"; nothing for another line.
std::optional<StartLine> read_start_line(std::string_view line) {
    std::vector<std::string_view> fields;
    split_fields(trim(line), ' ', fields);
    if (fields.size() < 5 || lower(fields[0]) != "start") {
        return std::nullopt;
    }
    std::array<double, 4> degrees{};
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const auto number = leading_number(fields[i + 1]);
        if (!number || !number->rest.empty() || !(number->value > -21600.0 && number->value < 21600.0)) {
            return std::nullopt;
        }
        degrees[i] = number->value / 60.0;
    }
    return StartLine{
        .latitude_a = degrees[1], .longitude_a = -degrees[0], .latitude_b = degrees[3], .longitude_b = -degrees[2]};
}

}  // namespace

std::optional<CsvLayout> find_vbox_layout(std::string_view text) {
    constexpr std::size_t searched = 4096;  // bytes in which the first section begins
    if (text.substr(0, searched).find("[header]") == std::string_view::npos ||
        text.find("[column names]") == std::string_view::npos) {
        return std::nullopt;
    }
    CsvLayout layout;
    layout.description.format = "VBOX .vbo";
    layout.description.west_is_positive = true;
    layout.separator = ' ';
    std::map<std::string, Section, std::less<>> sections;
    Section* open = nullptr;
    std::string_view rest = text;
    int number = 0;
    bool found_data = false;
    while (!found_data) {
        const std::optional<std::string_view> line = next_line(rest);
        if (!line) {
            break;
        }
        ++number;
        const std::string_view trimmed = trim(*line);
        if (trimmed.starts_with('[') && trimmed.ends_with(']')) {
            const std::string name = lower(trimmed.substr(1, trimmed.size() - 2));
            found_data = name == "data";
            open = &sections[name];
            open->line = number;
        } else if (open != nullptr) {
            open->lines.push_back({trimmed, number});
        } else if (trimmed.starts_with("File created on ")) {
            layout.description.details.push_back({"Date", printable(trimmed.substr(16))});
        }
    }
    const auto filled = [&](std::string_view name) {
        std::vector<Csv::Line> lines;
        for (const Csv::Line& line : sections[std::string(name)].lines) {
            if (!line.text.empty()) {
                lines.push_back(line);
            }
        }
        return lines;
    };
    const std::vector<Csv::Line> names = filled("column names");
    if (names.empty() || !found_data) {
        layout.defect_line = number;
        layout.defect =
            ErrorText{fmt::format("the VBOX file has no section [{}]", names.empty() ? "column names" : "data"),
                      "save the session again: [column names] and [data] follow the head"};
        return layout;
    }
    const std::size_t end = rest.find("\n[");
    layout.lines = {.names = names.front(), .units = {.text = {}, .number = number}, .body = rest.substr(0, end)};
    if (const std::size_t timing = rest.find("\n[laptiming]"); timing != std::string_view::npos) {
        rest.remove_prefix(timing + 1);
        static_cast<void>(next_line(rest));
        while (const std::optional<std::string_view> line = next_line(rest)) {
            sections["laptiming"].lines.push_back({trim(*line), number});
        }
    }
    for (const Csv::Line& line : filled("comments")) {
        const std::size_t colon = line.text.find(':');
        if (colon != std::string_view::npos && !trim(line.text.substr(colon + 1)).empty()) {
            layout.description.details.push_back(
                {printable(trim(line.text.substr(0, colon))), printable(trim(line.text.substr(colon + 1)))});
        }
    }
    for (const Csv::Line& line : filled("laptiming")) {
        if (!layout.description.start_line) {
            layout.description.start_line = read_start_line(line.text);
        }
    }
    std::vector<std::string_view> columns;
    split_fields(names.front().text, ' ', columns);
    const std::vector<Csv::Line> titles = filled("header");
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool titled = titles.size() == columns.size();
        layout.units.push_back(standard_unit(std::string(columns[i]), titled ? titles[i].text : std::string_view()));
    }
    // One line for each column that is not standard, an empty one for a column without unit. Some write one for every column.
    std::vector<Csv::Line> units = sections["channel units"].lines;
    const std::size_t n_units = filled("channel units").size();
    const bool for_all = n_units >= columns.size();
    const auto own = static_cast<std::size_t>(std::ranges::count_if(columns, std::not_fn(is_standard)));
    if (n_units > own && !for_all) {  // whose they are nobody knows
        layout.description.details.push_back(
            {"Channel units", fmt::format("not taken: {} for {} columns that are not standard", n_units, own)});
        units.clear();
    }
    std::size_t next = 0;
    for (std::size_t i = 0; i < columns.size() && next < units.size(); ++i) {
        const bool standard = is_standard(columns[i]);
        if (standard && !for_all) {
            continue;
        }
        const std::string_view unit = units[next++].text;
        // Positions are in minutes, whatever is written.
        if (!unit.empty() && unit != "(null)" && layout.units[i] != "arcminute") {
            layout.units[i] = std::string(unit);
        }
    }
    return layout;
}

}  // namespace tiretherm::input
