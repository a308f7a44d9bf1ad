// SPDX-License-Identifier: BSD-3-Clause
// Signals that an unknown heat source may follow: inputs, products of inputs, and those columns of the log that the model
// does not use and that drive the tire: what the tire does in return is no cause.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "diagnosis/detect/candidate_sources.hpp"
#include "input/effects/user_signals.hpp"

namespace tiretherm::diagnosis {

namespace {

/// What heat may follow of the inputs, and the inputs that must be given.
struct Formula {
    std::string_view text;
    std::string_view unit;
    std::string_view signal;
    std::string_view other{};
    bool first = false;  ///< looked for even where a source costs a second
};

constexpr std::array formulas{
    Formula{"speed", "m s-1", "speed", {}, true},
    Formula{"speed^2", "m2 s-2", "speed"},
    Formula{"vertical_load", "N", "vertical_load"},
    Formula{"speed * vertical_load", "W", "speed", "vertical_load", true},
    Formula{"lateral_force", "N", "lateral_force"},
    Formula{"abs(lateral_force)", "N", "lateral_force"},
    Formula{"speed * abs(lateral_force)", "W", "speed", "lateral_force", true},
    Formula{"speed * abs(slip_angle)", "m s-1", "speed", "slip_angle"},
    Formula{"longitudinal_force", "N", "longitudinal_force"},
    Formula{"abs(longitudinal_force)", "N", "longitudinal_force"},
    Formula{"camber", "rad", "camber", {}, true},
    Formula{"inflation_pressure", "Pa", "inflation_pressure"},
    Formula{"air_temperature", "K", "air_temperature"},
    Formula{"road_temperature", "K", "road_temperature"},
    Formula{"wet", "1", "wet"},
    Formula{"laser_power", "W", "laser_power", {}, true},
};

bool is_given(const input::Experiment& experiment, std::string_view signal) {
    return signal.empty() || std::ranges::all_of(experiment.runs, [&](const input::MeasuredRun& run) {
               return run.problem.input_signals.gives(*physics::find_signal(signal));
           });
}

/// Whether it changes anywhere; keeps its largest value.
bool varies(SourceSignal& source_signal) {
    double low = source_signal.value.front().front();
    double high = low;
    for (const std::vector<double>& values : source_signal.value) {
        const auto [least, most] = std::ranges::minmax(values);
        low = std::min(low, least);
        high = std::max(high, most);
    }
    source_signal.largest = std::max(std::abs(low), std::abs(high));
    return std::isfinite(low) && std::isfinite(high) && high - low > 1e-6 * source_signal.largest;
}

/// As a table [[source]] with this formula would have it; nothing where a run lacks a signal.
std::optional<SourceSignal> source_signal(const input::Experiment& experiment, std::string_view follows,
                                          std::string_view unit) {
    SourceSignal source_signal{.follows = std::string(follows), .unit = std::string(unit), .time = {}, .value = {}};
    for (const input::MeasuredRun& run : experiment.runs) {
        try {
            solver::SignalHistory one = input::signal_history_of(follows, run);
            for (std::size_t i = one.value.size(); i-- > 0;) {  // what was not logged is bridged by its neighbours
                if (!std::isfinite(one.value[i])) {
                    one.value.erase(one.value.begin() + static_cast<std::ptrdiff_t>(i));
                    one.time.erase(one.time.begin() + static_cast<std::ptrdiff_t>(i));
                }
            }
            source_signal.time.push_back(std::move(one.time));
            source_signal.value.push_back(std::move(one.value));
        } catch (const std::invalid_argument&) {
            return std::nullopt;
        }
        if (source_signal.value.back().empty()) {
            return std::nullopt;
        }
    }
    return source_signal;
}

}  // namespace

std::vector<SourceSignal> source_signals_of(const input::Experiment& experiment, bool all) {
    std::vector<SourceSignal> signals;
    const auto add = [&](std::string_view text, std::string_view unit) {
        if (std::optional<SourceSignal> one = source_signal(experiment, text, unit);
            one && (varies(*one) || text == "1")) {
            signals.push_back(std::move(*one));
        }
    };
    add("1", "1");
    add("time", "s");
    for (const Formula& formula : formulas) {
        if ((all || formula.first) && is_given(experiment, formula.signal) && is_given(experiment, formula.other)) {
            add(formula.text, formula.unit);
        }
    }
    for (const input::UnusedSignal& signal : experiment.runs.front().unused) {
        if (signal.may_be_cause) {
            add(signal.name, input::base_unit(signal.unit));
        }
    }
    return signals;
}

}  // namespace tiretherm::diagnosis
