// SPDX-License-Identifier: BSD-3-Clause
// Rules on the words of a heading: which it must have, and which make it something else.

#include "input/loggers/car_columns.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

#include "input/text/column_names.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

using Words = std::vector<std::string>;

/// A rule of column_names.list.
struct NameRule {
    std::string_view name;
    std::string_view first;
    std::string_view second;
    std::string_view without;
    std::string_view question{};  ///< what the heading leaves open
};

std::span<const NameRule> rules_of_car() {
    using namespace column_words;
    static constexpr std::array rules{
#define CAR_COLUMN(name, first, second, without) NameRule{name, first, second, without},
#include "input/text/column_names.list"
    };
    return rules;
}

std::span<const NameRule> rules_of_corner() {
    using namespace column_words;
    static constexpr std::array rules{
#define CORNER_COLUMN(name, first, second, without, question) NameRule{name, first, second, without, question},
#include "input/text/column_names.list"
    };
    return rules;
}

constexpr std::array<std::array<std::string_view, 2>, 3> zones{{{"outside_shoulder_", "outer outside outboard out"},
                                                                {"crown_", "middle mid centre center"},
                                                                {"inside_shoulder_", "inner inside inboard in"}}};

bool has_any(const Words& words, std::string_view list) {
    return std::ranges::any_of(words, [&](const std::string& word) { return has_word(list, word); });
}

bool agrees(const Words& words, const NameRule& rule) {
    return has_any(words, rule.first) && (rule.second.empty() || has_any(words, rule.second)) &&
           !has_any(words, rule.without);
}

/// "3" or "03" of an array of readings, not "2025".
bool is_place(std::string_view word) {
    constexpr std::size_t digits = 2;
    return word.size() <= digits &&
           std::ranges::all_of(word, [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

/// "LFtempCM" as LF tempCM: the letters of a corner stick to the word.
std::string with_corner_apart(std::string_view heading) {
    std::string apart(heading);
    const std::string letters = apart.substr(0, 2);
    const bool is_corner = letters == "LF" || letters == "RF" || letters == "LR" || letters == "RR" ||
                           letters == "FL" || letters == "FR" || letters == "RL";
    if (is_corner && apart.size() > 2 && std::islower(static_cast<unsigned char>(apart[2])) != 0) {
        apart.insert(2, " ");
    }
    return apart;
}

std::string corner_of(const Words& words) {
    struct Spelling {
        std::string_view corner;
        std::string_view alone;
        std::string_view axle;
        std::string_view side;
    };
    constexpr std::array spellings{Spelling{"FL", "fl lf frontleft leftfront", "front", "left"},
                                   Spelling{"FR", "fr rf frontright rightfront", "front", "right"},
                                   Spelling{"RL", "rl lr rearleft leftrear", "rear", "left"},
                                   Spelling{"RR", "rr rearright rightrear", "rear", "right"}};
    for (const Spelling& spelling : spellings) {
        if (has_any(words, spelling.alone) || (has_any(words, spelling.axle) && has_any(words, spelling.side))) {
            return std::string(spelling.corner);
        }
    }
    return {};
}

/// A reading of one tire: where across the tread, as far as a word says it.
void add_of_corner(const Words& words, const std::string& corner, std::vector<CarColumn>& found) {
    int rank = 0;
    for (const NameRule& rule : rules_of_corner()) {
        ++rank;
        if (!agrees(words, rule)) {
            continue;
        }
        CarColumn column{.name = std::string(rule.name), .corner = corner, .rank = rank, .question = rule.question};
        if (rule.name == "surface_temperature") {
            const auto zone = std::ranges::find_if(zones, [&](const auto& one) { return has_any(words, one[1]); });
            if (zone != zones.end()) {
                column.name = std::string((*zone)[0]) + column.name;
            } else if (const auto number = std::ranges::find_if(words, is_place); number != words.end()) {
                column.place = std::stoi(*number);
            }
        }
        found.push_back(std::move(column));
    }
}

}  // namespace

std::string corner_of(std::string_view heading) { return corner_of(words_of(with_corner_apart(heading))); }

std::vector<CarColumn> car_columns(std::string_view heading) {
    const Words words = words_of(with_corner_apart(heading));
    const std::string corner = corner_of(words);
    std::vector<CarColumn> found;
    if (!corner.empty()) {
        add_of_corner(words, corner, found);
        return found;
    }
    int rank = 0;
    for (const NameRule& rule : rules_of_car()) {
        ++rank;
        if (agrees(words, rule)) {
            // Before it knows where it is a GPS makes accelerations of nothing; speeds it has best.
            const bool is_derived = is_motion(rule.name) && has_any(words, "gps calc");
            const int behind = is_derived ? static_cast<int>(rules_of_car().size()) : 0;
            found.push_back({.name = std::string(rule.name), .corner = {}, .rank = rank + behind});
        }
    }
    return found;
}

std::vector<CarColumn> car_columns(const Heading& heading) {
    std::vector<CarColumn> found = car_columns(heading.name);
    for (const auto& [spec, word] :
         {std::pair(quantity_specs::temperature, " temperature"), std::pair(QuantitySpec{.unit = "Pa"}, " pressure")}) {
        if (found.empty() && heading.unit && !read_heading_unit(heading, spec).error) {
            found = car_columns(heading.name + word);
            for (CarColumn& column : found) {  // less sure than a name that says it
                column.rank += static_cast<int>(rules_of_car().size() + rules_of_corner().size());
            }
        }
    }
    return found;
}

bool names_an_axis(std::string_view heading) {
    const Words words = words_of(heading);
    return has_any(words, column_words::axis_x) || has_any(words, column_words::axis_y) ||
           has_any(words, column_words::axis_z);
}

bool is_motion(std::string_view name) {
    return name == "longitudinal_acceleration" || name == "lateral_acceleration" || name == "yaw_rate" ||
           name == "steering_wheel_angle";
}

}  // namespace tiretherm::input
