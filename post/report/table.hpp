// SPDX-License-Identifier: BSD-3-Clause
// Plain text tables with aligned columns, and wrapped paragraphs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::post {

/// Columns of a page that goes to a file or a pipe.
inline constexpr std::size_t standard_width = 100;
/// Longer lines of prose are hard to read, however wide a terminal is.
inline constexpr std::size_t widest_prose = 120;

/// How many columns of a terminal a text in UTF-8 takes: its characters.
[[nodiscard]] std::size_t columns_of(std::string_view text);

/// Text in aligned columns, two blanks apart.
class TextTable {
public:
    /// @param left for each column, whether it is aligned to the left; numbers go to the right
    explicit TextTable(std::vector<bool> left) : left_(std::move(left)) {}

    void add(std::vector<std::string> cells);

    /// @param indent blanks before each line  @returns a line for each row, without its end
    [[nodiscard]] std::vector<std::string> lines(std::size_t indent) const;
    /// The same in one piece, each line ended by a newline. Where the table is wider than `width`, its last column of text
    /// is wrapped; where that is not enough, columns go to further blocks, an empty line apart, which repeat the columns
    /// up to the first of text. @param width columns of the page
    [[nodiscard]] std::string text(std::size_t indent, std::size_t width = std::string::npos) const;

private:
    [[nodiscard]] std::vector<std::size_t> widths() const;
    [[nodiscard]] bool is_empty(std::size_t row, std::size_t from, std::size_t to) const;
    /// Columns [0, repeated) and [from, to) as a table whose columns are as wide as said.
    [[nodiscard]] std::string block(std::size_t repeated, std::size_t from, std::size_t to, std::size_t indent,
                                    const std::vector<std::size_t>& width) const;

    std::vector<bool> left_;
    std::vector<std::vector<std::string>> rows_;
};

/// Breaks a text at its blanks into lines of at most `width` characters, each after `indent` blanks.
/// @returns lines, each ended by a newline
[[nodiscard]] std::string wrap(const std::string& text, std::size_t indent, std::size_t width = standard_width);

/// A whole number in groups of three digits: "4 800".
[[nodiscard]] std::string grouped(double number);

}  // namespace tiretherm::post
