// SPDX-License-Identifier: BSD-3-Clause
// The laps of a measured run's file.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "input/laps/laps.hpp"
#include "input/laps/track_laps.hpp"
#include "input/tables/data_file.hpp"

namespace tiretherm::input {

/// Looks for laps in this order: a line that the case gives; the logger's marks; a column called lap, lap_number or the like; the
/// logger's start line; and, where they are asked for, the place where the track closes.
/// @param time [n] s, of all rows  @param line of the case  @param search also where the track closes
/// @param errors of the file so far, to which nothing is added: what is wrong with its lines is said elsewhere
[[nodiscard]] Laps find_laps(const DataFile& file, const std::vector<double>& time,
                             const std::optional<StartLine>& line, bool search, const InputErrors& errors);

/// Whether a column of this name is a latitude or a longitude.
[[nodiscard]] bool is_of_position(std::string_view name);

/// Where the car was, from columns called latitude and longitude or the like; nothing without both of them. Arguments as above.
[[nodiscard]] std::optional<Positions> read_positions(const DataFile& file, const std::vector<double>& time,
                                                      const InputErrors& errors);

/// The direction in which a car drove as its receiver wrote it.
struct WrittenHeading {
    std::string column;
    std::vector<double> time;     ///< [n] s
    std::vector<double> degrees;  ///< [n] clockwise from north, NaN where it is missing
};
/// Each column of angles that is called heading, course, bearing or the like.
[[nodiscard]] std::vector<WrittenHeading> read_headings(const DataFile& file, const std::vector<double>& time,
                                                        const InputErrors& errors);

/// Whether the file has columns of a heading or of positions.
[[nodiscard]] bool tells_course(const DataFile& file);

/// Whether a column is called as one that counts laps.
[[nodiscard]] bool counts_laps(std::string_view name);

}  // namespace tiretherm::input
