// SPDX-License-Identifier: BSD-3-Clause
// Files .vbo of Racelogic's VBOX. Sections: [header] titles of the columns, [channel units] of those that are not standard, or of the last,
// [laptiming] lines across the track as two points (longitude and latitude in minutes, west positive), [column names],
// [data] separated by blanks.   Racelogic, "VBO file structure", developers.racelogic.co.uk

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/text/characters.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

struct VboxSection {
    int line = 0;
    std::vector<CsvLine> lines{};  ///< [channel units] keeps its empty ones
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
#define VBOX_COLUMN(name, unit) {name, unit},
#include "input/text/column_names.list"
    };
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

/// Whether a unit is one of a column, as far as it is known what that is in.
bool may_be_in(std::string_view column, std::string_view unit) {
    const auto standard = standard_units().find(lower(column));
    if (standard == standard_units().end() || standard->second == "arcminute" || unit.empty() || unit == "(null)") {
        return true;
    }
    return signature(meant_unit(unit, standard->second)) == signature(meant_unit(standard->second, standard->second));
}

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

/// The lines of a section without the empty ones at its end, of which it may have any number.
std::vector<CsvLine> without_end(std::vector<CsvLine> lines) {
    while (!lines.empty() && lines.back().text.empty()) {
        lines.pop_back();
    }
    return lines;
}

/// Lines of [channel units] dealt to the columns. A VBOX writes one for each column that is not standard, an empty one for a column without unit.
/// Newer ones and other programs write one for each of the last columns, or of the last titles where there are more titles than columns.
/// @param section with its empty lines, of which the last may only end it  @param titled names or titles, as many as there are of more
/// @returns [n_titled], empty where there is none; nothing where they fit neither way
std::optional<std::vector<std::string_view>> deal_units(const std::vector<CsvLine>& section,
                                                        const std::vector<std::string_view>& titled,
                                                        std::size_t n_columns) {
    std::vector<std::string_view> dealt(titled.size());
    const std::vector<CsvLine> filled = without_end(section);
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < n_columns; ++i) {
        if (!is_standard(titled[i])) {
            own.push_back(i);
        }
    }
    const bool ends_without_unit = !section.empty() && section.size() - 1 == own.size();
    if (filled.size() == own.size() || (ends_without_unit && filled.size() < own.size())) {
        for (std::size_t i = 0; i < filled.size(); ++i) {
            dealt[own[i]] = filled[i].text;
        }
        return dealt;
    }
    if (filled.size() > titled.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < filled.size(); ++i) {
        const std::size_t to = titled.size() - filled.size() + i;
        if (to < n_columns && !may_be_in(titled[to], filled[i].text)) {
            return std::nullopt;
        }
        dealt[to] = filled[i].text;
    }
    return dealt;
}

/// The file up to its data.
struct VboxHead {
    std::map<std::string, VboxSection, std::less<>> sections{};
    int lines = 0;
    bool found_data = false;

    [[nodiscard]] std::vector<CsvLine> filled(const std::string& name) {
        std::vector<CsvLine> lines_with_text = sections[name].lines;
        std::erase_if(lines_with_text, [](const CsvLine& line) { return line.text.empty(); });
        return lines_with_text;
    }
};

/// @param rest of the text: out, what follows the heading of the data  @param description gets the date
VboxHead read_head(std::string_view& rest, LogDescription& description) {
    VboxHead head;
    VboxSection* open = nullptr;
    while (!head.found_data) {
        const std::optional<std::string_view> line = next_line(rest);
        if (!line) {
            break;
        }
        ++head.lines;
        const std::string_view trimmed = trim(*line);
        if (trimmed.starts_with('[') && trimmed.ends_with(']')) {
            const std::string name = lower(trimmed.substr(1, trimmed.size() - 2));
            head.found_data = name == "data";
            open = &head.sections[name];
            open->line = head.lines;
        } else if (open != nullptr) {
            open->lines.push_back({trimmed, head.lines});
        } else if (trimmed.starts_with("File created on ")) {
            description.details.push_back({"Date", printable(trimmed.substr(16))});
        }
    }
    return head;
}

/// The units of the columns: those of standard names, and over them what the section says.
void take_units(VboxHead& head, std::string_view names, CsvLayout& layout) {
    std::vector<std::string_view> columns;
    split_fields(names, ' ', columns);
    const std::vector<CsvLine> titles = head.filled("header");
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const bool titled = titles.size() == columns.size();
        layout.units.push_back(standard_unit(std::string(columns[i]), titled ? titles[i].text : std::string_view()));
    }
    std::vector<std::string_view> titled = columns;
    for (std::size_t i = columns.size(); i < titles.size(); ++i) {
        titled.push_back(titles[i].text);
    }
    const std::vector<CsvLine>& section = head.sections["channel units"].lines;
    const auto dealt = deal_units(section, titled, columns.size());
    if (!dealt) {  // units that match no column
        layout.description.details.push_back(
            {"Channel units", fmt::format("not taken: {} for {} columns", without_end(section).size(), titled.size())});
        return;
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string_view unit = (*dealt)[i];
        // Positions are in minutes, whatever is written.
        if (!unit.empty() && unit != "(null)" && layout.units[i] != "arcminute") {
            layout.units[i] = std::string(unit);
        }
    }
}

}  // namespace

std::optional<CsvLayout> find_vbox_layout(std::string_view text) {
    constexpr std::size_t searched = 4096;  // bytes in which the first section begins
    const std::string_view begin = text.substr(0, searched);
    const bool has_head = begin.find("[header]") != std::string_view::npos || begin.starts_with("File created on ");
    if (!has_head || text.find("[column names]") == std::string_view::npos) {
        return std::nullopt;
    }
    CsvLayout layout;
    layout.description.format = "VBOX .vbo";
    layout.description.west_is_positive = true;
    layout.separator = ' ';
    std::string_view rest = text;
    VboxHead head = read_head(rest, layout.description);
    const std::vector<CsvLine> names = head.filled("column names");
    if (names.empty() || !head.found_data) {
        layout.defect_line = head.lines;
        layout.defect =
            ErrorText{fmt::format("the VBOX file has no section [{}]", names.empty() ? "column names" : "data"),
                      "save the session again: [column names] and [data] follow the head"};
        return layout;
    }
    const std::size_t end = rest.find("\n[");
    layout.lines = {.names = names.front(), .units = {}, .body = rest.substr(0, end)};
    if (const std::size_t timing = rest.find("\n[laptiming]"); timing != std::string_view::npos) {
        rest.remove_prefix(timing + 1);
        static_cast<void>(next_line(rest));
        while (const std::optional<std::string_view> line = next_line(rest)) {
            head.sections["laptiming"].lines.push_back({trim(*line), head.lines});
        }
    }
    for (const CsvLine& line : head.filled("comments")) {
        const std::size_t colon = line.text.find(':');
        if (colon != std::string_view::npos && !trim(line.text.substr(colon + 1)).empty()) {
            layout.description.details.push_back(
                {printable(trim(line.text.substr(0, colon))), printable(trim(line.text.substr(colon + 1)))});
        }
    }
    for (const CsvLine& line : head.filled("laptiming")) {
        if (!layout.description.start_line) {
            layout.description.start_line = read_start_line(line.text);
        }
    }
    take_units(head, names.front().text, layout);
    return layout;
}

}  // namespace tiretherm::input
