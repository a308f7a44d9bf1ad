// SPDX-License-Identifier: BSD-3-Clause
// Splits, distinguishes and finds headings.

#include "input/loggers/heading_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <map>

#include <fmt/format.h>

#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

/// How often each name stands.
std::map<std::string, int, std::less<>> count_names(const std::vector<ColumnHead>& heads) {
    std::map<std::string, int, std::less<>> counted;
    for (const ColumnHead& head : heads) {
        ++counted[head.heading.name];
    }
    return counted;
}

}  // namespace

std::string in_small_letters(std::string_view name) {
    std::string small;
    std::ranges::transform(name, std::back_inserter(small),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small;
}

Heading read_round_heading(std::string_view text) {
    text = trim(text);
    const std::size_t open = text.find(" (");
    const std::size_t close = text.find(')', open == std::string_view::npos ? text.size() : open);
    if (open == std::string_view::npos || close == std::string_view::npos) {
        return {std::string(text), std::nullopt};
    }
    const std::string unit(trim(text.substr(open + 2, close - open - 2)));
    const std::string name = std::string(trim(text.substr(0, open))) + std::string(text.substr(close + 1));
    return {std::string(trim(name)), unit.empty() ? std::nullopt : std::optional(unit)};
}

void distinguish(std::vector<ColumnHead>& heads, const std::vector<std::string_view>& sources) {
    const auto name_with = [&](auto&& word_of) {
        const auto counted = count_names(heads);
        for (std::size_t i = 0; i < std::min(heads.size(), sources.size()); ++i) {
            std::string& name = heads[i].heading.name;
            if (counted.at(name) > 1 && !sources[i].empty()) {
                name = fmt::format("{} ({})", name, word_of(sources[i]));
            }
        }
    };
    name_with([](std::string_view source) {
        const std::size_t colon = source.find(':');
        return trim(colon == std::string_view::npos ? source : source.substr(colon + 1));
    });
    name_with([](std::string_view source) { return source; });  // two devices of one kind
}

void mark_clock(std::vector<ColumnHead>& heads) {
    if (std::ranges::any_of(heads, [](const ColumnHead& head) { return head.heading.name == "time"; })) {
        return;
    }
    for (const std::string_view name : {"time", "timestamp"}) {
        const auto is_named = [&](const ColumnHead& head) { return in_small_letters(head.heading.name) == name; };
        if (const auto found = std::ranges::find_if(heads, is_named); found != heads.end()) {
            found->is_clock = true;
            return;
        }
    }
    const auto has_clock = [](const ColumnHead& head) { return head.form != FieldForm::number; };
    if (std::ranges::count_if(heads, has_clock) == 1) {
        std::ranges::find_if(heads, has_clock)->is_clock = true;
    }
}

}  // namespace tiretherm::input
