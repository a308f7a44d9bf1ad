// SPDX-License-Identifier: BSD-3-Clause
// One column for each input that the model of any run gives; the moments are those of its series.

#include "post/laps/computed_inputs.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "post/page/input_panels.hpp"
#include "post/report/csv.hpp"

namespace tiretherm::post {

namespace {

bool computes(const solver::Problem& problem, const physics::Signal* signal) {
    return problem.input_model != nullptr && std::ranges::count(problem.input_model->signals(), signal) > 0;
}

}  // namespace

std::string computed_inputs_csv(const std::vector<DrivenRun>& runs) {
    std::vector<const physics::Signal*> columns;
    std::vector<std::string> headings{"time [s]", "run"};
    for (const physics::Signal& signal : physics::signals()) {
        if (std::ranges::any_of(runs, [&](const DrivenRun& run) { return computes(*run.problem, &signal); })) {
            const std::string_view unit = shown_unit(signal).name;
            columns.push_back(&signal);
            headings.push_back(fmt::format("{} [{}]", signal.name, unit.empty() ? "1" : unit));
        }
    }
    if (columns.empty()) {
        return {};
    }
    Csv csv(headings);
    for (const DrivenRun& run : runs) {
        const solver::Problem& problem = *run.problem;
        const auto clock = std::ranges::find_if(problem.input_signals.series(), [&](const solver::Series& series) {
            return computes(problem, series.signal);
        });
        if (clock == problem.input_signals.series().end()) {
            continue;
        }
        for (const double t : clock->time) {
            if (t < problem.settings.start || t > problem.settings.end) {
                continue;
            }
            const physics::Inputs inputs = problem.input_signals.at(t, solver::JumpSide::before);
            csv.add(Digits{t, 10});
            csv.add(run.name);
            for (const physics::Signal* signal : columns) {
                const double value = shown_unit(*signal).value(inputs.*signal->member);
                csv.add(Digits{computes(problem, signal) ? value : std::numeric_limits<double>::quiet_NaN(), 7});
            }
            csv.end_row();
        }
    }
    return csv.text();
}

}  // namespace tiretherm::post
