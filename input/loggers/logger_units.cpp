// SPDX-License-Identifier: BSD-3-Clause
// Spellings, and the four letters that mean two things.

#include "input/loggers/logger_units.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "input/loggers/clock_words.hpp"
#include "input/loggers/heading_names.hpp"
#include "input/text/column_names.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

using Spelling = std::array<std::string_view, 2>;

/// In small letters. None of them is a unit of UDUNITS in this spelling, or one that no logger means (kmh is none, PSI neither).
constexpr std::array spellings{Spelling{"kmh", "km/h"},
                               Spelling{"km/hr", "km/h"},
                               Spelling{"kmph", "km/h"},
                               Spelling{"km/h", "km/h"},
                               Spelling{"kph", "km/h"},
                               Spelling{"mph", "mile/h"},
                               Spelling{"kts", "knot"},
                               Spelling{"knots", "knot"},
                               Spelling{"psi", "psi"},
                               Spelling{"psig", "psi"},
                               Spelling{"barg", "bar"},
                               Spelling{"bar(g)", "bar"},
                               Spelling{"bar", "bar"},
                               Spelling{"mbar", "mbar"},
                               Spelling{"kpa", "kPa"},
                               Spelling{"sec", "s"},
                               Spelling{"secs", "s"},
                               Spelling{"seconds", "s"},
                               Spelling{"mins", "min"},
                               Spelling{"minutes", "min"},
                               Spelling{"hr", "h"},
                               Spelling{"hrs", "h"},
                               Spelling{"hours", "h"},
                               Spelling{"meters/second", "m/s"},
                               Spelling{"m/sec", "m/s"},
                               Spelling{"rpm", "rpm"},
                               Spelling{"revs/min", "rpm"},
                               Spelling{"deg/s", "degree/s"},
                               Spelling{"deg/sec", "degree/s"},
                               Spelling{"dps", "degree/s"},
                               Spelling{"\u00B0/s", "degree/s"},
                               Spelling{"degrees", "degree"},
                               Spelling{"\u00B0", "degree"},
                               Spelling{"#", "1"},
                               Spelling{"(null)", "1"},
                               Spelling{"percent", "%"},
                               Spelling{"nm", "N m"},
                               Spelling{"metres", "m"},
                               Spelling{"meters", "m"},
                               Spelling{"none", "1"},
                               Spelling{".c", "degC"},
                               Spelling{"deg-c", "degC"},
                               Spelling{"deg-f", "degF"},
                               Spelling{"\u00B0c", "degC"},
                               Spelling{"deg c", "degC"},
                               Spelling{"celsius", "degC"},
                               Spelling{".f", "degF"},
                               Spelling{"\u00B0f", "degF"},
                               Spelling{"deg f", "degF"},
                               Spelling{"fahrenheit", "degF"}};

/// A unit that means one thing in a table of physics and another in a logger.
struct Ambiguous {
    std::string_view written;
    std::string_view dimension;  ///< a unit of the logger's quantity
    std::string_view meant;      ///< by a logger
    std::string_view shown;      ///< the same in words
    std::string_view otherwise;  ///< in UDUNITS' words
    bool asks = true;            ///< of a column whose quantity only its name tells
};
constexpr std::array ambiguous{Ambiguous{"C", "K", "degC", "degC", "coulomb"},
                               Ambiguous{"F", "K", "degF", "degF", "farad"},
                               Ambiguous{"g", "m s-2", "gravity", "9.80665 m/s2", "gram"},
                               Ambiguous{"G", "m s-2", "gravity", "9.80665 m/s2", "gauss"},
                               Ambiguous{"lb", "N", "lbf", "lbf", "pound", false},
                               Ambiguous{"lbs", "N", "lbf", "lbf", "pound", false}};

/// Whether the name says that the column is of the logger's quantity.
bool name_agrees(std::string_view name, const Ambiguous& unit) {
    if (unit.dimension == "K") {
        return is_temperature(name, "");
    }
    const std::string small = in_small_letters(name);
    constexpr std::array<std::string_view, 5> words{"acc", "gforce", "g force", "g_force", "glat"};
    return std::ranges::any_of(words, [&](std::string_view word) { return small.find(word) != std::string::npos; }) ||
           small.starts_with("g ") || small.ends_with(" g");
}

