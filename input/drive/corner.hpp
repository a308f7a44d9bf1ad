// SPDX-License-Identifier: BSD-3-Clause
// The wheels of a car: [[corner]] with its own columns, inputs, start and values, and what axle and side it belongs to.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "input/drive/run_inputs.hpp"

namespace tiretherm::input {

/// A wheel of the car as [[corner]] describes it.
struct Corner {
    std::string name;                  ///< FL, FR, RL or RR: front or rear, left or right
    const TomlValue* table = nullptr;  ///< with what this corner has of its own: drive, initial, measured, effects
    std::shared_ptr<ColumnKeys> keys;  ///< of the columns that belong to this corner
};

/// Which corners share one value of a parameter.
enum class CornerGroup : std::uint8_t { all, axle, side, corner };

/// The group of a corner, as messages and parameters name it: "front", "left" or the corner itself; "" of all.
[[nodiscard]] std::string group_of(std::string_view corner, CornerGroup group);

/// The list [[corner]]. @param of_data the keys of [data], which count where a corner says nothing
[[nodiscard]] std::vector<Corner> read_corners(TomlTable& root, const std::shared_ptr<ColumnKeys>& of_data);

/// Reports what a run or a corner lays over the tables of the case and is of another type, which override_tables leaves out.
/// @param name of the table, for the remedy: "run"
void check_overlaid(const TomlValue& over, const std::string& name, InputErrors& errors);

/// The key `corner` of a [[run]]: what differs at a corner in this run alone. Declares its keys.
void read_corners_of_run(TomlTable& run);

/// Each run once for each corner, under the name RUN_CORNER; the runs as they are where there is no corner.
[[nodiscard]] std::vector<RunTable> at_corners(const std::vector<RunTable>& runs, const std::vector<Corner>& corners,
                                               InputErrors& errors);

/// A column of a run's file that a corner takes for its own.
struct CornerColumn {
    std::string recording;
    std::string corner;
    std::string heading;
    std::string name;  ///< of the sensor or the input
    SourceLocation place;
};
/// The columns of a run at a corner that can belong to one tire alone: those of sensors, and inputs that [[corner]] itself names.
[[nodiscard]] std::vector<CornerColumn> columns_of_one_tire(const RunTable& run, const RunFile& file);
/// Warns of each that several corners of one recording take.
void warn_of_shared_columns(const std::vector<CornerColumn>& columns, InputErrors& errors);

}  // namespace tiretherm::input
