// SPDX-License-Identifier: BSD-3-Clause
// The known reasons why a parameter is fitted to a value that nobody expects.
#include "diagnosis/findings/finding_advice.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "diagnosis/findings/sensor_kind.hpp"

namespace tiretherm::diagnosis {

namespace {

using solver::FreeParameter;

/// Whether a number of an effect is fitted.
bool is_free(const input::Experiment& experiment, std::string_view effect) {
    const solver::Problem& problem = experiment.runs.front().problem;
    return std::ranges::any_of(experiment.parameters, [&](const FreeParameter& one) {
        return one.kind == FreeParameter::Kind::effect && problem.effects[one.effect].effect->id == effect;
    });
}

/// Infrared sensors that measured anything.
std::vector<std::string> infrared_sensors(const input::Experiment& experiment) {
    const solver::Problem& problem = experiment.runs.front().problem;
    std::vector<std::string> names;
    for (std::size_t c = 0; c < problem.n_sensors(); ++c) {
        const bool is_measured = std::ranges::any_of(experiment.runs, [&](const input::MeasuredRun& run) {
            return std::ranges::any_of(run.series,
                                       [&](const auto& series) { return series.channel == c && !series.frozen; });
        });
        if (is_measured && sensor_kind(problem, c) == physics::SensorKind::infrared) {
            names.push_back(problem.channels[c].name);
        }
    }
    return names;
}

/// Of less heat of sliding than expected: a slow infrared sensor flattens what sliding makes. Empty where that was ruled out.
std::string slow_sensor(const input::Experiment& experiment) {
    const std::vector<std::string> sensors = infrared_sensors(experiment);
    const bool has_lag = is_free(experiment, "sensor_lag");
    const bool has_delay = is_free(experiment, "clock_delay");
    if (sensors.empty() || (has_lag && has_delay)) {
        return "";
    }
    return fmt::format("a lag or delay of {} can do this, as it flattens what sliding makes: free {}{}{}",
                       sensors.size() == 1 ? sensors.front() : fmt::format("the {} infrared sensors", sensors.size()),
                       has_lag ? "" : "sensor_lag.tau", has_lag || has_delay ? "" : " and ",
                       has_delay ? "" : "clock_delay.delay");
}

/// What the effect's own file says of a fit on that side of expectation.
std::string advice_on_effect(const input::Experiment& experiment, const FreeParameter& parameter, bool is_above) {
    const physics::Effect& effect = *experiment.runs.front().problem.effects[parameter.effect].effect;
    const physics::PlausibleRange* range = physics::plausible_range(effect, parameter.parameter);
    if (range == nullptr) {
        return "";
    }
    if (effect.id == "sliding_friction" && !is_above) {
        if (std::string known = slow_sensor(experiment); !known.empty()) {
            return known;
        }
    }
    return std::string(is_above ? range->advice_above : range->advice_below);
}

}  // namespace

std::string advice(const input::Experiment& experiment, const FreeParameter& parameter, bool is_above,
                   const physics::PlausibleRange* range) {
    if (parameter.kind == FreeParameter::Kind::initial) {
        return "the run began earlier than the log, or the sensors were not at the tire's temperature: start the log "
               "before the tire rolls, or state the start by the first readings";
    }
    if (parameter.kind == FreeParameter::Kind::input) {
        return "it may compensate for another value of [vehicle] or for an error of the tire model: weigh or measure "
               "it, log wheel loads or slips, or run diagnose";
    }
    if (parameter.kind == FreeParameter::Kind::effect) {
        if (std::string known = advice_on_effect(experiment, parameter, is_above); !known.empty()) {
            return known;
        }
    }
    if (range != nullptr) {
        return std::string(range->why);
    }
    return "the prior is too narrow, or the parameter stands in for an effect that the model lacks: check where the "
           "prior comes from, then run diagnose";
}

}  // namespace tiretherm::diagnosis
