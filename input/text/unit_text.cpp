// SPDX-License-Identifier: BSD-3-Clause
// Replaces aliases (units.list), and spells out the products behind a slash (mK, m2K, kgK).

#include "input/text/unit_text.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array whole_units{
#define UNIT_ALIAS(written, meant) UnitAlias{written, meant},
#include "input/text/units.list"
};

/// Products that follow a slash after a power or an energy. Elsewhere mK is a millikelvin.
constexpr std::array<UnitAlias, 11> products{{{"mK", "m K"},
                                              {"m2K", "m2 K"},
                                              {"m^2K", "m2 K"},
                                              {"m\u00B2K", "m2 K"},
                                              {"m2.K", "m2 K"},
                                              {"m.K", "m K"},
                                              {"m3K", "m3 K"},
                                              {"kgK", "kg K"},
                                              {"gK", "g K"},
                                              {"mK2", "m K2"},
                                              {"mK^2", "m K2"}}};

std::string_view meaning(const auto& aliases, std::string_view text) {
    const auto found =
        std::find_if(aliases.begin(), aliases.end(), [&](const UnitAlias& alias) { return alias[0] == text; });
    return found == aliases.end() ? text : (*found)[1];
}

bool is_power_or_energy(std::string_view unit) {
    if (unit.size() > 1 && std::string_view("mkM").find(unit.front()) != std::string_view::npos) {
        unit.remove_prefix(1);
    }
    return unit == "W" || unit == "J";
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

}  // namespace

std::span<const UnitAlias> unit_aliases() { return whole_units; }

std::string spelt_out(std::string_view written) {
    std::string text(meaning(whole_units, trim(written)));
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos || !is_power_or_energy(trim(std::string_view(text).substr(0, slash)))) {
        return text;
    }
    std::string result = text.substr(0, slash);
    for (std::size_t start = slash + 1; start <= text.size();) {
        const std::size_t end = std::min(text.find('/', start), text.size());
        std::string_view part = trim(std::string_view(text).substr(start, end - start));
        if (part.size() > 2 && part.front() == '(' && part.back() == ')') {
            part = part.substr(1, part.size() - 2);
        }
        if (part.find_first_of("()") != std::string_view::npos) {
            return text;  // nested: left to UDUNITS
        }
        const std::string_view factors = meaning(products, part);
        const bool as_written = factors == part && text[start] != '(';
        result += as_written ? "/" + std::string(part) : "/(" + std::string(factors) + ")";
        start = end + 1;
    }
    return result;
}

std::string_view gauge_unit_of(std::string_view absolute) {
    constexpr std::array<std::string_view, 6> pressures{"psi", "bar", "mbar", "hPa", "kPa", "MPa"};
    constexpr std::array<std::string_view, 4> marks{"(abs)", "(a)", "abs", "a"};
    const std::string unit = in_small_letters(trim(absolute));
    for (const std::string_view mark : marks) {
        if (!unit.ends_with(mark)) {
            continue;
        }
        std::string_view rest = std::string_view(unit).substr(0, unit.size() - mark.size());
        while (rest.ends_with(' ') || rest.ends_with('_') || rest.ends_with('.') || rest.ends_with('-')) {
            rest.remove_suffix(1);
        }
        const auto found = std::ranges::find_if(
            pressures, [&](std::string_view pressure) { return in_small_letters(pressure) == rest; });
        if (found != pressures.end()) {
            return *found;
        }
    }
    return {};
}

bool has_number(std::string_view unit) {
    char before = '(';  // last character that is not blank
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const char c = unit[i];
        if (c == '@') {
            return true;
        }
        const bool follows_word = i > 0 && std::isalnum(static_cast<unsigned char>(unit[i - 1])) != 0;
        if (is_digit(c) && !follows_word) {
            // Exponents are written m2, m^2, m**2, m-2 and (m)2; any other number would scale the unit, as in "10 mm".
            const bool power = before == '*' && i > 1 && unit[i - 2] == '*';
            const bool exponent = before == '^' || before == '-' || before == '+' || before == ')' || power;
            const bool one = c == '1' && before == '(' && (i + 1 == unit.size() || !is_digit(unit[i + 1]));
            if (!exponent && !one) {
                return true;
            }
        }
        if (c != ' ') {
            before = c;
        }
    }
    return false;
}

}  // namespace tiretherm::input
