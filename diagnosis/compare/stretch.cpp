// SPDX-License-Identifier: BSD-3-Clause
// Takes means, maxima and energies out of courses; integrates the friction power over the inputs of a run.

#include "diagnosis/compare/stretch.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "physics/bracket.hpp"
#include "physics/contact/heat_of_sliding.hpp"

namespace tiretherm::diagnosis {

namespace {

/// On the straight line between the points about a time. @param stride, offset of the values of this curve
double value_at(std::span<const double> time, std::span<const double> value, std::size_t stride, std::size_t offset,
                double t) {
    return physics::bracket(time, t).between([&](std::size_t i) { return value[i * stride + offset]; });
}

/// Times between which the inputs of a run are straight lines. @returns s, ascending
std::vector<double> corner_times(const solver::Problem& problem) {
    const double start = problem.settings.start;
    const double end = problem.settings.end;
    std::vector<double> times{start};
    const auto add = [&](const std::vector<double>& more) {
        std::ranges::copy_if(more, std::back_inserter(times), [&](double t) { return t > start && t < end; });
    };
    add(problem.input_signals.samples());
    add(problem.input_signals.stops());
    times.push_back(end);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

}  // namespace

StretchValues values_of(std::span<const double> samples) {
    if (samples.empty()) {
        return {};
    }
    return {.mean = std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size()),
            .highest = *std::ranges::max_element(samples),
            .end = samples.back()};
}

StretchValues values_between(std::span<const double> time, std::span<const double> value, double from, double to) {
    const double first = value_at(time, value, 1, 0, from);
    StretchValues found{.mean = first, .highest = first, .end = value_at(time, value, 1, 0, to)};
    double area = 0.0;
    double before = from;
    double level = first;
    const auto go_to = [&](double t, double v) {
        area += 0.5 * (level + v) * (t - before);
        found.highest = std::max(found.highest, v);
        before = t;
        level = v;
    };
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] > from && time[i] < to) {
            go_to(time[i], value[i]);
        }
    }
    go_to(to, found.end);
    if (to > from) {
        found.mean = area / (to - from);
    }
    return found;
}

double EnergyCourse::between(std::size_t name, double from, double to) const {
    return value_at(time, joules, names.size(), name, to) - value_at(time, joules, names.size(), name, from);
}

EnergyCourse friction_energy(const solver::Problem& problem) {
    const auto sliding = std::ranges::find_if(
        problem.effects, [](const auto& active) { return active.effect->id == "sliding_friction"; });
    if (sliding == problem.effects.end() || (sliding->field && !sliding->field->watts.empty()) ||
        problem.settings.steady) {
        return {};
    }
    const auto power_at = [&](double t, solver::JumpSide side) {
        physics::Inputs inputs = problem.input_signals.at(t, side);
        for (const physics::ActiveEffect& active : problem.effects) {
            const physics::InputCorrection* correction = active.effect->input_correction();
            if (correction != nullptr && correction->transform != nullptr) {
                correction->transform(active, inputs);
            }
        }
        return physics::friction_power(*sliding, problem.tire, inputs);
    };
    EnergyCourse course{.names = {"along", "across"}, .time = corner_times(problem), .joules = {0.0, 0.0}};
    physics::FrictionPower first;
    for (std::size_t i = 1; i < course.time.size(); ++i) {
        const double from = course.time[i - 1];
        const double to = course.time[i];
        if (i == 1 || std::ranges::binary_search(problem.input_signals.stops(), from)) {  // the inputs may jump
            first = power_at(from, solver::JumpSide::after);
        }
        const physics::FrictionPower middle = power_at(0.5 * (from + to), solver::JumpSide::after);
        const physics::FrictionPower last = power_at(to, solver::JumpSide::before);
        const auto simpson = [&](double a, double b, double c) { return (to - from) / 6.0 * (a + 4.0 * b + c); };
        const std::size_t before = course.joules.size() - 2;
        course.joules.push_back(course.joules[before] + simpson(first.along, middle.along, last.along));
        course.joules.push_back(course.joules[before + 1] + simpson(first.across, middle.across, last.across));
        first = last;
    }
    return course;
}

}  // namespace tiretherm::diagnosis
