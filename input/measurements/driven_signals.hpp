// SPDX-License-Identifier: BSD-3-Clause
// What acts on the tire in a run, and what logs give beside it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "input/laps/course_over_ground.hpp"
#include "input/measurements/logged_signal.hpp"
#include "solver/input_signals.hpp"

namespace tiretherm::input {

/// Signals that something gives, rightly or wrongly written, and where.
using GivenSignals = std::map<std::string, SourceLocation, std::less<>>;

struct DrivenSignals {
    solver::InputSignals inputs{};
    GivenSignals given{};
    std::vector<UserColumn>
        columns{};              ///< that user effects and [vehicle] follow: of the run's file, then of logs of [drive]
    CourseOverGround course{};  ///< of a car: by the run's file, or else by a log of [drive]
};

}  // namespace tiretherm::input
