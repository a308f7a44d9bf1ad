// SPDX-License-Identifier: BSD-3-Clause
// Spellings, and the four letters that mean two things.

#include "input/loggers/logger_units.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "input/clock/clock_words.hpp"
#include "input/text/characters.hpp"
#include "input/text/column_names.hpp"
#include "input/text/unit_text.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array units_of_loggers{
#define UNIT_OF_LOGGER(written, meant) UnitAlias{written, meant},
#include "input/text/units.list"
};

/// A unit that means one thing in a table of physics and another in a logger.
struct Ambiguous {
    std::string_view written;
    std::string_view dimension;  ///< a unit of the logger's quantity
    std::string_view meant;      ///< by a logger
    std::string_view shown;      ///< the same in words
    std::string_view otherwise;  ///< in UDUNITS' words
    bool asks = true;            ///< of a column whose quantity only its name tells
};
constexpr std::array ambiguous{
#define AMBIGUOUS_UNIT(written, dimension, meant, shown, otherwise, asks) \
    Ambiguous{written, dimension, meant, shown, otherwise, asks},
#include "input/text/units.list"
};

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
    const auto found = std::ranges::find_if(units_of_loggers, [&](const UnitAlias& unit) { return unit[0] == small; });
    const bool is_length = written == "nm";
    return found == units_of_loggers.end() || is_length ? written : std::string((*found)[1]);
}

}  // namespace

bool is_logger_unit(std::string_view written) {
    constexpr std::array plain{
#define PLAIN_UNIT(written) std::string_view(written),
#include "input/text/units.list"
    };
    const std::string small = in_small_letters(with_sign_of_degrees(written));
    return std::ranges::find(plain, small) != plain.end() || clock_spelling(written).has_value() ||
           std::ranges::any_of(units_of_loggers, [&](const UnitAlias& unit) { return unit[0] == small; });
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
#define UNIT_GUESS(written, meant) UnitAlias{written, meant},
#include "input/text/units.list"
    };
    const std::string small = in_small_letters(with_sign_of_degrees(written));
    for (const UnitAlias& guess : guesses) {
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
