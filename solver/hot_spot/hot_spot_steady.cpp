// SPDX-License-Identifier: BSD-3-Clause
// Solves one steady state for each constant step of a test, of a log at the means of the inputs; the surface threshold is interpolated linearly between
// the two steps around the critical temperature.

#include "solver/hot_spot/hot_spot_steady.hpp"

#include <cmath>

namespace tiretherm::solver {

std::vector<std::vector<SpotAndSurface>> steady_spots(const Problem& problem, std::span<const Critical> criticals,
                                                      std::span<const ScheduleStep> steps) {
    std::vector<std::vector<SpotAndSurface>> found(criticals.size(), std::vector<SpotAndSurface>(steps.size()));
    Problem steady = problem;
    steady.settings.steady = true;
    steady.input_model = nullptr;
    for (std::size_t s = 0; s < steps.size(); ++s) {
        if (steps[s].ramp) {
            continue;
        }
        // Just inside of the step: at its end the inputs may jump.
        steady.settings.end = steps[s].to - 1e-6 * steps[s].duration();
        if (steps[s].recognised) {
            steady.input_signals = held_at_means(problem.input_signals, steps[s]);
            steady.input_signals.start_at(problem.settings.start);
        }
        std::vector<HotSpotHistory> histories;
        for (const Critical& critical : criticals) {
            histories.emplace_back(steady.mesh, critical);
        }
        const MarchReport report = run(steady, [&](const Snapshot& snapshot) {
            for (HotSpotHistory& history : histories) {
                history.take(snapshot);
            }
            return true;
        });
        for (std::size_t c = 0; report.status.ok() && c < histories.size(); ++c) {
            found[c][s] = {.hottest = histories[c].temperature().back(), .surface = histories[c].surface().back()};
        }
    }
    return found;
}

double surface_threshold(std::span<const SpotAndSurface> steady, double critical) {
    const SpotAndSurface* last = nullptr;
    for (const SpotAndSurface& now : steady) {
        if (std::isnan(now.hottest)) {
            continue;
        }
        if (last != nullptr && last->hottest < critical && now.hottest >= critical) {
            const double share = (critical - last->hottest) / (now.hottest - last->hottest);
            return (1.0 - share) * last->surface + share * now.surface;
        }
        last = &now;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tiretherm::solver
