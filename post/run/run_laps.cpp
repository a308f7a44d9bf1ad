// SPDX-License-Identifier: BSD-3-Clause
// Takes the laps out of the rows of a run.
#include <algorithm>
#include <iterator>

#include "post/run/run_sections.hpp"
#include "solver/channel_unit.hpp"

namespace tiretherm::post {

std::vector<LapRow> lap_rows(const RunRecord& run) {
    std::vector<LapRow> rows;
    const std::vector<double>& time = run.history.time();
    for (std::size_t c = 0; c < run.problem.channels.size() && !time.empty(); ++c) {
        const solver::Channel& channel = run.problem.channels[c];
        const std::vector<double> values = run.history.channel(c);
        const auto add = [&](std::optional<input::Lap> lap, double from, double to) {
            rows.push_back({.run = run.run,
                            .corner = run.corner,
                            .lap = lap,
                            .seconds = lap ? lap->end - lap->start : to - from,
                            .channel = channel.name,
                            .unit = solver::shown_unit(channel.quantity),
                            .simulated = diagnosis::values_between(time, values, from, to)});
        };
        for (const input::Lap& lap : run.laps) {
            if (lap.start < time.back() && lap.end > time.front()) {
                add(lap, std::max(lap.start, time.front()), std::min(lap.end, time.back()));
            }
        }
        add(std::nullopt, time.front(), time.back());
    }
    return rows;
}

diagnosis::RunHeat heat_of(const RunRecord& run) {
    diagnosis::RunHeat heat{.run = run.run, .corner = run.corner};
    if (run.history.rows() == 0) {
        return heat;
    }
    heat.start = run.history.time().front();
    heat.end = run.history.time().back();
    std::ranges::copy_if(run.laps, std::back_inserter(heat.laps),
                         [&](const input::Lap& lap) { return lap.start < heat.end && lap.end > heat.start; });
    heat.friction = diagnosis::friction_energy(run.problem);
    for (const physics::ActiveEffect& active : run.problem.effects) {
        heat.heat.names.emplace_back(active.title());
    }
    heat.heat.time = run.history.time();
    std::ranges::transform(run.history.joules(), std::back_inserter(heat.heat.joules),
                           [&](double joules) { return run.problem.symmetry * joules; });
    return heat;
}

}  // namespace tiretherm::post
