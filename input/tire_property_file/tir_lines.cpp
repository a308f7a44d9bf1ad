// SPDX-License-Identifier: BSD-3-Clause
// Splits the lines, removes comments and quotes, skips tables, and reports every line that cannot be read.

#include "input/tire_property_file/tir_lines.hpp"

#include <algorithm>
#include <cctype>

#include "input/tables/csv.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

std::string capitals(std::string_view text) {
    std::string word(trim(text));
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); });
    return word;
}

bool is_quote(char c) { return c == '\'' || c == '"'; }

/// Where the comment of a line starts; its end when there is none. A mark between quotes is text.
std::size_t comment_start(std::string_view line) {
    char quote = '\0';
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (quote != '\0') {
            quote = line[i] == quote ? '\0' : quote;
        } else if (is_quote(line[i])) {
            quote = line[i];
        } else if (line[i] == '$' || line[i] == '!') {
            return i;
        }
    }
    return line.size();
}

/// Whether nothing in a section is read but keys that any part may have: shapes, curves and contact models of solvers.
bool is_passed_over(std::string_view section) {
    constexpr std::array<std::string_view, 8> read{"",
                                                   "MODEL",
                                                   "UNITS",
                                                   "DIMENSION",
                                                   "VERTICAL",
                                                   "SCALING_COEFFICIENTS",
                                                   "LONGITUDINAL_COEFFICIENTS",
                                                   "LATERAL_COEFFICIENTS"};
    return std::ranges::find(read, section) == read.end();
}

/// One line and its place in the file.
struct NumberedLine {
    std::string_view text;
    int file = -1;
    int number = 0;

    [[nodiscard]] SourceLocation place(std::string_view part) const {
        const auto before = static_cast<std::size_t>(part.data() - text.data());
        return {.file = file,
                .line = number,
                .column = static_cast<int>(split_characters(text.substr(0, before)).size()) + 1,
                .length = std::max(1, static_cast<int>(split_characters(part).size()))};
    }
};

/// Reads `KEY = value`; no key after an error.
TirLines::Entry read_entry(const NumberedLine& line, std::string_view written, InputErrors& errors) {
    const std::size_t equals = written.find('=');
    const std::string_view key = trim(written.substr(0, std::min(equals, written.size())));
    if (equals == std::string_view::npos || key.empty()) {
        errors.add(line.place(written), "the line is neither [SECTION] nor KEY = value nor a comment",
                   "start a comment with $ or !");
        return {};
    }
    std::string_view value = trim(written.substr(equals + 1));
    TirLines::Entry entry{.section = {},
                          .key = capitals(key),
                          .value = {},
                          .key_place = line.place(key),
                          .place = line.place(value.empty() ? key : value)};
    if (!value.empty() && is_quote(value.front())) {
        if (value.size() < 2 || value.back() != value.front()) {
            errors.add(entry.place, fmt::format("the quotes round {} are not closed", entry.key),
                       fmt::format("write {} = 'text'", entry.key));
            return {};
        }
        value = trim(value.substr(1, value.size() - 2));
    }
    entry.value = value;
    return entry;
}

}  // namespace

TirLines::TirLines(const TextFile& file, InputErrors& errors) {
    std::string_view rest = file.text;
    // Editors of Windows put a mark of UTF-8 in front.
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    std::string section;
    bool in_table = false;
    NumberedLine line{.text = {}, .file = file.number};
    while (const auto text = next_line(rest)) {
        line.text = *text;
        ++line.number;
        const std::string_view written = trim(line.text.substr(0, comment_start(line.text)));
        if (written.empty()) {
            continue;
        }
        if (written.front() == '[') {
            in_table = false;
            if (written.back() != ']') {
                errors.add(line.place(written), "the section's name does not end with ]");
            }
            section = capitals(written.substr(1, std::min(written.find(']'), written.size()) - 1));
            continue;
        }
        in_table = in_table || written.front() == '{';
        if (in_table && written.find('=') == std::string_view::npos) {
            continue;
        }
        if (is_passed_over(section) && written.find('=') == std::string_view::npos) {
            continue;
        }
        Entry entry = read_entry(line, written, errors);
        if (entry.key.empty()) {
            continue;
        }
        entry.section = section;
        const auto same = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& other) {
            return other.key == entry.key && other.section == section;
        });
        if (same != entries_.end()) {
            errors.add(
                entry.key_place,
                fmt::format("{} stands twice in [{}], first at {}", entry.key, section, errors.spell(same->place)),
                "remove one of the lines");
            continue;
        }
        entries_.push_back(std::move(entry));
    }
}

const TirLines::Entry* TirLines::find(std::string_view key, std::string_view section) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.key == key && (section.empty() ? entry.section != "UNITS" : entry.section == section) &&
               !entry.value.empty();
    });
    return found == entries_.end() ? nullptr : &*found;
}

std::optional<double> TirLines::number(std::string_view key, InputErrors& errors) const {
    const Entry* entry = find(key);
    if (entry == nullptr) {
        return std::nullopt;
    }
    const std::optional<Number> read = leading_number(entry->value);
    if (!read || !read->rest.empty() || !std::isfinite(read->value)) {
        const bool comma = read && read->rest.starts_with(',');
        return errors.add(entry->place, fmt::format("{} is {}; a number is wanted", key, entry->value),
                          comma ? "write a decimal point" : "");
    }
    return read->value;
}

}  // namespace tiretherm::input
