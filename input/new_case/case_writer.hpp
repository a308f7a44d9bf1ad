// SPDX-License-Identifier: BSD-3-Clause
// The text of a case as it is written: tables of `key = value  # comment`, comments in one column.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input {

/// Writes a case table by table. Comments may hold anything that a log's headings hold.
class CaseWriter {
public:
    /// A heading such as [tire], a blank line above it.
    void heading(std::string_view heading, std::string_view comment = {});
    void entry(std::string_view key, std::string_view value, std::string_view comment = {});
    /// An entry behind a #, for the user to take away.
    void suggestion(std::string_view key, std::string_view value, std::string_view comment = {});
    /// A comment over the whole width, as many lines as it takes.
    void remark(std::string_view text);
    void blank();
    /// Lines as they are, such as those of a CasePart.
    void lines(const std::vector<std::string>& lines);

    [[nodiscard]] const std::string& text() const { return text_; }

    /// `key = value`, blanks up to the column of the comments, `# comment`; a long comment goes on in the next line.
    [[nodiscard]] static std::string entry_line(std::string_view key, std::string_view value, std::string_view comment);

private:
    std::string text_;
};

/// What of a text may stand in a comment: one line of UTF-8, other bytes as question marks.
[[nodiscard]] std::string printable(std::string_view text);
/// Whether a text is UTF-8 without control characters, so that it may be a key of a case.
[[nodiscard]] bool is_printable(std::string_view text);

}  // namespace tiretherm::input
