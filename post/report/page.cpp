// SPDX-License-Identifier: BSD-3-Clause
// Appends headings and sections, and wraps paragraphs.

#include "post/report/page.hpp"

#include <fmt/format.h>

#include "post/report/table.hpp"

namespace tiretherm::post {

void Page::add(std::string_view title, std::string_view body) {
    if (!body.empty()) {
        text_ += fmt::format("\n{}\n{}", strong(title), body);
    }
}

std::string Page::strong(std::string_view line) const {
    return bold_ ? fmt::format("\033[1m{}\033[0m", line) : std::string(line);
}

std::string paragraphs(const std::vector<std::string>& texts) {
    std::string lines;
    for (const std::string& text : texts) {
        lines += wrap(text, 2);
    }
    return lines;
}

}  // namespace tiretherm::post
