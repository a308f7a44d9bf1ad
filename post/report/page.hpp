// SPDX-License-Identifier: BSD-3-Clause
// A page of text with headings, as the commands print it on a terminal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::post {

/// A page of text in sections, as the commands print it.
class Page {
public:
    /// @param bold whether headings are, by the terminal's escapes
    explicit Page(bool bold) : bold_(bold) {}

    /// Lines as they are, each with its end.
    void add(std::string_view lines) { text_ += lines; }
    /// A heading and what stands below it; nothing where there is nothing to say.
    void add(std::string_view title, std::string_view body);
    /// A line as headings are written.
    [[nodiscard]] std::string strong(std::string_view line) const;

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    bool bold_;
    std::string text_;
};

/// Paragraphs one below the other, wrapped.
[[nodiscard]] std::string paragraphs(const std::vector<std::string>& texts);

}  // namespace tiretherm::post
