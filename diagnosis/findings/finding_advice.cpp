// SPDX-License-Identifier: BSD-3-Clause
// The known reasons why a parameter is fitted to a value that nobody expects.
#include "diagnosis/findings/finding_advice.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "diagnosis/findings/sensor_kind.hpp"
#include "input/text/word_lists.hpp"

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

/// Of less heat of sliding than expected: a slow infrared sensor flattens what sliding makes. Nothing where that was ruled out.
std::optional<Remark> slow_sensor(const input::Experiment& experiment) {
    const std::vector<std::string> sensors = infrared_sensors(experiment);
    std::vector<std::string> to_free;
    for (const auto& [effect, number] : {std::pair("sensor_lag", "tau"), std::pair("clock_delay", "delay")}) {
        if (!is_free(experiment, effect)) {
            to_free.push_back(fmt::format("{}.{}", effect, number));
        }
    }
    if (sensors.empty() || to_free.empty()) {
        return std::nullopt;
    }
    const std::string numbers = input::listed(to_free);
    return sensors.size() == 1 ? remark::slow_sensor(sensors.front(), numbers)
                               : remark::slow_sensors(static_cast<long>(sensors.size()), numbers);
}

/// What the effect's own file says of a fit on that side of expectation.
std::optional<Remark> advice_on_effect(const input::Experiment& experiment, const FreeParameter& parameter,
                                       bool is_above) {
    const physics::Effect& effect = *experiment.runs.front().problem.effects[parameter.effect].effect;
    const physics::PlausibleRange* range = physics::plausible_range(effect, parameter.parameter);
    if (range == nullptr) {
        return std::nullopt;
    }
    if (effect.id == "sliding_friction" && !is_above) {
        if (std::optional<Remark> known = slow_sensor(experiment)) {
            return known;
        }
    }
    const std::string known(is_above ? range->advice_above : range->advice_below);
    return known.empty() ? std::nullopt : std::optional(remark::known_reason(known));
}

}  // namespace

Remark advice(const input::Experiment& experiment, const FreeParameter& parameter, bool is_above,
              const physics::PlausibleRange* range) {
    if (parameter.kind == FreeParameter::Kind::initial) {
        return remark::start_is_unlike_log();
    }
    if (parameter.kind == FreeParameter::Kind::input) {
        return remark::compensates_for_car();
    }
    if (parameter.kind == FreeParameter::Kind::effect) {
        if (std::optional<Remark> known = advice_on_effect(experiment, parameter, is_above)) {
            return *known;
        }
    }
    return range != nullptr ? remark::known_reason(std::string(range->why)) : remark::prior_is_too_narrow();
}

}  // namespace tiretherm::diagnosis
