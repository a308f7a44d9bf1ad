// SPDX-License-Identifier: BSD-3-Clause
// Columns of a case's runs that are read in another unit, or as what another column was said to be.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/toml/document.hpp"

namespace tiretherm::input {

/// How the reading of a column is changed.
struct ColumnChange {
    std::string heading;  ///< as the files have it
    std::string unit{};   ///< in which its numbers are; empty: as the file or the case says
    std::string name{};   ///< of the input or the sensor that it is; empty: as the file or the case says
    std::string run{};    ///< the recording in which it is so; empty: all

    friend bool operator==(const ColumnChange& a, const ColumnChange& b) = default;
};

/// Writes the keys `columns` and `units` that make the changes into a case: of all runs into [data], [[run]] and [[corner]], of one
/// run into its [[run]].
/// @param data files that take the place of the case's runs. Where a change is of one run they become [[run]] tables, with the keys
/// of [data], and none is left here
void change_columns(TomlValue& document, const std::vector<ColumnChange>& changes,
                    std::vector<std::filesystem::path>& data);

/// The same in one table: [data], or one of [[run]].
void change_column(TomlValue& table, const ColumnChange& change);
/// Whether a table has the keys already, so that what [data] says would not count.
[[nodiscard]] bool says_column(const TomlValue& table, const ColumnChange& change);

/// A file beside a case as a [[run]] table: its name where the file does not give it, and how [data] says that it is read.
/// @param folder that the paths lead from; empty: they stay
[[nodiscard]] TomlValue run_table_of_file(const std::string& name, const std::filesystem::path& file,
                                          const TomlValue* data, const std::filesystem::path& folder);

}  // namespace tiretherm::input
