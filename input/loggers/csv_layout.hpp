// SPDX-License-Identifier: BSD-3-Clause
// Where the names, units and values stand in the text files of data loggers, found by their content.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/loggers/log_description.hpp"
#include "input/tables/csv.hpp"

namespace tiretherm::input {

/// A column of which a program's files do not say all that is known.
struct KnownColumn {
    std::string_view heading;  ///< as it is written, without unit
    std::string_view name;     ///< in its place; empty: it stays
    std::string_view unit;     ///< where it has none
};

/// How the text of a logger is laid out.
struct CsvLayout {
    LogDescription description{};
    HeadLines lines{};
    char separator = ',';
    CsvLine sources{};                 ///< names the device of each column; without number: none
    std::vector<std::string> units{};  ///< of the columns, where no line has them; empty: that of `lines`
    std::vector<KnownColumn> known{};
    bool round_brackets = false;        ///< headings are written "Speed (m/s) *gps"
    int defect_line = 0;                ///< where `defect` stands
    std::optional<ErrorText> defect{};  ///< the file names a logger and is not laid out as its files are
};

/// The layout of a text file: that of the logger whose first lines it has, otherwise that of a CSV with or without lines of
/// comment (# or //).
/// @param text without a byte order mark
[[nodiscard]] CsvLayout find_csv_layout(std::string_view text);

/// Of one format; nothing for another.
#define TEXT_LOG(name) [[nodiscard]] std::optional<CsvLayout> find_##name##_layout(std::string_view text);
#include "input/loggers/loggers.list"

/// Whether a line is a comment: # or // at its beginning, or a mark that the driver set in a log of TunerStudio.
[[nodiscard]] bool is_comment(std::string_view line);

/// Splits "Session,Test" or "\"Session\";\"Test\"" as a detail; empty values are left out. @returns the fields after the key
std::vector<std::string> read_detail(std::string_view line, char separator, LogDescription& into);

}  // namespace tiretherm::input
