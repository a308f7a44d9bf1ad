// SPDX-License-Identifier: BSD-3-Clause
// Laps of a recording: from marks of the logger, from a column that counts them, or from positions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/loggers/log_description.hpp"

namespace tiretherm::input {

enum class LapKind : std::uint8_t {
    out,     ///< from the begin of the recording to the first crossing of the line
    flying,  ///< from line to line
    in       ///< from the last crossing to the end
};

/// A lap. By marks and by positions the out-lap is number 0; a column that counts has numbers of its own.
struct Lap {
    int number = 0;
    double start = 0.0;  ///< s
    double end = 0.0;    ///< s; the next lap's start
    LapKind kind = LapKind::flying;
};

/// Where the laps of a recording are known from.
enum class LapSource : std::uint8_t { none, markers, column, start_line, closed_track };

struct Laps {
    LapSource source = LapSource::none;
    std::string column{};  ///< that counts
    std::vector<Lap> laps{};
    std::optional<double> nearest{};  ///< m, how near the car came to a start line that it never crossed
};

/// Laps between marks. Marks at the recording's ends are no crossings. Within half a second of each other they are one.
[[nodiscard]] std::vector<Lap> laps_between(const std::vector<double>& markers, double from, double to);

/// Laps by a column that counts them; empty where it does not: it never changes, goes down, or is no whole number.
/// @param time [n] s  @param number [n], NaN where it is missing
[[nodiscard]] std::vector<Lap> laps_by_counter(const std::vector<double>& time, const std::vector<double>& number);

/// The part of a recording that a choice of laps means.
struct LapWindow {
    double from = 0.0;  ///< s
    double to = 0.0;    ///< s
};
/// What `laps = "3-9"` says, as "2", "3-9" or "2, 4-6": from the first of them to the last, and the laps between them that are left
/// out.
/// @returns the window, or what is wrong with the choice, with the laps that there are
struct LapChoice {
    std::optional<LapWindow> window{};
    double first_ends = 0.0;            ///< s, the first lap that was chosen
    bool starts_from_the_pits = false;  ///< the first is the out-lap
    std::vector<LapWindow> left_out{};  ///< within the window, ascending
    std::optional<std::string> error{};
    std::string remedy{};
};
[[nodiscard]] LapChoice choose_laps(const std::string& text, const Laps& laps);

/// "the car never crosses the start line, and comes no nearer to it than 350 m", and what to do about it.
[[nodiscard]] std::string never_crossed(double nearest);
inline constexpr std::string_view line_remedy =
    "write the ends of the line on either side of the track, latitude before longitude, west and south negative";

/// 121.006 s is "2:01.006".
[[nodiscard]] std::string lap_time(double seconds);
/// "0 (out, 2:25.982), 1 (2:01.006), 2 (in, 1:10.200)"
[[nodiscard]] std::string list_laps(const std::vector<Lap>& laps);
/// "out-lap", "lap", "in-lap".
[[nodiscard]] std::string_view word_of(LapKind kind);

}  // namespace tiretherm::input
