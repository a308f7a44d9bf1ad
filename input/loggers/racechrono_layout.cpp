// SPDX-License-Identifier: BSD-3-Clause
// CSV exports of RaceChrono. Format 3 has names, units and sources in three lines, and channels of several sources under
// one name; format 2 has headings "Speed (m/s) *gps" in one.

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"

namespace tiretherm::input {

namespace {

constexpr int most_lines = 500;  ///< of the head

bool begins_with_number(std::string_view line, char separator) {
    std::vector<std::string_view> fields;
    split_fields(line, separator, fields);
    return leading_number(fields.front()).has_value();
}

}  // namespace

std::optional<CsvLayout> find_racechrono_layout(std::string_view text) {
    std::string_view rest = text;
    const std::optional<std::string_view> first = next_line(rest);
    if (!first || first->find("created using RaceChrono") == std::string_view::npos) {
        return std::nullopt;
    }
    CsvLayout layout;
    layout.description.format = "RaceChrono CSV";
    layout.separator = separator_of(rest.substr(0, rest.find('\n')));
    std::vector<std::string_view> fields;
    bool is_third = false;
    int last = 1;
    while (layout.lines.names.number == 0) {
        const CsvLine line = next_filled_line(rest, last);
        if (line.number == 0 || line.number > most_lines) {
            layout.defect_line = last;
            layout.defect = ErrorText{"the RaceChrono file has no line with the names of its channels",
                                      "export the session again, as CSV"};
            return layout;
        }
        last = line.number;
        split_fields(line.text, layout.separator, fields);
        if (fields.size() > 4) {
            layout.lines.names = line;
        } else {
            read_detail(line.text, layout.separator, layout.description);
            is_third = is_third || (fields.size() > 1 && fields[0] == "Format" && fields[1] >= "3");
        }
    }
    std::string_view body = rest;
    if (!is_third) {
        layout.round_brackets = true;
        layout.lines.body = body;
        return layout;
    }
    layout.description.format = "RaceChrono CSV 3";
    for (CsvLine* line : {&layout.lines.units, &layout.sources}) {
        *line = next_written_line(rest, last);
        if (line->number == 0 || begins_with_number(line->text, layout.separator)) {
            layout.defect_line = line->number == 0 ? last : line->number;
            layout.defect = ErrorText{fmt::format("the RaceChrono file has no line with the {} of its channels",
                                                  line == &layout.sources ? "sources" : "units"),
                                      "in format 3 the names are followed by a line of units and one of sources, such "
                                      "as 100: gps: export the session again"};
            return layout;
        }
        last = line->number;
    }
    layout.lines.body = rest;
    return layout;
}

}  // namespace tiretherm::input
