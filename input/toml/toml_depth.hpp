// SPDX-License-Identifier: BSD-3-Clause
// Scans a TOML text without a parser: keys of too many parts and values within too many others, which the parser would
// recurse into, and brackets that are left open.
#pragma once

#include <optional>
#include <string_view>

namespace tiretherm::input {

/// Keys and values may stand one within the other so deep. A case needs seven levels: [[run]], drive, schedule, rows.
inline constexpr int most_levels = 64;

/// A place of a text, counted from 1; the column in characters.
struct TextPlace {
    int line = 0;
    int column = 0;
};

/// Where a TOML text goes deeper than `most_levels`: each part of a dotted key counts, and each bracket about a value.
/// Of a text that is not valid TOML the answer may be about any line. Takes a time linear in the text, and no stack.
[[nodiscard]] std::optional<TextPlace> first_too_deep(std::string_view text);

/// The line in which the outermost bracket is opened that a TOML text leaves open; 0 where there is none.
[[nodiscard]] int line_of_open_bracket(std::string_view text);

}  // namespace tiretherm::input
