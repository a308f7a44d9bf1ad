// SPDX-License-Identifier: BSD-3-Clause
// The text of a case as it is written.
#include "input/case_text/case_writer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t comment_column = 36;
constexpr std::size_t line_width = 124;

/// The words of a text in lines of at most `room` characters, one at least.
std::vector<std::string> wrapped(const std::string& text, std::size_t room) {
    std::vector<std::string> lines(1);
    std::size_t used = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find(' ', at), text.size());
        const std::string word = text.substr(at, end - at);
        const std::size_t size = split_characters(word).size();
        if (used > 0 && used + 1 + size > room) {
            lines.emplace_back();
            used = 0;
        }
        lines.back() += (used > 0 ? " " : "") + word;
        used += size + (used > 0 ? 1 : 0);
        at = end + 1;
    }
    return lines;
}

/// An entry or a heading with its comment, without the last line's end.
std::string commented(const std::string& line, std::string_view comment) {
    if (comment.empty()) {
        return line;
    }
    const std::size_t size = split_characters(line).size();
    const std::size_t column = std::max(comment_column, size + 2);
    const std::size_t room = std::max<std::size_t>(line_width - std::min(line_width, column + 2), 40);
    std::string text = line + std::string(column - size, ' ');
    bool first = true;
    for (const std::string& part : wrapped(printable(comment), room)) {
        text += first ? "# " + part : "\n" + std::string(column, ' ') + "# " + part;
        first = false;
    }
    return text;
}

}  // namespace

std::string CaseWriter::entry_line(std::string_view key, std::string_view value, std::string_view comment) {
    return commented(fmt::format("{} = {}", key, value), comment);
}

void CaseWriter::heading(std::string_view heading, std::string_view comment) {
    blank();
    text_ += commented(std::string(heading), comment) + "\n";
}

void CaseWriter::entry(std::string_view key, std::string_view value, std::string_view comment) {
    text_ += entry_line(key, value, comment) + "\n";
}

void CaseWriter::suggestion(std::string_view key, std::string_view value, std::string_view comment) {
    text_ += entry_line("# " + printable(key), printable(value), comment) + "\n";
}

void CaseWriter::remark(std::string_view text) {
    for (const std::string& line : wrapped(printable(text), line_width - 2)) {
        text_ += "# " + line + "\n";
    }
}

void CaseWriter::blank() {
    if (!text_.empty() && !text_.ends_with("\n\n")) {
        text_ += "\n";
    }
}

void CaseWriter::lines(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        text_ += line + "\n";
    }
}

}  // namespace tiretherm::input
