// SPDX-License-Identifier: BSD-3-Clause
// Results of a hot spot analysis as data: histories, moments of passing a critical temperature, further steps, surface
// threshold and uncertainty.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/remarks/remark.hpp"
#include "solver/hot_spot/hot_spot.hpp"
#include "solver/hot_spot/hot_spot_drivers.hpp"
#include "solver/hot_spot/hot_spot_steady.hpp"
#include "solver/hot_spot/schedule_steps.hpp"

namespace tiretherm::diagnosis {

/// A moment of a test, as its report tells it.
struct TestMoment {
    double time = 0.0;                           ///< s since the start of the clock
    bool steady = false;                         ///< a steady state, which has inputs but no time
    double speed = 0.0;                          ///< m/s
    double load = 0.0;                           ///< N
    std::optional<solver::ScheduleStep> step{};  ///< that holds it; none where the test follows a log
    double temperature = 0.0;                    ///< K, of the hot spot
    double surface = 0.0;                        ///< K, of the reading beside the hot spot; NaN where there is none
};

/// When the critical temperature would be passed if the test went on.
struct FurtherSteps {
    std::string refusal{};                ///< why nobody can say; empty where the test was gone on with
    double rise = 0.0;                    ///< m/s from step to step
    double duration = 0.0;                ///< s of a step
    std::optional<TestMoment> passing{};  ///< nothing where it was not passed in the further steps either
    double last_speed = 0.0;              ///< m/s, of the last step that was looked at
    double hottest = 0.0;                 ///< K, until then
    double kelvin_per_step = 0.0;         ///< K, how much hotter the step of the passing ends than the one before it
};

/// One hot spot of a run and what becomes of it.
struct HotSpot {
    solver::HotSpotHistory history;
    TestMoment hottest{};  ///< where the hottest place of the run is one of its part: that of the run's report
    std::optional<TestMoment> passing{};           ///< of the critical temperature, in the run itself
    std::vector<solver::SpotAndSurface> at_end{};  ///< [steps] when the step ends
    std::vector<solver::SpotAndSurface> steady{};  ///< [steps] if the step were held for ever
    double surface_threshold = 0.0;                ///< K, see solver::surface_threshold
    double surface_time = 0.0;                     ///< s, when the surface passes it; NaN: it does not
    std::optional<FurtherSteps> further{};         ///< where the critical temperature is not passed
    std::optional<solver::Spread> spread{};        ///< where the case has uncertain numbers
};

/// All hot spots that a case asks for.
struct HotSpots {
    std::vector<solver::ScheduleStep> steps{};
    std::vector<HotSpot> spots{};
    Remarks notes{};  ///< what could not be found
};

}  // namespace tiretherm::diagnosis
