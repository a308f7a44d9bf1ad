// SPDX-License-Identifier: BSD-3-Clause
// Continues a step-speed test beyond its last step, to find the step in which a critical temperature would be passed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input/runs/hot_spots.hpp"
#include "solver/hot_spot/schedule_steps.hpp"

namespace tiretherm::input {

/// A test that goes on after its last step as it went before: the speed rises by what it rose last, and each further
/// step is as long as the last but one (the last is often prolonged), at the same load.
struct ContinuedSchedule {
    std::optional<solver::Problem> problem{};  ///< of the whole test with its further steps
    std::string refusal{};                     ///< why there are none; empty where there are
    double rise = 0.0;                         ///< m/s from step to step
    double duration = 0.0;                     ///< s of a further step
    int steps = 0;  ///< further ones, up to the highest speed at which a tire's model means anything
};

/// No further step is faster: beyond, laws and standing waves are guesses. m/s
inline constexpr double fastest_continued = 300.0 / 3.6;
/// A test to failure is over by then.
inline constexpr int most_continued = 30;

/// @param steps of the case's run
[[nodiscard]] ContinuedSchedule continue_schedule(const HotSpotCase& of, const solver::Settings& settings,
                                                  std::span<const solver::ScheduleStep> steps);

}  // namespace tiretherm::input
