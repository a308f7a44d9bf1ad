// SPDX-License-Identifier: BSD-3-Clause
// What each sensor shows lap by lap and over a whole run: tables, charts, data and laps.csv.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/compare/stretch.hpp"
#include "post/report/report.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

/// A sensor in one lap of a run, or over the whole run. SI
struct LapRow {
    std::string run;
    std::string corner{};             ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    std::optional<input::Lap> lap{};  ///< nothing: the whole run
    double seconds = 0.0;
    std::string channel;
    solver::ShownUnit unit{};
    diagnosis::StretchValues simulated{};
    std::optional<diagnosis::StretchValues> measured{};
    double bias = std::numeric_limits<double>::quiet_NaN();  ///< mean of simulated - measured
    double rmse = std::numeric_limits<double>::quiet_NaN();
};

/// "out", "3", "in": in-laps of several runs may have different numbers.
[[nodiscard]] std::string lap_name(const input::Lap& lap);
/// What runs are called in a heading: by their corners alone where all are of one recording.
[[nodiscard]] std::vector<std::string> short_names(const std::vector<std::string>& runs);
/// Names of laps without repetition, out-laps first and in-laps last.
[[nodiscard]] std::vector<std::string> names_of_laps(const std::vector<std::vector<input::Lap>>& laps);

/// Whether there is anything to say beside the page of a single tire without laps.
[[nodiscard]] bool have_laps_or_corners(const std::vector<LapRow>& rows);
/// A table and a chart for each channel. Below it where there are measured values: the bias of each lap.
/// @param rows of a channel together, the whole run behind its laps
/// @param of_model behind the heading, such as " after the fit"; may be empty
[[nodiscard]] ReportSection lap_section(const std::vector<LapRow>& rows, const std::string& of_model = {});
/// `laps` and `run_values` of the data, in the units that users see.
void add_lap_data(Value& data, const std::vector<LapRow>& rows);
/// A row for each channel, run and lap, and for each run as a whole.
[[nodiscard]] std::string laps_csv(const std::vector<LapRow>& rows);

inline constexpr const char* laps_name = "laps.csv";

}  // namespace tiretherm::post
