// SPDX-License-Identifier: BSD-3-Clause
// The text of a case as it is written, by the descriptions of its keys: tables of `key = value  # comment`, comments in one column.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "input/toml/document.hpp"

namespace tiretherm::input {

/// `key = value`, blanks up to the column of the comments, `# comment`; a long comment goes on in the next line.
/// @param table path of the table, "mesh.layer"  @param value without quotation marks, which it gets where the key takes a text; a
/// list and a table in braces as TOML has them
/// @errors std::logic_error for a table, a key or a word that no description has
[[nodiscard]] std::string entry_line(std::string_view table, std::string_view key, std::string_view value,
                                     std::string_view comment = {});

/// Writes a case table by table. Comments may hold anything that a log's headings hold. What no description has is an error of the
/// program, a std::logic_error.
class CaseWriter {
public:
    /// A heading such as [tire], or [[run]] of a list, a blank line above it unless it has a caption.
    void table(std::string_view path, std::string_view comment = {});
    /// An entry of the table. @param value as of entry_line  @param comment empty: what the key means, once in a case
    void entry(std::string_view key, std::string_view value, std::string_view comment = {});
    /// A number in the unit of the key's description.
    void entry(std::string_view key, double value);
    /// A commented-out entry. Its meaning has the key's default, too.
    void suggestion(std::string_view key, std::string_view value, std::string_view comment = {});
    /// From here on tables and entries stand behind a #, or no longer do.
    void comment_out(bool on) { commented_ = on; }
    /// A remark right above the next heading.
    void caption(std::string_view text);
    /// A comment over the whole width, as many lines as it takes.
    void remark(std::string_view text);
    void blank();
    /// Lines as they are, such as those of a CasePart. @param path of the table that they begin
    void lines(const std::vector<std::string>& lines, std::string_view path = "");
    /// A whole document without comments, as toml_text::document.
    void document(const TomlValue& root);

    /// What the key of the current table means, by its description; empty where the case says it already.
    [[nodiscard]] std::string meaning(std::string_view key, bool with_default = false);
    [[nodiscard]] const std::string& path() const { return path_; }  ///< of the current table
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    std::string text_;
    std::string path_;
    std::set<std::string> told_;  ///< keys with their tables whose meaning has been written
    bool commented_ = false;
    bool captioned_ = false;
};

}  // namespace tiretherm::input
