// SPDX-License-Identifier: BSD-3-Clause
// Lists of months, weekdays, zones and of what units say of clocks.

#include "input/clock/clock_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace tiretherm::input {

int month_of(std::string_view word) {
    // Three letters and a blank each, so that a month is the place over four. German ones that begin otherwise follow; the ä of
    // März is two bytes, so that its first three are m and ä.
    constexpr std::string_view names = "jan feb mar apr may jun jul aug sep oct nov dec mrz mai okt dez m\u00E4";
    constexpr std::array months{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 3, 5, 10, 12, 3};
    const std::size_t at = word.size() < 3 ? std::string_view::npos : names.find(word.substr(0, 3));
    return at == std::string_view::npos || at % 4 != 0 ? 0 : months[at / 4];
}

bool is_weekday(std::string_view word) {
    constexpr std::string_view names = "mon tue wed thu fri sat sun";
    const std::size_t at = word.size() < 3 ? std::string_view::npos : names.find(word.substr(0, 3));
    return at != std::string_view::npos && at % 4 == 0;
}

std::optional<int> zone_of(std::string_view name) {
    struct Zone {
        std::string_view name;
        int hours;
    };
    constexpr std::array zones{Zone{"z", 0},    Zone{"utc", 0},  Zone{"gmt", 0},  Zone{"cet", 1},
                               Zone{"cest", 2}, Zone{"mez", 1},  Zone{"mesz", 2}, Zone{"est", -5},
                               Zone{"edt", -4}, Zone{"cst", -6}, Zone{"cdt", -5}, Zone{"mst", -7},
                               Zone{"mdt", -6}, Zone{"pst", -8}, Zone{"pdt", -7}, Zone{"jst", 9}};
    const auto found = std::ranges::find(zones, name, &Zone::name);
    return found == zones.end() ? std::nullopt : std::optional(found->hours);
}

std::optional<ClockSpelling> clock_spelling(std::string_view unit) {
    std::string letters;  // one for each part
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
        if (!is_letter(unit[i])) {
            continue;
        }
        const auto c = static_cast<char>(std::tolower(static_cast<unsigned char>(unit[i])));
        const bool goes_on = i > 0 && is_letter(unit[i - 1]);
        // "dd/mm/yyyy" repeats one letter in each part. A unit with two letters side by side, as km/h, says nothing of clocks.
        if (goes_on && letters.back() != c) {
            return std::nullopt;  // a word
        }
        if (!goes_on) {
            letters += c;
        }
    }
    if (letters == "hm" && unit.find(':') != std::string_view::npos) {
        return ClockSpelling{.is_minutes = false};
    }
    if ((letters == "ms" || letters == "mss") && unit.find(':') != std::string_view::npos) {
        return ClockSpelling{.is_minutes = true};
    }
    struct Named {
        std::string_view letters;
        DateOrder order;
    };
    // The last in German: TT.MM.JJJJ.
    constexpr std::array known{Named{"dmy", DateOrder::day_month_year}, Named{"mdy", DateOrder::month_day_year},
                               Named{"ymd", DateOrder::year_month_day}, Named{"tmj", DateOrder::day_month_year}};
    const auto found =
        std::ranges::find_if(known, [&](const Named& named) { return letters.starts_with(named.letters); });
    return found == known.end() ? std::nullopt : std::optional(ClockSpelling{.order = found->order});
}

}  // namespace tiretherm::input
