// SPDX-License-Identifier: BSD-3-Clause
// Effects that a user defines in a case: [[source]] adds heat, [[exchange]] adds heat transfer, both in proportion to a
// signal.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/toml/document.hpp"

/// User effects:
///     [[source]]
///     name = "throttle_heat"
///     follows = "throttle"                 # a formula of logged columns and inputs, in SI base units
///     at = "surface"                       # regions, layers, zones or patches
///     watts = "37 W"                       # at a signal of 1
///     [[exchange]]
///     name = "brake_air"
///     follows = "max(0, brake - 0.1)"
///     at = ["carcass", "liner"]
///     conductance = "5 W/K"
///     temperature = "brake_temperature"    # an input or a column; without it the air's
namespace tiretherm::input {

/// The two lists and what is said of each.
struct UserEffectKind {
    std::string_view list;    ///< "source"
    std::string_view effect;  ///< of the catalogue, its pattern
    std::string_view number;  ///< key of its parameter
};
inline constexpr UserEffectKind user_heat_source{"source", "own_source", "watts"};
inline constexpr UserEffectKind user_heat_transfer{"exchange", "own_exchange", "conductance"};

/// All signals that the lists may refer to, each once, and the texts themselves, which may be names of columns.
[[nodiscard]] std::vector<std::string> followed_names(const TomlValue& document);

/// Names of user effects, whether or not they could be read. @param list "source" or "exchange"
[[nodiscard]] std::vector<std::string> user_effect_names(const TomlValue& document, std::string_view list);

}  // namespace tiretherm::input
