// SPDX-License-Identifier: BSD-3-Clause
// Rewrites units as engineers write them for UDUNITS: aliases and products such as W/mK.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace tiretherm::input {

/// The text of a unit as UDUNITS should see it: aliases replaced, the products that engineers write behind a slash
/// spelt out. `W/mK` is watts per metre and kelvin here; UDUNITS takes it for watts per millikelvin.
[[nodiscard]] std::string spelt_out(std::string_view written);

/// Units whose whole text is read as something else: {"kph", "km/h"}.
using UnitAlias = std::array<std::string_view, 2>;
[[nodiscard]] std::span<const UnitAlias> unit_aliases();

/// The unit of a pressure above the atmosphere that belongs to one of an absolute pressure: "psia" and "psi abs" give "psi",
/// "bar(a)" "bar". Empty for any other text.
[[nodiscard]] std::string_view gauge_unit_of(std::string_view absolute);

/// Whether a unit holds a number that is neither an exponent nor a 1 that is divided. UDUNITS would read "mm 3" as
/// three millimetres and "K @ 5" as a shifted kelvin.
[[nodiscard]] bool has_number(std::string_view unit);

}  // namespace tiretherm::input
