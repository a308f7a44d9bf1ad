// SPDX-License-Identifier: BSD-3-Clause
// Column widths by visible characters, line wrapping, and digits in groups of three.

#include "post/report/table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace tiretherm::post {

void Table::add(std::vector<std::string> cells) {
    for (std::string& cell : cells) {
        std::ranges::replace(cell, '\n', ' ');  // of a title or the name of a file: a row is a line
    }
    rows_.push_back(std::move(cells));
}

std::vector<std::string> Table::lines(std::size_t indent) const {
    // fmt pads by characters as they are seen, not by bytes; so widths are counted with it too.
    const auto seen = [](const std::string& text) {
        return static_cast<std::size_t>(std::count_if(
            text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    };
    std::vector<std::size_t> width(left_.size());
    for (const std::vector<std::string>& row : rows_) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            width[c] = std::max(width[c], seen(row[c]));
        }
    }
    std::vector<std::string> result;
    for (const std::vector<std::string>& row : rows_) {
        std::string line(indent, ' ');
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string gap = c == 0 ? "" : "  ";
            line += left_[c] ? fmt::format("{}{:<{}}", gap, row[c], width[c])
                             : fmt::format("{}{:>{}}", gap, row[c], width[c]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        result.push_back(std::move(line));
    }
    return result;
}

std::string Table::text(std::size_t indent) const {
    std::string all;
    for (const std::string& line : lines(indent)) {
        all += line + "\n";
    }
    return all;
}

std::string wrap(const std::string& text, std::size_t indent, std::size_t width) {
    std::istringstream words(text);
    std::string result;
    std::string line;
    const auto end_line = [&] {
        result += std::string(indent, ' ') + line + "\n";
        line.clear();
    };
    for (std::string word; words >> word;) {
        if (!line.empty() && indent + line.size() + 1 + word.size() > width) {
            end_line();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    if (!line.empty()) {
        end_line();
    }
    return result;
}

std::string grouped(double number) {
    std::string digits = fmt::format("{:.0f}", std::abs(number));
    for (std::size_t from_end = 3; from_end < digits.size(); from_end += 4) {
        digits.insert(digits.size() - from_end, " ");
    }
    return (number < 0.0 ? "-" : "") + digits;
}

}  // namespace tiretherm::post
