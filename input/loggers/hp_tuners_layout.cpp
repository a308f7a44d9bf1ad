// SPDX-License-Identifier: BSD-3-Clause
// CSV exports of HP Tuners' VCM Scanner. [Channel Information] has the numbers, names and units of the channels in three lines,
// [Channel Data] their values; the first channel is the time, Offset.

#include <algorithm>

#include <fmt/format.h>

#include "input/loggers/csv_layout.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

std::optional<CsvLayout> find_hp_tuners_layout(std::string_view text) {
    std::string_view rest = text;
    CsvLine line = next_filled_line(rest, 0);
    if (!line.text.starts_with("HP Tuners CSV Log File")) {
        return std::nullopt;
    }
    CsvLayout layout{.description = {.format = "HP Tuners CSV"}, .known = {{"Offset", "time", "s"}}};
    const auto go_to = [&](std::string_view section) {
        while (line.number > 0 && trim(line.text) != section) {
            const std::size_t colon = line.text.find(": ");
            const std::string_view value = line.text.substr(std::min(colon, line.text.size() - 1) + 1);
            if (colon != std::string_view::npos && layout.lines.names.number == 0 && !trim(value).empty()) {
                layout.description.details.push_back(
                    {printable(trim(line.text.substr(0, colon))), printable(trim(value))});
            }
            line = next_filled_line(rest, line.number);
        }
        return line.number > 0;
    };
    if (go_to("[Channel Information]")) {
        line = next_filled_line(rest, line.number);  // the numbers of the channels
        layout.lines.names = next_filled_line(rest, line.number);
        layout.lines.units = line = next_written_line(rest, layout.lines.names.number);
    }
    if (!go_to("[Channel Data]")) {
        layout.defect_line = 1;
        layout.defect =
            ErrorText{fmt::format("the HP Tuners file has no section [Channel {}]",
                                  layout.lines.names.number == 0 ? "Information" : "Data"),
                      "export the log again, as CSV: [Channel Information] and [Channel Data] follow the head"};
        return layout;
    }
    layout.separator = separator_of(layout.lines.names.text);
    layout.lines.body = rest;
    return layout;
}

}  // namespace tiretherm::input
