// SPDX-License-Identifier: BSD-3-Clause
// Compares the highest speed, load and other quantities of a run with the ranges that effects state.

#include "solver/compared_ranges.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace tiretherm::solver {

namespace {

constexpr double slack = 1e-6;  // relative, of numbers that were converted

double value_of(const Problem& problem, const physics::ActiveEffect& active, const physics::ComparedRange& range,
                const physics::Inputs& inputs) {
    return range.value != nullptr ? range.value(active, problem.tire, inputs)
                                  : std::abs(inputs.*physics::find_signal(range.signal)->member);
}

/// Calls `take` with the inputs of a run wherever they bend or jump.
template <typename Take>
void each_moment(const Problem& problem, const Take& take) {
    const Settings& settings = problem.settings;
    const InputSignals& signals = problem.input_signals;
    const auto is_inside = [&](double t) { return t > settings.start && t < settings.end; };
    take(signals.at(settings.start, JumpSide::after));
    take(signals.at(settings.end, JumpSide::before));
    for (const double t : signals.stops()) {
        if (is_inside(t)) {
            take(signals.at(t, JumpSide::before));
            take(signals.at(t, JumpSide::after));
        }
    }
    for (const double t : signals.samples()) {  // where nothing jumps
        if (is_inside(t)) {
            take(signals.at(t, JumpSide::before));
        }
    }
}

/// In the units that engineers write.
struct Shown {
    double per_si = 1.0;
    std::string_view unit;
};
Shown shown(const physics::ComparedRange& range) {
    return range.value != nullptr            ? Shown{1.0, range.unit}
           : range.signal == "speed"         ? Shown{3.6, "km/h"}
           : range.signal == "vertical_load" ? Shown{1e-3, "kN"}
           : range.signal == "slip_angle"    ? Shown{180.0 / std::numbers::pi, "degrees"}
                                             : Shown{1.0, physics::find_signal(range.signal)->unit};
}

}  // namespace

std::string BeyondCompared::text() const {
    const Shown in = shown(*range);
    return is_above() ? fmt::format("{} up to {:.4g} {}, this test goes to {:.4g}", range->how, in.per_si * range->high,
                                    in.unit, in.per_si * highest)
                      : fmt::format("{} from {:.4g} {} on, this test stays below {:.4g}", range->how,
                                    in.per_si * range->low, in.unit, in.per_si * highest);
}

std::vector<BeyondCompared> beyond_compared(const Problem& problem) {
    struct Watched {
        const physics::ActiveEffect* active;
        BeyondCompared law;
    };
    std::vector<Watched> watched;
    for (const physics::ActiveEffect& active : problem.effects) {
        for (const physics::ComparedRange& range : active.effect->compared) {
            if (!active.total) {  // otherwise it was measured, in the place of the law
                watched.push_back({&active, {.effect = active.effect->id, .range = &range, .highest = 0.0}});
            }
        }
    }
    if (watched.empty()) {
        return {};
    }
    each_moment(problem, [&](const physics::Inputs& inputs) {
        for (auto& [active, law] : watched) {
            law.highest = std::max(law.highest, value_of(problem, *active, *law.range, inputs));
        }
    });
    std::vector<BeyondCompared> found;
    for (const auto& [active, law] : watched) {
        const physics::ComparedRange& range = *law.range;
        if (law.highest > range.high * (1.0 + slack) ||
            (law.highest > 0.0 && law.highest < range.low * (1.0 - slack))) {
            found.push_back(law);
        }
    }
    return found;
}

void Extrapolations::add(const Problem& problem) {
    for (const BeyondCompared& law : beyond_compared(problem)) {
        const auto known = std::ranges::find(laws_, law.range, &BeyondCompared::range);
        if (known != laws_.end()) {
            known->highest = std::max(known->highest, law.highest);
        } else if (law.is_above()) {
            laws_.push_back(law);
        }
    }
}

std::string Extrapolations::phrase() const {
    std::vector<std::string> parts;
    for (const BeyondCompared& law : laws_) {
        std::string name(law.effect);
        std::ranges::replace(name, '_', ' ');
        parts.push_back(fmt::format("{} {}", name, law.text()));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

std::vector<std::string> Extrapolations::headline() const {
    if (laws_.empty()) {
        return {};
    }
    return {fmt::format("Laws beyond what is known of them: {}.", phrase())};
}

std::vector<std::string> Extrapolations::warnings() const {
    std::vector<std::string> sentences;
    for (const BeyondCompared& law : laws_) {
        sentences.push_back(fmt::format("{} was {}: beyond, its law is an extrapolation", law.effect, law.text()));
    }
    return sentences;
}

}  // namespace tiretherm::solver
