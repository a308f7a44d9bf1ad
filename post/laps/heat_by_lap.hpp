// SPDX-License-Identifier: BSD-3-Clause
// Friction power and heat of a car's tires beside each other, corner by corner and lap by lap.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/compare/stretch.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

inline constexpr const char* heat_name = "heat.csv";

/// Whether the runs are tires of a car, or have laps.
[[nodiscard]] bool have_laps_or_corners(const std::vector<diagnosis::RunHeat>& runs);
/// Mean friction power and mean heat of each effect in watts, a column for each run; the friction power of each lap.
/// Nothing for a single tire without laps, and of steady states.
[[nodiscard]] ReportSection heat_by_lap_section(const std::vector<diagnosis::RunHeat>& runs,
                                                const std::string& heading);
/// The same as data: watts and joules of each run and each lap.
[[nodiscard]] Value heat_by_lap_data(const std::vector<diagnosis::RunHeat>& runs);
/// A row for each run and lap and each effect or part of the friction power: joules and mean watts.
[[nodiscard]] std::string heat_csv(const std::vector<diagnosis::RunHeat>& runs);

}  // namespace tiretherm::post
