// SPDX-License-Identifier: BSD-3-Clause
// Inputs of a run below the curves that follow from them: what changes, and steps as bands with names.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "post/page/time_chart.hpp"
#include "solver/hot_spot/schedule_steps.hpp"
#include "solver/input_signals.hpp"

namespace tiretherm::post {

/// The unit in which an input is shown: km/h, degrees, °C, kPa; others as they are.
[[nodiscard]] solver::ShownUnit shown_unit(const physics::Signal& signal);

/// "190 km/h", "190 km/h, 5580 N" where both change over the steps, "5580 N" where only the load does; empty for a ramp.
/// @returns [steps]
[[nodiscard]] std::vector<std::string> step_names(std::span<const solver::ScheduleStep> steps);

/// The inputs that change between two times, speed first, of at most three units. @param start, end s
[[nodiscard]] std::vector<TimeSeries> changing_inputs(const solver::InputSignals& inputs, double start, double end);

/// Bands with names for the steps, where there are several. @param seconds of the chart's unit of time
void add_step_bands(LineChart& chart, std::span<const solver::ScheduleStep> steps, double seconds);

/// Bands with names for the laps. @param seconds of the chart's unit of time
void add_lap_bands(LineChart& chart, std::span<const input::Lap> laps, double seconds);

}  // namespace tiretherm::post
