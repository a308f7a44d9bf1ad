// SPDX-License-Identifier: BSD-3-Clause
// Tracks hot spots along a run; simulates further steps, steady states and, for the uncertain parameters, two runs
// each.

#include "diagnosis/hot_spot/hot_spot_watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "input/runs/continued_schedule.hpp"
#include "mesh/parallel.hpp"
#include "solver/stop_signal.hpp"
#include "solver/time_integration/run_to_end.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

HotSpotTracker::HotSpotTracker(const std::filesystem::path& case_file, const solver::Problem& problem,
                               const std::string& run)
    : problem_(problem), case_(input::HotSpotCase::read(case_file, run)) {
    if (case_) {
        for (const solver::Critical& critical : case_->critical) {
            histories_.emplace_back(problem.mesh, critical);
        }
    }
}

void HotSpotTracker::take(const solver::Snapshot& snapshot) {
    for (solver::HotSpotHistory& history : histories_) {
        history.take(snapshot);
    }
}

void HotSpotTracker::visit(solver::Archive& archive) { archive(histories_); }

TestMoment HotSpotTracker::moment(const solver::Problem& problem, const std::vector<solver::ScheduleStep>& steps,
                                  const solver::HotSpotHistory& history, double t) const {
    const physics::Inputs inputs = problem.input_signals.at(t, solver::JumpSide::before);
    TestMoment moment{
        .time = t, .steady = problem.settings.steady, .speed = inputs.speed, .load = inputs.vertical_load};
    if (const solver::ScheduleStep* step = solver::step_at(steps, t)) {
        moment.step = *step;
    }
    moment.temperature = solver::value_at(history.time(), history.temperature(), t);
    moment.surface = solver::value_at(history.time(), history.surface(), t);
    return moment;
}

std::optional<HotSpots> HotSpotTracker::report(const solver::MarchReport::Extreme& hottest) const {
    if (histories_.empty() || histories_.front().rows() == 0) {
        return std::nullopt;
    }
    HotSpots found;
    const solver::Settings& settings = problem_.settings;
    if (!settings.steady) {
        found.steps = solver::schedule_steps(problem_.input_signals, settings.start, settings.end);
    }
    for (const solver::HotSpotHistory& history : histories_) {
        const bool is_hottest_of_all = std::ranges::binary_search(history.critical().nodes, hottest.node);
        HotSpot spot{.history = history,
                     .hottest = moment(problem_, found.steps, history,
                                       is_hottest_of_all ? hottest.time : history.time()[history.hottest_row()]),
                     .passing = std::nullopt,
                     .surface_threshold = unknown,
                     .surface_time = unknown};
        if (is_hottest_of_all) {
            spot.hottest.temperature = hottest.temperature;
        }
        const double passed =
            solver::passing_time(history.time(), history.temperature(), history.critical().temperature);
        if (!std::isnan(passed) && !settings.steady) {
            spot.passing = moment(problem_, found.steps, history, passed);
        }
        found.spots.push_back(std::move(spot));
    }
    const bool whole = settings.steady || histories_.front().time().back() >= settings.end;
    if (!whole) {
        found.notes.push_back(remark::run_ended_early());
        return found;
    }
    add_steps(found);
    add_spread(found);
    go_on(found);
    return found;
}

void HotSpotTracker::add_steps(HotSpots& into) const {
    const auto steady = solver::steady_spots(problem_, case_->critical, into.steps);
    for (std::size_t i = 0; i < into.spots.size(); ++i) {
        HotSpot& spot = into.spots[i];
        const solver::HotSpotHistory& history = spot.history;
        for (const solver::ScheduleStep& step : into.steps) {
            spot.at_end.push_back({.hottest = solver::value_at(history.time(), history.temperature(), step.to),
                                   .surface = solver::value_at(history.time(), history.surface(), step.to)});
        }
        spot.steady = steady[i];
        spot.surface_threshold = solver::surface_threshold(spot.steady, history.critical().temperature);
        if (!std::isnan(spot.surface_threshold)) {
            spot.surface_time = solver::passing_time(history.time(), history.surface(), spot.surface_threshold);
        }
    }
}

