// SPDX-License-Identifier: BSD-3-Clause
// Syntax of TYDEX/ADAMS property files: sections, KEY = value lines, comments and tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/toml/document.hpp"

namespace tiretherm::input {

/// The lines of a TYDEX/ADAMS property file: [SECTION], KEY = value or KEY = 'text', and what follows `$` or `!`, which
/// is a comment. A table, {headings} and its rows of numbers, is passed over.
class TirLines {
public:
    struct Entry {
        std::string section;  ///< in capitals, as the key
        std::string key;
        std::string value;  ///< without quotes; empty where nothing is written
        SourceLocation key_place;
        SourceLocation place;  ///< of the value, or of the key where there is none
    };

    /// Reads what can be read and reports every other line, and every key that stands twice in its section.
    TirLines(const TextFile& file, InputErrors& errors);

    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    /// The first entry of this key with a value, in [section] or, where that is empty, anywhere but in [UNITS].
    [[nodiscard]] const Entry* find(std::string_view key, std::string_view section = {}) const;
    /// The number of a key that `find` finds; nothing when it is absent or, after an error, no finite number.
    [[nodiscard]] std::optional<double> number(std::string_view key, InputErrors& errors) const;

private:
    std::vector<Entry> entries_;
};

}  // namespace tiretherm::input
