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

bool is_on(const solver::Problem& problem, std::string_view effect) {
    return std::ranges::any_of(problem.effects, [&](const auto& active) { return active.effect->id == effect; });
}

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

std::string advice_on_friction(const input::Experiment& experiment, bool is_above) {
    const std::vector<std::string> sensors = infrared_sensors(experiment);
    if (is_above) {
        return "more heat of sliding than the logged slip makes: slip may be logged too small or another heat follows "
               "it; compare slip_input_gain and partition_speed";
    }
    const bool has_lag = is_free(experiment, "sensor_lag");
    const bool has_delay = is_free(experiment, "clock_delay");
    if (sensors.empty() || (has_lag && has_delay)) {
        return "less heat of sliding than the logged slip makes: slip may be logged too large or late; compare "
               "slip_input_gain";
    }
    return fmt::format("a lag or delay of {} can do this, as it flattens what sliding makes: free {}{}{}",
                       sensors.size() == 1 ? sensors.front() : fmt::format("the {} infrared sensors", sensors.size()),
                       has_lag ? "" : "sensor_lag.tau", has_lag || has_delay ? "" : " and ",
                       has_delay ? "" : "clock_delay.delay");
}

std::string advice_on_effect(const input::Experiment& experiment, std::string_view effect, std::string_view key,
                             bool is_above) {
    const solver::Problem& problem = experiment.runs.front().problem;
    if (effect == "road_contact" && is_above && !is_on(problem, "resolved_contact") &&
        !is_on(problem, "travelling_contact")) {
        return "the averaged contact sheds less than the tread does: it wants a rolling contact, resolved_contact in "
               "the place of road_contact";
    }
    if (effect == "sliding_friction" && (key == "partition" || key.starts_with("lambda"))) {
        return advice_on_friction(experiment, is_above);
    }
    if (effect == "air_convection" && key != "exponent" && key != "floor") {
        return is_above ? "the air film compensates for a missing heat path: try "
                          "sidewall_convection, inner_gas or resolved_contact, or run diagnose"
                        : "the air film compensates for another error of the heat balance: look at road_contact "
                          "and at sources that are off, or run diagnose";
    }
    if (effect == "strain_energy_loss" && (key == "tan_delta_a" || key.starts_with("lambda"))) {
        return is_above ? "the loss compensates for a missing heat source: try cornering_loss, drum_curvature or "
                          "load_exponent_of_loss, or run diagnose"
                        : "the loss compensates for a missing heat path: try "
                          "sidewall_convection or inner_gas, or run diagnose";
    }
    return "";
}

}  // namespace

std::string advice(const input::Experiment& experiment, const FreeParameter& parameter, bool is_above,
                   const physics::PlausibleRange* range) {
    const solver::Problem& problem = experiment.runs.front().problem;
    if (parameter.kind == FreeParameter::Kind::initial) {
        return "the run began earlier than the log, or the sensors were not at the tire's temperature: start the log "
               "before the tire rolls, or state the start by the first readings";
    }
    if (parameter.kind == FreeParameter::Kind::input) {
        return "it may compensate for another value of [vehicle] or for an error of the tire model: weigh or measure "
               "it, log wheel loads or slips, or run diagnose";
    }
    if (parameter.kind == FreeParameter::Kind::effect) {
        const physics::ActiveEffect& active = problem.effects[parameter.effect];
        std::string known = advice_on_effect(experiment, active.effect->id,
                                             active.effect->parameters[parameter.parameter].key, is_above);
        if (!known.empty()) {
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
