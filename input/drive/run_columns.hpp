// SPDX-License-Identifier: BSD-3-Clause
// Says what each column of a measured run's file is: time, input, sensor, signal of a user effect, or unused.
#pragma once

#include <string>
#include <vector>

#include "input/drive/run_table.hpp"
#include "input/tables/data_file.hpp"
#include "physics/signals.hpp"

namespace tiretherm::input {

/// A column of a measured run's file that the model uses, as an input, as what a sensor read, or as both: the lateral
/// force drives the friction and may be compared with the Magic Formula's.
struct UsedColumn {
    int column = 0;
    std::string name;
    const physics::Signal* input = nullptr;  ///< null: not an input
    bool is_sensor = false;
};

/// A column that user effects follow.
struct FollowedColumn {
    int column = 0;
    std::string name;
};

/// What the columns of a measured run's file are.
struct RunColumns {
    int time = -1;
    std::vector<UsedColumn> used;
    std::vector<FollowedColumn> followed{};  ///< no inputs; may be sensors or unused otherwise
    std::vector<int> unused;
    bool misnamed = false;  ///< a column is mapped to a name that nothing has: it may be anything

    [[nodiscard]] std::vector<int> chosen() const;  ///< inputs, sensors and what is followed
};

/// Classifies the columns by their names, after `columns`, `units`, `unit_names` and `ignore` of the case have been applied
/// to the headings.
/// @param sensors names of the case's sensors  @param followed names that user effects refer to
[[nodiscard]] RunColumns classify_columns(DataFile& file, ColumnKeys& keys, const std::vector<std::string>& sensors,
                                          const std::vector<std::string>& followed, InputErrors& errors);

}  // namespace tiretherm::input
