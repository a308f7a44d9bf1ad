// SPDX-License-Identifier: BSD-3-Clause
// Compares values that the sheets state, and the program computes itself, with the computed ones.
#pragma once

#include "input/spreadsheet/sheet_case.hpp"
#include "input/spreadsheet/sheet_rows.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input {

/// Compares what the program computes itself with what the sheets say of it: masses, areas, and measured tables
/// beside a law. Each becomes an entry of `unmapped` with both numbers.
void compare_with_sheet(const SheetContent& content, const solver::Problem& problem, SheetCase& result);

}  // namespace tiretherm::input
