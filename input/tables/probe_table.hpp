// SPDX-License-Identifier: BSD-3-Clause
// Reader of tables as laboratories write them: a line for each probe, a column for each moment or step of the test.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// A table whose lines are probes and whose columns are moments:
///     probe [degC],20 min,30 min,40 min
///     belt_edge,111.6,115.8,115.4
///     crown,66.2,69.3,
/// A moment is a time (`20 min`, `t = 20 min`; a bare number where the first heading has the unit, `probe / time [min]`), the
/// speed of a step of the test (`170 km/h`) or its number (`step 2`). The unit of the values stands in the first heading, in that of
/// a column, behind the name of a probe or in a column `unit`. Other columns, such as a depth, are not read, nor are lines
/// about the test above the headings. An empty field or a dash is no reading. The table's rows are the moments; its first column has
/// them, and one follows for each probe.
/// @returns nothing where a text is laid out in another way
[[nodiscard]] std::optional<LogTable> find_probe_table(const std::shared_ptr<const SourceText>& source);

}  // namespace tiretherm::input
