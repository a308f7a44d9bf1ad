// SPDX-License-Identifier: BSD-3-Clause
// Looks for stretches of a log over which speed and load scatter about one value, and names what lies between them ramps.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "solver/hot_spot/schedule_steps.hpp"

namespace tiretherm::solver {

namespace {

constexpr double shortest = 120.0;       ///< s, of a step
constexpr double longest_gap = 60.0;     ///< s, that parts no step when both sides are alike
constexpr double speed_scatter = 0.015;  ///< of the largest speed
constexpr double load_scatter = 0.03;    ///< of the largest load
constexpr double least_share = 0.75;     ///< of the time that steps cover in a test

/// A signal at the times of a log, with the sums that give the mean of any stretch.
struct Sampled {
    std::vector<double> value;
    std::vector<double> sum;  ///< [samples + 1]
    double scatter = 0.0;

    [[nodiscard]] double mean(std::size_t from, std::size_t to) const {
        return (sum[to] - sum[from]) / static_cast<double>(to - from);
    }
    [[nodiscard]] bool drifts(std::size_t from, std::size_t to) const {
        const std::size_t middle = from + (to - from) / 2;
        return std::abs(mean(middle, to) - mean(from, middle)) > 0.5 * scatter;
    }
    [[nodiscard]] bool alike(double a, double b) const { return std::abs(a - b) <= 0.5 * scatter; }
};

Sampled sampled(const InputSignals& inputs, const std::vector<double>& time, double physics::Inputs::*member,
                double share) {
    const auto series =
        std::ranges::find_if(inputs.series(), [&](const Series& s) { return s.signal->member == member; });
    Sampled of;
    of.value.reserve(time.size());
    of.sum.reserve(time.size() + 1);
    of.sum.push_back(0.0);
    double largest = 0.0;
    for (const double t : time) {
        of.value.push_back(series == inputs.series().end() ? inputs.constants().*member
                                                           : series->at(t, JumpSide::after));
        of.sum.push_back(of.sum.back() + of.value.back());
        largest = std::max(largest, std::abs(of.value.back()));
    }
    of.scatter = share * largest;
    return of;
}

/// How far a stretch that begins at a sample stays about its own means. Of two samples that scatter to either side the second is
/// twice as far from the first: as long as the mean is one of few, that much is allowed.
/// @param looked_at counts the samples  @returns one behind its last sample
std::size_t end_of_stretch(const Sampled& speed, const Sampled& load, std::size_t from, std::size_t& looked_at) {
    constexpr std::size_t few = 10;
    const auto stays = [&](const Sampled& of, std::size_t to) {
        const double allowed = to - from < few ? 2.0 * of.scatter : of.scatter;
        return std::abs(of.value[to] - of.mean(from, to)) <= allowed;
    };
    std::size_t to = from + 1;
    while (to < speed.value.size() && stays(speed, to) && stays(load, to)) {
        ++to;
    }
    looked_at += to - from;
    return to;
}

/// Ramps between the steps and at the ends; numbers from 1 on.
std::vector<ScheduleStep> with_ramps(const std::vector<ScheduleStep>& found, const InputSignals& inputs, double start,
                                     double end) {
    std::vector<ScheduleStep> steps;
    const auto add_ramp = [&](double from, double to, int number, double speed, double load) {
        if (to - from > 1e-9 * (end - start)) {
            steps.push_back({.number = number,
                             .ramp = true,
                             .from = from,
                             .to = to,
                             .speed = speed,
                             .load = load,
                             .recognised = true});
        }
    };
    double at = start;
    int number = 1;
    for (ScheduleStep step : found) {
        add_ramp(at, step.from, number, step.speed, step.load);
        step.number = number++;
        at = step.to;
        steps.push_back(step);
    }
    const physics::Inputs last = inputs.at(end, JumpSide::before);
    add_ramp(at, end, number, last.speed, last.vertical_load);
    return steps;
}

}  // namespace

std::vector<ScheduleStep> recognised_steps(const InputSignals& input_signals, double start, double end,
                                           std::size_t* looked_at) {
    std::vector<double> time{start};
    std::ranges::copy_if(input_signals.samples(), std::back_inserter(time),
                         [&](double t) { return t > start && t < end; });
    time.push_back(end);
    const Sampled speed = sampled(input_signals, time, &physics::Inputs::speed, speed_scatter);
    const Sampled load = sampled(input_signals, time, &physics::Inputs::vertical_load, load_scatter);
    std::vector<ScheduleStep> found;
    double covered = 0.0;
    std::size_t looks = 0;
    std::size_t to = 0;
    const auto stands = [&](std::size_t from) {
        to = end_of_stretch(speed, load, from, looks);
        return time[to - 1] - time[from] >= shortest && !speed.drifts(from, to) && !load.drifts(from, to);
    };
    std::size_t none = 0;  // no step begins at this sample or before
    for (std::size_t from = 0; from + 1 < time.size();) {
        if (!stands(from)) {
            // By a share of what was looked at, so that all of it is looked at a few times only.
            none = from;
            from += std::max<std::size_t>(1, (to - from) / 16);
            continue;
        }
        while (from - none > 1) {
            const std::size_t middle = none + (from - none) / 2;
            (stands(middle) ? from : none) = middle;
        }
        to = end_of_stretch(speed, load, from, looks);
        const ScheduleStep step{.from = time[from],
                                .to = time[to - 1],
                                .speed = speed.mean(from, to),
                                .load = load.mean(from, to),
                                .recognised = true};
        covered += step.duration();
        if (!found.empty() && step.from - found.back().to <= longest_gap &&
            speed.alike(step.speed, found.back().speed) && load.alike(step.load, found.back().load)) {
            ScheduleStep& whole = found.back();
            const double share = step.duration() / (step.duration() + whole.duration());
            whole.speed += share * (step.speed - whole.speed);
            whole.load += share * (step.load - whole.load);
            whole.to = step.to;
        } else {
            found.push_back(step);
        }
        from = none = to;
    }
    if (looked_at != nullptr) {
        *looked_at = looks;
    }
    if (covered < least_share * (end - start) || found.size() > most_schedule_steps) {
        return {};
    }
    return with_ramps(found, input_signals, start, end);
}

InputSignals held_at_means(const InputSignals& input_signals, const ScheduleStep& step) {
    constexpr int pieces = 1000;
    InputSignals held;
    for (const physics::Signal& signal : physics::signals()) {
        if (!input_signals.gives(signal)) {
            continue;
        }
        double sum = 0.0;
        for (int i = 0; i < pieces; ++i) {
            const double t = step.from + step.duration() * (i + 0.5) / pieces;
            sum += input_signals.at(t, JumpSide::after).*signal.member;
        }
        held.add(signal, sum / pieces);
    }
    return held;
}

}  // namespace tiretherm::solver
