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

}  // namespace tiretherm::input
