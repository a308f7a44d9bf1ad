// SPDX-License-Identifier: BSD-3-Clause
// Steps and ramps of a test: stretches of a schedule over which speed and load are constant or change linearly, and such as
// are recognised in a log.
#pragma once

#include <span>
#include <vector>

#include "solver/input_signals.hpp"

namespace tiretherm::solver {

/// A stretch of a test's schedule: a step, over which speed and load stand still, or a ramp to the next one.
struct ScheduleStep {
    int number = 0;  ///< steps count from 1; a ramp has the number of the step that it leads to
    bool ramp = false;
    double from = 0.0;        ///< s
    double to = 0.0;          ///< s
    double speed = 0.0;       ///< m/s at its end; of a recognised step its mean
    double load = 0.0;        ///< N, likewise
    bool recognised = false;  ///< in a log, whose values scatter about those of the step

    [[nodiscard]] double duration() const { return to - from; }
};

/// More stretches than this are no schedule but a log.
inline constexpr std::size_t most_schedule_steps = 100;

/// The steps of a run between two times, in their order. Where speed or load follow a log they are the stretches of two minutes
/// or more over which both stand still (see recognised_steps). Empty where they change more often than a schedule does.
[[nodiscard]] std::vector<ScheduleStep> schedule_steps(const InputSignals& input_signals, double start, double end);

/// Steps in logged speed and load: stretches of two minutes or more within 1.5 % of the largest speed and 3 % of the largest load
/// of their mean, without a drift of half as much. What lies between them are ramps. Neighbours alike are one step.
/// @param looked_at out, if not null: how many samples were compared with the mean of those before; a few times as many as there are
/// @returns empty where the steps cover less than three quarters of the time: a drive, no test
[[nodiscard]] std::vector<ScheduleStep> recognised_steps(const InputSignals& input_signals, double start, double end,
                                                         std::size_t* looked_at = nullptr);

/// The same inputs, each at its mean over a step, for the steady state of that step. @pre step.duration() > 0
[[nodiscard]] InputSignals held_at_means(const InputSignals& input_signals, const ScheduleStep& step);

/// The stretch that holds a moment; at a border the earlier one, in which the state has been reached.
/// @returns null where there is none
[[nodiscard]] const ScheduleStep* step_at(std::span<const ScheduleStep> steps, double t);

}  // namespace tiretherm::solver
