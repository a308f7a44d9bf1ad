// SPDX-License-Identifier: BSD-3-Clause
// Plain text tables with aligned columns, and wrapped paragraphs.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tiretherm::post {

/// Text in aligned columns, two blanks apart.
class Table {
public:
    /// @param left for each column, whether it is aligned to the left; numbers go to the right
    explicit Table(std::vector<bool> left) : left_(std::move(left)) {}

    void add(std::vector<std::string> cells);

    /// @param indent blanks before each line  @returns a line for each row, without its end
    [[nodiscard]] std::vector<std::string> lines(std::size_t indent) const;
    /// The same in one piece, each line ended by a newline.
    [[nodiscard]] std::string text(std::size_t indent) const;

private:
    std::vector<bool> left_;
    std::vector<std::vector<std::string>> rows_;
};

/// Breaks a text at its blanks into lines of at most `width` characters, each after `indent` blanks.
/// @returns lines, each ended by a newline
[[nodiscard]] std::string wrap(const std::string& text, std::size_t indent, std::size_t width = 100);

/// A whole number in groups of three digits: "4 800".
[[nodiscard]] std::string grouped(double number);

}  // namespace tiretherm::post
