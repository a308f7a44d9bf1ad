// SPDX-License-Identifier: BSD-3-Clause
// Column widths by visible characters, line wrapping, and digits in groups of three.

#include "post/report/table.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace tiretherm::post {

namespace {

constexpr std::size_t gap = 2;
/// A column of text is not made narrower.
constexpr std::size_t least_text = 16;

/// A cell in its column; fmt pads by characters as they are seen, not by bytes.
std::string padded(const std::string& cell, std::size_t width, bool left, bool first) {
    return std::string(first ? 0 : gap, ' ') +
           (left ? fmt::format("{:<{}}", cell, width) : fmt::format("{:>{}}", cell, width));
}

std::string without_end(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line;
}

/// A cell in lines that its column holds.
std::vector<std::string> broken(const std::string& cell, std::size_t width) {
    if (columns_of(cell) <= width) {
        return {cell};
    }
    std::vector<std::string> lines;
    std::istringstream text(wrap(cell, 0, width));
    for (std::string line; std::getline(text, line);) {
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

std::size_t columns_of(std::string_view text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

void TextTable::add(std::vector<std::string> cells) {
    for (std::string& cell : cells) {
        std::ranges::replace(cell, '\n', ' ');  // of a title or the name of a file: a row is a line
    }
    rows_.push_back(std::move(cells));
}

std::vector<std::size_t> TextTable::widths() const {
    std::vector<std::size_t> width(left_.size());
    for (const std::vector<std::string>& row : rows_) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            width[c] = std::max(width[c], columns_of(row[c]));
        }
    }
    return width;
}

std::vector<std::string> TextTable::lines(std::size_t indent) const {
    const std::vector<std::size_t> width = widths();
    std::vector<std::string> result;
    for (const std::vector<std::string>& row : rows_) {
        std::string line(indent, ' ');
        for (std::size_t c = 0; c < row.size(); ++c) {
            line += padded(row[c], width[c], left_[c], c == 0);
        }
        result.push_back(without_end(std::move(line)));
    }
    return result;
}

bool TextTable::is_empty(std::size_t row, std::size_t from, std::size_t to) const {
    for (std::size_t c = from; c < std::min(to, rows_[row].size()); ++c) {
        if (!rows_[row][c].empty()) {
            return false;
        }
    }
    return true;
}

std::string TextTable::block(std::size_t repeated, std::size_t from, std::size_t to, std::size_t indent,
                             const std::vector<std::size_t>& width) const {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < to; ++c) {
        if (c < repeated || c >= from) {
            columns.push_back(c);
        }
    }
    std::string all;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        if (is_empty(r, from, to) && (from > repeated || !is_empty(r, to, rows_[r].size()))) {
            continue;  // it has its values in another block
        }
        std::vector<std::vector<std::string>> cells;
        std::size_t height = 1;
        for (const std::size_t c : columns) {
            cells.push_back(c < rows_[r].size() ? broken(rows_[r][c], width[c]) : std::vector<std::string>{});
            height = std::max(height, cells.back().size());
        }
        for (std::size_t part = 0; part < height; ++part) {
            std::string line(indent, ' ');
            for (std::size_t i = 0; i < columns.size(); ++i) {
                line +=
                    padded(part < cells[i].size() ? cells[i][part] : "", width[columns[i]], left_[columns[i]], i == 0);
            }
            all += without_end(std::move(line)) + "\n";
        }
    }
    return all;
}

std::string TextTable::text(std::size_t indent, std::size_t page) const {
    std::vector<std::size_t> width = widths();
    const std::size_t n = width.size();
    const auto space = [&](std::size_t c) { return width[c] + (c == 0 ? 0 : gap); };
    std::size_t whole = indent;
    for (std::size_t c = 0; c < n; ++c) {
        whole += space(c);
    }
    if (whole <= page) {
        return block(0, 0, n, indent, width);
    }
    const std::size_t repeated = n > 1 && !left_[0] && left_[1] ? 2 : 1;
    std::vector<std::size_t> word(n, 0);  // the longest of each column, which cannot be broken
    for (const std::vector<std::string>& row : rows_) {
        for (std::size_t c = 0; c < row.size(); ++c) {
            std::istringstream words(row[c]);
            for (std::string one; words >> one;) {
                word[c] = std::max(word[c], columns_of(one));
            }
        }
    }
    std::size_t names = indent;
    for (std::size_t c = 0; c < repeated && c < n; ++c) {
        width[c] = left_[c] ? std::min(width[c], std::max({least_text, word[c], page / 2})) : width[c];
        names += space(c);
    }
    std::string all;
    for (std::size_t from = repeated; from < n;) {
        std::size_t to = from;
        std::size_t least = names;  // of the columns so far, text as narrow as it may be
        const auto least_of = [&](std::size_t c) {
            return left_[c] ? std::min(width[c], std::max(least_text, word[c])) : width[c];
        };
        while (to < n && (to == from || least + gap + least_of(to) <= page)) {
            least += gap + least_of(to++);
        }
        std::size_t left = page > least ? page - least : 0;
        for (std::size_t c = from; c < to; ++c) {
            const std::size_t more = std::min(left, width[c] - least_of(c));
            left -= more;
            width[c] = least_of(c) + more;
        }
        all += (all.empty() ? "" : "\n") + block(repeated, from, to, indent, width);
        from = to;
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
        if (!line.empty() && indent + columns_of(line) + 1 + columns_of(word) > width) {
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
