// SPDX-License-Identifier: BSD-3-Clause
// Which column of a logger's file is its time, and how it is written.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// Takes the fields of a column one after the other. @returns false when it needs no more
using FieldVisitor = std::function<bool(std::string_view field)>;

/// Units that the name of a time has at its end where it has no other: timestamp_ms, TimestampMS, time_s.
void take_time_units(std::vector<ColumnHead>& heads);

/// How the numbers of a column are written, by its name, its unit and its fields: as clocks of the day, as their digits, as seconds or
/// milliseconds since 1970, or as numbers.
/// @param first field  @param visit lets a visitor take all of them; called where the first may be the digits of a clock
[[nodiscard]] FieldForm form_of(const ColumnHead& head, std::string_view first,
                                const std::function<void(const FieldVisitor&)>& visit);

/// Marks the column that is the time of the file where none is called `time`: Time, timestamp, elapsed time, session time, or the only clock of the
/// day.
void mark_clock(std::vector<ColumnHead>& heads);

/// Notes the column that has the dates of the file's time, where that is a clock without any.
/// @param first [n] fields of the first row, at most one for each head
void find_dates(std::vector<ColumnHead>& heads, const std::vector<std::string_view>& first);

}  // namespace tiretherm::input
