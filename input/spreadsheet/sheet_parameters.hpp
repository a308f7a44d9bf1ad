// SPDX-License-Identifier: BSD-3-Clause
// Data model of what the thesis's sheets may contain: parameters and measured tables, and where each goes in a case.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input/spreadsheet/sheet_book.hpp"

/// What the sheets may say and where it goes in a case.
namespace tiretherm::input {

/// What becomes of a parameter's value.
enum class SheetUse : std::uint8_t {
    text,         ///< a text of the case
    number,       ///< a quantity of the case
    on,           ///< ON or OFF as true or false
    word,         ///< ON or OFF as "on" or "off"
    coefficient,  ///< one of the three of a law of temperature
    scale,        ///< the scale on which such a law counts temperature, degC or K
    rate,         ///< 1/K, which the case gives as the width of a transition
    sensor,       ///< ON or OFF: a sensor of the case
    computed,     ///< follows from others: the program computes it, and the value is compared with that
    none          ///< nothing in the program corresponds
};

/// A parameter of the thesis's spreadsheet.
struct SheetParameter {
    std::string_view sheet;
    std::string_view name;     ///< as the thesis's pictures show it
    std::string_view aliases;  ///< other names, such as those of the list in V.7; separated by |
    SheetUse use = SheetUse::number;
    std::string_view table;  ///< of the case: "tire", "effects.air_convection"
    std::string_view key;
    std::string_view unit;      ///< in which a value without a unit would be meant; "1" for a pure number
    std::string_view printed;   ///< units that the thesis prints for it and that mean `unit`; separated by |
    std::string_view standard;  ///< as the case writes it where the sheet is silent; empty: nothing is written
    std::string_view ground;    ///< of that default; empty: the parameter may be left out without a word
    std::string_view meaning;
    std::string_view equation;  ///< of the thesis
    std::string_view law{};     ///< of several that make up one law: its name; a measured table may stand instead

    [[nodiscard]] std::string path() const;  ///< "tire.size", empty without a key
};

[[nodiscard]] std::span<const SheetParameter> sheet_parameters();

/// The ten sheets, in the thesis's order.
[[nodiscard]] std::span<const std::string_view> sheet_names();

/// A measured column against another: it takes the place of a law in the case.
struct SheetTable {
    std::string_view sheet;
    std::string_view variable;  ///< name of its first column
    std::string_view variable_aliases;
    std::string_view variable_unit;
    std::string_view value;  ///< name of the other
    std::string_view value_aliases;
    std::string_view value_unit;
    std::string_view table;  ///< of the case; empty: it is only compared with the model
    std::string_view key;
    std::string_view law;
    std::string_view meaning;
    bool also_temperature = false;  ///< against a second variable, the temperature of the bulk
};

[[nodiscard]] std::span<const SheetTable> sheet_tables();

/// Whether a cell's text is a name or one of the aliases: capitals, blanks and punctuation do not count.
[[nodiscard]] bool is_called(std::string_view text, std::string_view name, std::string_view aliases);

/// A parameter of a sheet by its name; null when there is none.
[[nodiscard]] const SheetParameter* find_sheet_parameter(std::string_view sheet, std::string_view name);

/// Labels that stand once beside several parameters, such as "Loaded Radius" beside "Coeff A" and "Coeff B".
[[nodiscard]] bool is_sheet_label(std::string_view sheet, std::string_view text);

}  // namespace tiretherm::input
