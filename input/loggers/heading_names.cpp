// SPDX-License-Identifier: BSD-3-Clause
// Splits, distinguishes and finds headings.

#include "input/loggers/heading_names.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "input/loggers/logger_units.hpp"
#include "input/tables/columns.hpp"
#include "input/text/characters.hpp"

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

void number_duplicates(std::vector<ColumnHead>& heads) {
    std::map<std::string, int, std::less<>> seen;
    const auto counted = count_names(heads);
    for (ColumnHead& head : heads) {
        std::string& name = head.heading.name;
        if (const int nth = ++seen[name]; nth > 1 && !name.empty()) {
            std::string numbered = fmt::format("{} ({})", name, nth);
            name = counted.contains(numbered) ? name : std::move(numbered);
        }
    }
}

namespace {

/// "AccelX"|"g"|-3.0|3.0|25 of RaceCapture: name, unit, range and rate.
std::optional<Heading> read_barred_heading(std::string_view text) {
    const std::size_t name_end = text.find("\"|\"");
    const std::size_t unit_end = text.find("\"|", std::min(name_end, text.size() - 1) + 1);
    if (!text.starts_with('"') || name_end == std::string_view::npos || unit_end == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string unit(trim(text.substr(name_end + 3, unit_end - name_end - 3)));
    return Heading{std::string(trim(text.substr(1, name_end - 1))), unit.empty() ? std::nullopt : std::optional(unit)};
}

}  // namespace

Heading read_heading_of_logger(std::string_view text) {
    text = trim(text);
    if (text.find('|') != std::string_view::npos) {
        if (std::optional<Heading> barred = read_barred_heading(text)) {
            return std::move(*barred);
        }
    }
    Heading heading = read_heading(text);
    const std::size_t close = text.rfind(')');
    const std::size_t open = close == std::string_view::npos ? close : text.rfind('(', close);
    if (heading.unit || open == std::string_view::npos || open == 0) {
        return heading;
    }
    const std::string_view behind = text.substr(close + 1);  // "Speed (km/h) *OBD"
    const std::string_view unit = trim(text.substr(open + 1, close - open - 1));
    const std::string_view name = trim(text.substr(0, open));
    if (name.empty() || !is_logger_unit(unit) || !(behind.empty() || behind.starts_with(" *"))) {
        return heading;
    }
    return {fmt::format("{}{}", name, behind), std::string(unit)};
}

}  // namespace tiretherm::input
