// SPDX-License-Identifier: BSD-3-Clause
// Tries the loggers' formats of loggers.list in turn.

#include "input/loggers/csv_layout.hpp"

#include "input/text/characters.hpp"

namespace tiretherm::input {

bool is_comment(std::string_view line) {
    line = trim(line);
    return line.starts_with('#') || line.starts_with("//") || line.starts_with("MARK ");
}

std::vector<std::string> read_detail(std::string_view line, char separator, LogDescription& into) {
    std::vector<std::string_view> fields;
    split_fields(line, separator, fields);
    std::vector<std::string> values(fields.begin() + 1, fields.end());
    while (!values.empty() && values.back().empty()) {
        values.pop_back();
    }
    if (!values.empty() && !values.front().empty() && !fields.front().empty()) {
        std::string text = printable(values.front());
        for (std::size_t i = 1; i < values.size() && !values[i].empty(); ++i) {
            text += " " + printable(values[i]);
        }
        into.details.push_back({printable(fields.front()), std::move(text)});
    }
    return values;
}

CsvLayout find_csv_layout(std::string_view text) {
#define TEXT_LOG(name)                                                  \
    if (std::optional<CsvLayout> layout = find_##name##_layout(text)) { \
        return std::move(*layout);                                      \
    }
#include "input/loggers/loggers.list"
    CsvLayout plain;
    plain.lines = find_head_lines(text);
    plain.separator = separator_of(plain.lines.names.text);
    return plain;
}

}  // namespace tiretherm::input
