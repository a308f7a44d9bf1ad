// SPDX-License-Identifier: BSD-3-Clause
// Channels that were recorded at different rates, as columns on the union of their times.
#pragma once

#include <vector>

#include "input/tables/log_table.hpp"

namespace tiretherm::input {

/// The times at which at least one of the columns was sampled; without any column of a channel: of all.
/// @returns s, ascending
[[nodiscard]] std::vector<double> row_times(const LogTable& table, const std::vector<int>& columns);

/// A channel's values in the rows of their own times, NaN in others. Of a channel that did not make the rows, a row has the mean of
/// the samples that are nearest to it.
/// @param rows s, ascending  @returns [rows]
[[nodiscard]] std::vector<double> in_rows(const TableColumn& channel, const std::vector<double>& rows);

}  // namespace tiretherm::input
