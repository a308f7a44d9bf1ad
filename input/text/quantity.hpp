// SPDX-License-Identifier: BSD-3-Clause
// Physical quantities as users write them ("25 degC"), and the specification of unit and range that they must meet.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "input/text/input_error.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

/// What a quantity must be: its unit, the range that physics allows and the range in which it is usually found.
struct QuantitySpec {
    std::string_view unit;  ///< UDUNITS, SI with kelvin
    Scale scale = Scale::absolute;
    double low = -std::numeric_limits<double>::infinity();  ///< in `unit`
    double high = std::numeric_limits<double>::infinity();
    bool above = false;                                           ///< `low` itself is refused
    double usual_low = -std::numeric_limits<double>::infinity();  ///< beyond: a warning
    double usual_high = std::numeric_limits<double>::infinity();
    double zero_error = 0.0;  ///< of sensors, in `unit`: what they read this far below `low` is `low`

    [[nodiscard]] bool is_pure() const { return unit == "1"; }
};

/// A value in the unit of its spec, or what is wrong with it; possibly a remark on an unusual size.
struct ParsedQuantity {
    double value = 0.0;
    std::optional<ErrorText> error;
    std::string remark;
};

/// Reads "25 degC". @param name what messages call it
[[nodiscard]] ParsedQuantity parse_quantity(std::string_view text, const QuantitySpec& spec, std::string_view name);

/// What to do about numbers in a unit of absolute pressure (psia, bara, kPa abs) where a pressure above the atmosphere is
/// wanted; empty for any other unit.
[[nodiscard]] std::string absolute_pressure_remedy(std::string_view unit, const QuantitySpec& spec);

/// Converts and checks a number whose unit is known, such as a cell of a table.
/// @param shown the value as messages show it, such as `"-5 mm"` or 900 km/h  @param unit as written
[[nodiscard]] ParsedQuantity check_quantity(double written, const Conversion& unit_conversion, std::string_view unit,
                                            const QuantitySpec& spec, std::string_view name, std::string_view shown);

/// The conversion from a unit as written, or what is wrong with it.
/// @param subject start of the sentence: speed is "100 km"
struct UnitRead {
    Conversion conversion;
    std::optional<ErrorText> error;
};
[[nodiscard]] UnitRead read_unit(std::string_view unit, const QuantitySpec& spec, std::string_view subject);

/// A number at the start of a text. `rest` is what follows, blanks taken off. Empty when the text starts with none.
struct Number {
    double value = 0.0;
    std::string_view rest;
};
[[nodiscard]] std::optional<Number> leading_number(std::string_view text);

/// `"8 mm"`, or `0.6` for a pure number.
[[nodiscard]] std::string spell_example(const QuantitySpec& spec);

/// "write a length, such as "8 mm"".
[[nodiscard]] std::string write_like(const QuantitySpec& spec);

}  // namespace tiretherm::input
