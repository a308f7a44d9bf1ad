// SPDX-License-Identifier: BSD-3-Clause
// What the columns of a car's log may be by the names that loggers give them, before one of them is taken for each thing.
#pragma once

#include <cstddef>
#include <vector>

#include "input/loggers/car_columns.hpp"
#include "input/new_case/log_columns.hpp"

namespace tiretherm::input {

/// A column and a thing that it may be by a rule for cars.
struct CarCandidate {
    std::size_t column = 0;
    CarColumn is{};
};

/// Whether a column's unit is one of this quantity, or missing. @param meaning null: a temperature, for which another mesh has a place
[[nodiscard]] bool has_unit_for(const Heading& heading, const ColumnMeaning* meaning);

/// What the columns that nothing is known of may be, the surest first; units of another kind rule a thing out.
[[nodiscard]] std::vector<CarCandidate> car_candidates(const std::vector<LogColumn>& columns,
                                                       const std::vector<ColumnMeaning>& meanings);

/// Readings of one tire that are numbered without a gap are an array; its sensors are called infrared_1, infrared_2 ... Of others
/// the user must say where they are. @returns how many an array has; 0: there is none
int name_arrays(std::vector<CarCandidate>& candidates);

/// Several readings of one tire's tread of which none is the surer: the user must say which it is.
void ask_about_equals(std::vector<CarCandidate>& candidates);

}  // namespace tiretherm::input
