// SPDX-License-Identifier: BSD-3-Clause
// --unit COLUMN=UNIT of `tiretherm new LOG` and `tiretherm check LOG`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "input/new_case/log_columns.hpp"

namespace tiretherm::app {

/// Columns and their units, split at the last `=` of each word. @returns nothing after an error, which has been reported
[[nodiscard]] std::optional<std::vector<input::GivenUnit>> given_units(const std::vector<std::string>& words,
                                                                       bool json);

}  // namespace tiretherm::app
