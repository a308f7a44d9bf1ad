// SPDX-License-Identifier: BSD-3-Clause
// Builds the rows of a validation table from the table's definition and the results of its runs.
#pragma once

#include <vector>

#include "diagnosis/validation/validation_runs.hpp"
#include "diagnosis/validation/validation_table.hpp"
#include "input/validation/validation.hpp"

namespace tiretherm::diagnosis {

/// The numbers of a table beside what the runs say, in the units that users see.
[[nodiscard]] std::vector<ValidationRow> validation_rows(const input::Validation& table, const RunResults& results);

}  // namespace tiretherm::diagnosis
