// SPDX-License-Identifier: BSD-3-Clause
// Compares the highest speed and load of a run with the ranges that effects state.

#include "solver/compared_ranges.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace tiretherm::solver {

namespace {

constexpr double slack = 1e-6;  // relative, of numbers that were converted

double highest_of(const Problem& problem, const physics::Signal& signal) {
    const Settings& settings = problem.settings;
    std::vector<double> times{settings.start, settings.end};
    for (const std::vector<double>* more : {&problem.input_signals.stops(), &problem.input_signals.samples()}) {
        std::ranges::copy_if(*more, std::back_inserter(times),
                             [&](double t) { return t > settings.start && t < settings.end; });
    }
    double highest = 0.0;
    for (const double t : times) {
        const double before = problem.input_signals.at(t, JumpSide::before).*signal.member;
        const double after = problem.input_signals.at(t, JumpSide::after).*signal.member;
        highest = std::max({highest, t > settings.start ? before : after, t < settings.end ? after : before});
    }
    return highest;
}

/// In the units that engineers write.
struct Shown {
    double per_si = 1.0;
    std::string_view unit;
};
Shown shown(const physics::Signal& signal) {
    return signal.name == "speed"           ? Shown{3.6, "km/h"}
           : signal.name == "vertical_load" ? Shown{1e-3, "kN"}
                                            : Shown{1.0, signal.unit};
}

}  // namespace

std::string BeyondCompared::text() const {
    const Shown in = shown(*signal);
    return highest > high ? fmt::format("compared up to {:.4g} {}, this test goes to {:.4g}", in.per_si * high, in.unit,
                                        in.per_si * highest)
                          : fmt::format("compared from {:.4g} {} on, this test stays below {:.4g}", in.per_si * low,
                                        in.unit, in.per_si * highest);
}

std::vector<BeyondCompared> beyond_compared(const Problem& problem) {
    std::vector<BeyondCompared> found;
    for (const physics::ActiveEffect& active : problem.effects) {
        if (active.total) {  // measured, in the place of the law
            continue;
        }
        for (const physics::ComparedRange& range : active.effect->compared) {
            const physics::Signal* signal = physics::find_signal(range.signal);
            const double highest = highest_of(problem, *signal);
            if (highest > range.high * (1.0 + slack) || (highest > 0.0 && highest < range.low * (1.0 - slack))) {
                found.push_back({.effect = active.effect->id,
                                 .signal = signal,
                                 .low = range.low,
                                 .high = range.high,
                                 .highest = highest});
            }
        }
    }
    return found;
}

}  // namespace tiretherm::solver