/// The sign of degrees as it is meant. What is written for it: its byte of Latin-1, of DOS and of the old Macintosh, also taken for Latin-1; two
/// letters, where UTF-8 was taken for Latin-1; the signs of the ordinal and of the ring; what stands for a byte that was lost.
std::string with_sign_of_degrees(std::string_view written) {
    constexpr std::string_view sign = "\u00B0";
    constexpr std::array<std::string_view, 9> others{"\u00C2\u00B0", "\u00C2\u00BA", "\u00BA", "\u02DA", "\uFFFD",
                                                     "\u00F8",       "\u00A1",       "\xB0",   "\xBA"};
    std::string text(trim(written));
    for (const auto& [one, letter] :
         {std::pair{"\u2103", "C"}, std::pair{"\u2109", "F"}}) {  // a sign and a letter in one
        if (text == one) {
            return std::string(sign) + letter;
        }
    }
    if (!text.starts_with(sign)) {
        const auto other = std::ranges::find_if(others, [&](std::string_view one) { return text.starts_with(one); });
        if (other == others.end()) {
            return text;
        }
        text.replace(0, other->size(), sign);
    }
    const std::size_t letter = text.find_first_not_of(' ', sign.size());
    text.erase(sign.size(), std::min(letter, text.size()) - sign.size());  // "\u00B0 C"
    return text;
}

std::string spelt(std::string_view text) {
    if (clock_spelling(text)) {
        return "s";  // times of the day are read in seconds, however they are written
    }
    const std::string written = with_sign_of_degrees(text);
    const std::string small = in_small_letters(written);
    // One letter in capitals is another unit: M is no metre. Nm and nm are a moment and a length.
    const auto found = std::ranges::find_if(spellings, [&](const Spelling& spelling) { return spelling[0] == small; });
    const bool is_length = written == "nm";
    return found == spellings.end() || is_length ? written : std::string((*found)[1]);
}

}  // namespace

bool is_logger_unit(std::string_view written) {
    constexpr std::array<std::string_view, 33> plain{
        "w",    "mw",    "kw", "s",   "ms",  "us",    "min", "h", "m",  "mm", "km", "ft", "c",  "f", "k", "g",   "m/s",
        "m/s2", "m/s^2", "mg", "deg", "rad", "rad/s", "hz",  "v", "mv", "a",  "n",  "kn", "pa", "%", "l", "degc"};
    const std::string small = in_small_letters(with_sign_of_degrees(written));
    return std::ranges::find(plain, small) != plain.end() || clock_spelling(written).has_value() ||
           std::ranges::any_of(spellings, [&](const Spelling& spelling) { return spelling[0] == small; });
}

std::string meant_unit(std::string_view written, std::string_view wanted) {
    const std::string unit = spelt(written);
    for (const Ambiguous& two : ambiguous) {
        if (unit == two.written && signature(two.dimension) == signature(wanted)) {
            return std::string(two.meant);
        }
    }
    return unit;
}

std::string guess_unit(std::string_view written, std::string_view wanted, Scale scale) {
    constexpr std::array guesses{
        Spelling{"c", "degC"},        Spelling{"deg", "degC"},    Spelling{"\u00B0", "degC"}, Spelling{"gradc", "degC"},
        Spelling{"f", "degF"},        Spelling{"k", "K"},         Spelling{"mps", "m/s"},     Spelling{"ms", "m/s"},
        Spelling{"n", "N"},           Spelling{"kn", "kN"},       Spelling{"kg", "kgf"},      Spelling{"msec", "ms"},
        Spelling{"s", "s"},           Spelling{"minutes", "min"}, Spelling{"grad", "degree"}, Spelling{"rads", "rad"},
        Spelling{"\u00BA", "degree"}, Spelling{"pct", "%"},       Spelling{"w", "W"}};
    const std::string small = in_small_letters(with_sign_of_degrees(written));
    for (const Spelling& guess : guesses) {
        if (guess[0] == small && std::holds_alternative<Conversion>(conversion(guess[1], wanted, scale))) {
            return std::string(guess[1]);
        }
    }
    return {};
}

MeantUnit meant_unit_by_name(std::string_view name, std::string_view written) {
    const std::string unit = spelt(written);
    for (const Ambiguous& two : ambiguous) {
        if (unit != two.written || !two.asks) {
            continue;
        }
        if (name_agrees(name, two)) {
            return {std::string(two.meant)};
        }
        return {unit, ErrorText{fmt::format("the column {} is in {}: {} or {}?", name, unit, two.shown, two.otherwise),
                                fmt::format("say it in the case: units = {{ \"{}\" = \"{}\" }} or \"{}\"", name,
                                            two.meant, two.otherwise)}};
    }
    return {unit};
}

}  // namespace tiretherm::input
