// SPDX-License-Identifier: BSD-3-Clause
// Takes each column of a log for the time, an input or what a sensor reads, by its name and unit.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "input/new_case/log_columns.hpp"

namespace tiretherm::input {

/// What the columns of a file are.
struct LogMeaning {
    std::vector<LogColumn> columns;
    std::vector<ColumnMeaning> meanings;  ///< all that a column may be, with the readings of an array
    bool is_car = false;
    int infrared_zones = 0;  ///< readings across the tread of each tire; 0: no array
};

/// @param mesh whose sensors a column may belong to  @param dead columns that are nothing, by their index, and why
[[nodiscard]] LogMeaning meaning_of_columns(const DataFile& file, const MeshTemplate& mesh,
                                            const std::map<int, std::string>& dead, InputErrors& errors);

}  // namespace tiretherm::input
