// SPDX-License-Identifier: BSD-3-Clause
// Units as the description of an FMU defines them: a name, exponents of SI base units, a factor, and how users see the value.
#pragma once

#include <string>
#include <string_view>

namespace tiretherm::post {

/// The name of a unit in the description: "W/(m2.K)" for "W m-2 K-1".
[[nodiscard]] std::string fmi_unit(std::string_view udunits);

/// How users see values in this unit: "degC" of "K"; empty: as they are.
[[nodiscard]] std::string_view fmi_display_unit(std::string_view udunits);

/// `<Unit name="..."><BaseUnit kg="1" .../>...</Unit>`, the same in both versions.
[[nodiscard]] std::string fmi_unit_definition(std::string_view udunits);

}  // namespace tiretherm::post
