// SPDX-License-Identifier: BSD-3-Clause
// When the steps of a test end that the columns of a table of probes name by speed or number.
#pragma once

#include <optional>
#include <vector>

#include "input/tables/data_file.hpp"
#include "input/toml/document.hpp"

namespace tiretherm::input {

/// The end of each step that the columns of a table name, by the schedule of the case.
/// @param document the case with the run's tables over it
/// @returns s, one for each moment; nothing after an error
[[nodiscard]] std::optional<std::vector<double>> step_times(const DataFile& file, const TomlValue& document,
                                                            InputErrors& errors);

}  // namespace tiretherm::input
