// SPDX-License-Identifier: BSD-3-Clause
// What a data logger's file says beside its columns: format, details of the recording, marks between laps.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tiretherm::input {

/// A line across the track; a lap ends where the car crosses it.
struct StartLine {
    double latitude_a = 0.0;   ///< degrees, north
    double longitude_a = 0.0;  ///< degrees, east
    double latitude_b = 0.0;
    double longitude_b = 0.0;
};

/// What a logger says about a recording: "Vehicle", "Porsche 992".
struct LogDetail {
    std::string name;
    std::string value;
};

/// What the head of a logger's file says.
struct LogDescription {
    std::string format = "CSV";
    std::vector<LogDetail> details{};
    std::vector<double> markers{};  ///< s, ascending: where a lap ends and the next begins
    std::optional<StartLine> start_line{};
    bool west_is_positive = false;  ///< of its longitudes
};

}  // namespace tiretherm::input
