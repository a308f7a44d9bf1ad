// SPDX-License-Identifier: BSD-3-Clause
// Values that studies and parameters write into a case: a number with its unit as written, or a word.
#pragma once

#include <optional>
#include <string>

#include "input/toml/toml_table.hpp"

namespace tiretherm::input {

/// A number and its unit as a study has them: what the quantity is, only the case that it goes into can tell.
struct Measure {
    double number = 0.0;
    std::string unit;    ///< as written; empty for a pure number
    bool whole = false;  ///< written as a whole number without a unit
    SourceLocation place;
};

/// A number of a study. @returns nothing after an error, or where the key is absent
[[nodiscard]] std::optional<Measure> read_measure(TomlTable& table, std::string_view key, Need need);

/// The number of `measure` in another unit. @param difference of two values: no offset of a scale
/// @returns nothing after an error: another dimension
[[nodiscard]] std::optional<double> in_unit(const Measure& measure, const std::string& unit, bool difference,
                                            std::string_view name, InputErrors& errors);

/// A value to be written into a case, and its number as the study shows it.
struct StudyValue {
    TomlValue node;
    std::string text;     ///< "80 km/h", "0.6", "mechanistic"
    double number = 0.0;  ///< in the unit of its quantity; NaN for a word
};

/// A number with its unit as a case has it. Nine digits, so that the shown value is the one that is run.
[[nodiscard]] StudyValue study_value(double number, const std::string& unit, bool whole, const SourceLocation& place);

/// A value from outside of a case: a pure number, true or false, a list as TOML has it, otherwise a text such as "80 km/h" without
/// quotation marks. With its place.
[[nodiscard]] TomlValue value_of(const LocatedString& written);

/// A value as it is written.
[[nodiscard]] StudyValue study_value(const TomlValue& node);

/// Whether a text is a unit, or empty.
[[nodiscard]] bool is_unit(const std::string& text);

/// The unit of a value as written; empty for a pure number and for a word.
[[nodiscard]] std::string unit_of(const TomlValue& node);

}  // namespace tiretherm::input
