// SPDX-License-Identifier: BSD-3-Clause
// Cells of a validation table, common to its text and Markdown forms.
#pragma once

#include <string>
#include <vector>

#include "post/validation/validation_table.hpp"

/// Cells that the table has in common, however it is set.
namespace tiretherm::post {

/// "47 to 48 +- 4.1", "> 60"; "-" where nothing was measured.
[[nodiscard]] std::string measured_text(const diagnosis::ValidationRow& row, const char* plus_minus);
/// A value with the decimals of its unit; "failed", or empty where the model has no such number.
[[nodiscard]] std::string value_text(const diagnosis::ValidationRow& row, std::size_t model);
/// "+3.2"; empty where there is no difference.
[[nodiscard]] std::string difference_text(const diagnosis::ValidationRow& row, std::size_t model);

/// The figures of every model over the numbers that all of them give, then of one that gives more; a heading first.
[[nodiscard]] std::vector<std::vector<std::string>> figure_rows(const diagnosis::ValidationRecord& record);

}  // namespace tiretherm::post
