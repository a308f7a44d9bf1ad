// SPDX-License-Identifier: BSD-3-Clause
// Follows the hot spots of a run with critical temperatures and predicts when these are passed: in each step, held for
// ever, and in further steps.
#pragma once

#include <optional>
#include <vector>

#include "diagnosis/hot_spot/hot_spots.hpp"
#include "input/runs/hot_spots.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::diagnosis {

/// Follows the hot spots of a run that a case asks for, and then finds out what becomes of them: step by step, held for
/// ever, in further steps, and how sure all that is.
class HotSpotTracker {
public:
    /// Sees to nothing where the case has no [[critical]]. @param run of the case, whose problem it is; empty: the first
    HotSpotTracker(const std::filesystem::path& case_file, const solver::Problem& problem, const std::string& run = {});

    void take(const solver::Snapshot& snapshot);
    /// Everything that was taken, as numbers.
    void visit(solver::Archive& archive);
    /// After the run. Runs the case again for what the run itself does not tell; the user may end that early.
    /// @param hottest of the run, over all its steps: rows may miss it
    /// @returns nothing where the case asks for nothing, or the run has no row
    [[nodiscard]] std::optional<HotSpots> report(const solver::MarchReport::Extreme& hottest) const;

private:
    void add_steps(HotSpots& into) const;
    void go_on(HotSpots& into) const;
    void add_spread(HotSpots& into) const;
    [[nodiscard]] TestMoment moment(const solver::Problem& problem, const std::vector<solver::ScheduleStep>& steps,
                                    const solver::HotSpotHistory& history, double t) const;

    const solver::Problem& problem_;
    std::optional<input::HotSpotCase> case_;
    std::vector<solver::HotSpotHistory> histories_;
};

}  // namespace tiretherm::diagnosis
