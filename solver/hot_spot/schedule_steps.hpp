// SPDX-License-Identifier: BSD-3-Clause
// Steps and ramps of a test's schedule: stretches over which speed and load are constant or change linearly.
#pragma once

#include <span>
#include <vector>

#include "solver/input_signals.hpp"

namespace tiretherm::solver {

/// A stretch of a test's schedule: a step, over which speed and load stand still, or a ramp to the next one.
struct ScheduleStep {
    int number = 0;  ///< steps count from 1; a ramp has the number of the step that it leads to
    bool ramp = false;
    double from = 0.0;   ///< s
    double to = 0.0;     ///< s
    double speed = 0.0;  ///< m/s at its end
    double load = 0.0;   ///< N at its end

    [[nodiscard]] double duration() const { return to - from; }
};

/// More stretches than this are no schedule but a log.
inline constexpr std::size_t most_schedule_steps = 100;

/// The steps of a run between two times, in their order. Empty where speed and load follow a log, or change more often
/// than a schedule does.
[[nodiscard]] std::vector<ScheduleStep> schedule_steps(const InputSignals& input_signals, double start, double end);

/// The stretch that holds a moment; at a border the earlier one, in which the state has been reached.
/// @returns null where there is none
[[nodiscard]] const ScheduleStep* step_at(std::span<const ScheduleStep> steps, double t);

}  // namespace tiretherm::solver
