// SPDX-License-Identifier: BSD-3-Clause
// Tables of a log with a line for each probe at each time.
#pragma once

#include <memory>

#include "input/tables/csv_rows.hpp"

namespace tiretherm::input {

/// A table such as
///     time [s],probe,temperature [degC]
///     0,core,25.1
///     0,shoulder,25.3
/// gets a column for each probe, called by its name, and a row for each time: its fields stay where they are in the file. A column
/// `unit` says the units, which the heading of the readings has otherwise. Any other table stays as it is.
void fold_long_table(LogTable& table, const std::shared_ptr<const CsvRows>& rows);

}  // namespace tiretherm::input
