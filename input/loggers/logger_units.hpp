// SPDX-License-Identifier: BSD-3-Clause
// Units as data loggers write them: C for degC, g for the acceleration of gravity, kmh, PSI.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "input/text/input_error.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

/// Whether a text is a unit as loggers write them: "sec", "km/h", "C", "kPa". What round brackets have may be something else.
[[nodiscard]] bool is_logger_unit(std::string_view written);

/// The unit that a logger means in a column that is read as a given quantity: C of a temperature is degC and F is degF, not
/// coulomb and farad; G and g of an acceleration are 9.80665 m/s2, not gauss and gram; lb of a force is lbf. Spellings of loggers (kmh, PSI, dps) are
/// replaced for every quantity; other units stay as they are.
/// @param wanted unit of the quantity
[[nodiscard]] std::string meant_unit(std::string_view written, std::string_view wanted);

/// The unit that was probably meant by one that cannot be taken as it is: "deg" of a temperature is degC, kg of a force kgf.
/// @returns empty: no guess
[[nodiscard]] std::string guess_unit(std::string_view written, std::string_view wanted, Scale scale);

/// The same as meant_unit for a column whose quantity nothing but its name tells, as that of a signal which a formula follows.
struct MeantUnit {
    std::string unit;
    std::optional<ErrorText> error{};  ///< the name does not decide between two meanings
};
[[nodiscard]] MeantUnit meant_unit_by_name(std::string_view name, std::string_view written);

}  // namespace tiretherm::input
