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

double highest_of(const Problem& problem, const physics::ActiveEffect& active, const physics::ComparedRange& range) {
    const Settings& settings = problem.settings;
    std::vector<double> times{settings.start, settings.end};
    for (const std::vector<double>* more : {&problem.input_signals.stops(), &problem.input_signals.samples()}) {
        std::ranges::copy_if(*more, std::back_inserter(times),
                             [&](double t) { return t > settings.start && t < settings.end; });
    }
    double highest = 0.0;
    for (const double t : times) {
        const auto at = [&](JumpSide side) {
            return value_of(problem, active, range, problem.input_signals.at(t, side));
        };
        const double before = at(JumpSide::before);
        const double after = at(JumpSide::after);
        highest = std::max({highest, t > settings.start ? before : after, t < settings.end ? after : before});
    }
    return highest;
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
    std::vector<BeyondCompared> found;
    for (const physics::ActiveEffect& active : problem.effects) {
        if (active.total) {  // measured, in the place of the law
            continue;
        }
        for (const physics::ComparedRange& range : active.effect->compared) {
            const double highest = highest_of(problem, active, range);
            if (highest > range.high * (1.0 + slack) || (highest > 0.0 && highest < range.low * (1.0 - slack))) {
                found.push_back({.effect = active.effect->id, .range = &range, .highest = highest});
            }
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
