// SPDX-License-Identifier: BSD-3-Clause
// Comma-separated tables: separators, quotes, digits.
#include "post/report/csv.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/compile.h>
#include <fmt/format.h>

#include "input/text/characters.hpp"

namespace tiretherm::post {

Csv::Csv(const std::vector<std::string>& headings) {
    for (const std::string& heading : headings) {
        add(std::string_view(heading));
    }
    end_row();
}

void Csv::add(std::string_view text) {
    separate();
    const auto is_plain = [](char c) { return c >= ' ' && c <= '~' && c != ',' && c != '"'; };
    if (std::ranges::all_of(text, is_plain)) {
        text_ += text;
        return;
    }
    const std::string plain = input::printable(text);
    if (plain.find_first_of(",\"") == std::string::npos) {
        text_ += plain;
        return;
    }
    text_ += '"';
    for (const char letter : plain) {
        text_ += letter == '"' ? "\"\"" : std::string(1, letter);
    }
    text_ += '"';
}

void Csv::add(Digits number) {
    separate();
    if (std::isfinite(number.value)) {
        std::array<char, 64> room;
        const auto [end, error] = std::to_chars(room.data(), room.data() + room.size(), number.value,
                                                std::chars_format::general, number.digits);
        assert(error == std::errc());
        text_.append(room.data(), end);
    }
}

void Csv::add(Decimals number) {
    separate();
    if (std::isfinite(number.value)) {
        fmt::format_to(std::back_inserter(text_), FMT_COMPILE("{:.{}f}"), number.value, number.decimals);
    }
}

void Csv::end_row() {
    text_ += '\n';
    in_row_ = false;
}

std::string Csv::take() { return std::exchange(text_, {}); }

void Csv::separate() {
    if (in_row_) {
        text_ += ',';
    }
    in_row_ = true;
}

}  // namespace tiretherm::post
