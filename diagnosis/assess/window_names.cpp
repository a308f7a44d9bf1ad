// SPDX-License-Identifier: BSD-3-Clause
// Looks at the speed in the window, and at its neighbours.

#include "diagnosis/assess/window_names.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::diagnosis {

namespace {

constexpr double standing_still = 1.0;  // m/s, mean speed
constexpr double clearly_there = 2.0;   // standard deviations

/// Mean speed of a run over a window; NaN where it is not given. @returns m/s
double mean_speed(const solver::Problem& problem, double from, double to) {
    constexpr int samples = 50;
    const solver::InputSignals& inputs = problem.input_signals;
    if (!inputs.gives(*physics::find_signal("speed"))) {
        return std::nan("");
    }
    double sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        sum += std::abs(inputs.at(from + (to - from) * (i + 0.5) / samples, solver::JumpSide::after).speed);
    }
    return sum / samples;
}

}  // namespace

void name_window(const input::Experiment& experiment, Diagnosis& into) {
    if (!into.unknown || into.unknown->run.empty() || into.unknown->sensor) {
        return;
    }
    const UnknownSource& source = *into.unknown;
    double from = source.from;
    double to = source.to;
    const auto run = static_cast<std::size_t>(
        std::ranges::find(experiment.runs, source.run, &input::MeasuredRun::name) - experiment.runs.begin());
    const auto grow = [&](const MissingHeat& heat) {
        const bool is_same = heat.run == run && heat.place == source.place && heat.sigma() * source.watts > 0.0;
        if (is_same && std::abs(heat.sigma()) > clearly_there && heat.from <= to && heat.to >= from) {
            from = std::min(from, heat.from);
            to = std::max(to, heat.to);
        }
    };
    std::ranges::for_each(into.missing_heat, grow);                             // in order of time: those after it
    std::for_each(into.missing_heat.rbegin(), into.missing_heat.rend(), grow);  // and before it
    const bool is_outside = source.place == "surface" || source.place == "tread";
    const double speed = mean_speed(experiment.runs[run].problem, from, to);
    if (speed < standing_still) {
        const auto& name = source.watts > 0.0 ? remark::warmed_standing : remark::cooled_standing;
        into.remarks.push_back(name(source.run, from, to));
    } else if (speed >= standing_still && is_outside && source.watts < 0.0) {
        into.remarks.push_back(remark::rain_would_do_this(source.run, from, to));
    }
}

}  // namespace tiretherm::diagnosis
