// SPDX-License-Identifier: BSD-3-Clause
// How --help and `tiretherm help` are laid out: lines of at most 80 columns.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace CLI {
class FormatterBase;
}

namespace tiretherm::app {

/// Columns of a terminal that nobody has made wider.
constexpr std::size_t help_width = 80;

/// A name, and beside it from a column on what it means, in lines of at most `help_width`; below it where the name is too long.
[[nodiscard]] std::string entry_text(const std::string& name, const std::string& meaning, std::size_t column);

/// Paragraphs, apart by empty lines, each broken anew; lines that begin with a blank stay as they are.
[[nodiscard]] std::string paragraphs_text(const std::string& text);

/// Lays out the help of CLI11 so.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> help_formatter();

}  // namespace tiretherm::app
