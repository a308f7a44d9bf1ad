// SPDX-License-Identifier: BSD-3-Clause
// Cuts the text of a case file into its tables.
#include "input/case_text/case_parts.hpp"

#include "input/case_text/case_writer.hpp"
#include "input/tables/csv.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

/// Where the comment of a line begins, or its end: a # outside of quotation marks.
std::size_t comment_of(std::string_view line) {
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        quoted = line[i] == '"' ? !quoted : quoted;
        if (line[i] == '#' && !quoted) {
            return i;
        }
    }
    return line.size();
}

bool is_entry_of(std::string_view line, std::string_view key) {
    return line.starts_with(key) && trim(line.substr(key.size())).starts_with('=');
}

/// "mesh.layer" of "[[mesh.layer]]   # from the outside in".
std::string table_of(std::string_view line) {
    const std::string_view heading = trim(line.substr(0, comment_of(line)));
    const std::size_t first = heading.find_first_not_of('[');
    return std::string(heading.substr(first, heading.find(']') - first));
}

/// The comment right above a heading belongs to its table.
void move_comment(std::vector<std::string>& from, std::vector<std::string>& to) {
    auto first = from.end();
    while (first != from.begin() && std::prev(first)->starts_with('#')) {
        --first;
    }
    to.assign(first, from.end());
    from.erase(first, from.end());
}

void drop_blank_ends(std::vector<std::string>& lines) {
    while (!lines.empty() && trim(lines.back()).empty()) {
        lines.pop_back();
    }
}

}  // namespace

std::string CasePart::value(std::string_view key) const {
    for (const std::string_view line : lines) {
        if (is_entry_of(line, key)) {
            const std::size_t equals = line.find('=');
            return std::string(trim(line.substr(equals + 1, comment_of(line) - equals - 1)));
        }
    }
    return {};
}

std::string CasePart::text(std::string_view key) const {
    const std::string written = value(key);
    return written.size() > 1 && written.front() == '"' ? written.substr(1, written.size() - 2) : written;
}

void CasePart::replace(std::string_view key, std::string_view value, std::string_view comment) {
    for (std::string& line : lines) {
        if (is_entry_of(line, key)) {
            line = entry_line(table, key, value, comment);
        }
    }
}

void CasePart::remove(std::string_view key) {
    std::erase_if(lines, [&](const std::string& line) { return is_entry_of(line, key); });
}

std::vector<CasePart> cut_case(std::string_view text) {
    std::vector<CasePart> parts(1);
    while (const auto line = next_line(text)) {
        if (line->starts_with('[')) {
            CasePart part{.table = table_of(*line), .lines = {}};
            move_comment(parts.back().lines, part.lines);
            parts.push_back(std::move(part));
        }
        parts.back().lines.emplace_back(*line);
    }
    for (CasePart& part : parts) {
        drop_blank_ends(part.lines);
    }
    return parts;
}

}  // namespace tiretherm::input