/// One run with further steps serves all hot spots that the test itself did not bring to their critical temperatures.
void HotSpotTracker::go_on(HotSpots& into) const {
    const auto missing = [](const HotSpot& spot) { return !spot.passing; };
    if (problem_.settings.steady || into.steps.empty() || std::ranges::none_of(into.spots, missing)) {
        return;
    }
    const input::ContinuedSchedule further = input::continue_schedule(*case_, problem_.settings, into.steps);
    std::vector<solver::HotSpotHistory> histories;
    std::vector<solver::ScheduleStep> steps;
    solver::RunEnd ending;
    if (further.problem) {
        for (const solver::Critical& critical : case_->critical) {
            histories.emplace_back(further.problem->mesh, critical);
        }
        steps = solver::schedule_steps(further.problem->input_signals, further.problem->settings.start,
                                       further.problem->settings.end);
        ending = solver::run_to_end(*further.problem, [&](const solver::Snapshot& snapshot) {
            for (solver::HotSpotHistory& history : histories) {
                history.take(snapshot);
            }
        });
    }
    for (std::size_t i = 0; i < into.spots.size(); ++i) {
        HotSpot& spot = into.spots[i];
        if (spot.passing) {
            continue;
        }
        spot.further = {.refusal = further.refusal, .rise = further.rise, .duration = further.duration};
        if (!further.problem) {
            continue;
        }
        const solver::HotSpotHistory& history = histories[i];
        const double critical = history.critical().temperature;
        const double t = solver::passing_time(history.time(), history.temperature(), critical);
        spot.further->hottest = history.temperature()[history.hottest_row()];
        spot.further->last_speed = steps.back().speed;
        if (std::isnan(t)) {
            spot.further->refusal = ending.failure;
            continue;
        }
        spot.further->passing = moment(*further.problem, steps, history, t);
        if (const solver::ScheduleStep* step = solver::step_at(steps, t)) {
            const auto at = [&](double when) { return solver::value_at(history.time(), history.temperature(), when); };
            spot.further->kelvin_per_step = at(step->to) - at(step->from);
        }
    }
}

void HotSpotTracker::add_spread(HotSpots& into) const {
    if (case_->known.empty() && case_->uncertain.empty()) {
        return;
    }
    std::vector<solver::HotPlace> places;
    for (const HotSpot& spot : into.spots) {
        places.push_back({.where = spot.history.hottest_place(), .time = spot.hottest.time});
    }
    const solver::PlaceSlopes base = solver::place_slopes(problem_, places, case_->known);
    if (!base.status.ok()) {
        into.notes.push_back(remark::drivers_not_known(base.status.message));
        return;
    }
    for (const std::string& name : base.non_smooth_parameters) {
        into.notes.push_back(remark::at_kink(name));
    }
    // Two runs for each key, one standard deviation to either side; one for an alternative.
    const std::size_t n = case_->uncertain.size();
    std::vector<solver::PlaceSlopes> sides(2 * n);
    const auto to_a_side = [&](std::size_t i) {
        auto problem = case_->moved(case_->uncertain[i / 2], i % 2 == 0 ? -1.0 : 1.0);
        sides[i].status.outcome = solver::Outcome::stopped;
        if (i % 2 == 0 && !case_->uncertain[i / 2].alternative.empty()) {
            return;  // the case itself is its other side
        }
        // Places are nodes of the case's own mesh.
        if (problem && problem->mesh.n_nodes == problem_.mesh.n_nodes && !solver::stop_requested()) {
            solver::take_laws(problem_, *problem);
            sides[i] = solver::place_slopes(*problem, places, {}, base.step_ends);
        }
    };
    in_parallel(2 * n, to_a_side);
    for (std::size_t p = 0; p < places.size(); ++p) {
        std::vector<solver::Driver> drivers;
        double mean = into.spots[p].hottest.temperature;
        for (std::size_t j = 0; j < case_->known.size(); ++j) {
            const solver::FreeParameter& number = case_->known[j];
            const double slope = base.slope[j * places.size() + p];
            const double value = solver::value_of(problem_, number);
            const double expected = number.kind == solver::FreeParameter::Kind::initial ? 0.0 : number.prior;
            mean += slope * (expected - value);
            drivers.push_back({.name = number.name,
                               .unit = number.unit,
                               .value = expected,
                               .standard_deviation = number.standard_deviation,
                               .kelvin = slope * number.standard_deviation,
                               .nonlinearity = unknown});
        }
        for (std::size_t i = 0; i < n; ++i) {
            const input::UncertainKey& key = case_->uncertain[i];
            const solver::PlaceSlopes& below = sides[2 * i];
            const solver::PlaceSlopes& above = sides[2 * i + 1];
            const bool is_alternative = !key.alternative.empty();
            if (!above.status.ok() || !(below.status.ok() || is_alternative)) {
                if (p == 0) {
                    into.notes.push_back(remark::key_is_left_out(key.name()));
                }
                continue;
            }
            if (is_alternative) {
                const double half = 0.5 * (above.temperature[p] - base.temperature[p]);
                mean += half;
                drivers.push_back({.name = key.name(),
                                   .unit = {},
                                   .value = unknown,
                                   .standard_deviation = unknown,
                                   .kelvin = half,
                                   .nonlinearity = unknown});
                continue;
            }
            drivers.push_back(
                {.name = key.name(),
                 .unit = key.unit,
                 .value = key.number,
                 .standard_deviation = key.standard_deviation,
                 .kelvin = 0.5 * (above.temperature[p] - below.temperature[p]),
                 .nonlinearity = 0.5 * (above.temperature[p] + below.temperature[p]) - base.temperature[p]});
        }
        into.spots[p].spread = solver::spread_of(std::move(drivers), mean);
    }
}

}  // namespace tiretherm::diagnosis
