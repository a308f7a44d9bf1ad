// SPDX-License-Identifier: BSD-3-Clause
// Columns of tire test machines, which are called by a symbol each: ET V SA IA P FX FY FZ RST TSTI TSTC TSTO AMBTMP SR SL.
#pragma once

#include <string_view>
#include <vector>

#include "input/new_case/log_columns.hpp"

namespace tiretherm::input {

/// What a machine's symbol stands for.
struct RigColumn {
    std::string_view symbol;  ///< in small letters
    std::string_view
        name;  ///< the time, an input or a sensor of a case; empty: nothing that a tire's temperature follows from
};

/// The column of a test machine by its heading without the unit, whatever its capitals; null: none.
[[nodiscard]] const RigColumn* find_rig_column(std::string_view heading);

/// Whether the headings are those of a test machine: FZ and four more of its symbols.
[[nodiscard]] bool is_rig_file(const std::vector<LogColumn>& columns);

/// Turns the sign of a load that is negative where the road presses (SAE J670), and that of an inclination whose hot shoulder
/// says that it leans to the other side, by their units: "-1 N". The columns' values are those of a case then.
void turn_signs(Log& log);

}  // namespace tiretherm::input
