// SPDX-License-Identifier: BSD-3-Clause
// Correlates windows of one channel with the other, earlier and later.

#include "input/vehicle/clock_shift.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"
#include "input/vehicle/at_times.hpp"
#include "physics/vehicle/local_mean.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;

constexpr double grid_step = 0.5;           ///< s
constexpr std::size_t longest_log = 20000;  ///< steps; what is longer is compared at longer ones
constexpr double longest_shift = 120.0;     ///< s
constexpr double window_length = 120.0;     ///< s
constexpr double least_shift = 1.0;         ///< s; what is less comes from filters
constexpr double agree = 0.7;               ///< correlation of two channels that tell the same
constexpr double surely_agree = 0.85;       ///< likewise, of one window alone
constexpr double least_activity = 0.3;      ///< m/s2, rms in a window: what hardly moves agrees with anything
constexpr double gained = 0.3;              ///< by the shift, at least
constexpr std::size_t few_windows = 3;      ///< in a longer log one alone may agree by chance
constexpr double alike = 2.0;               ///< s between shifts that are one
constexpr double as_good = 0.02;            ///< below the best correlation: another shift is as likely
constexpr double better = 0.03;             ///< correlation by which one sign agrees better than the other

/// Two channels at even times.
struct EvenChannels {
    double start = 0.0;
    double step = grid_step;
    Values first{};
    Values second{};
};

EvenChannels at_even_times(const Values& time, const Values& first, const Values& second) {
    EvenChannels pair{.start = time.front()};
    const double length = time.back() - time.front();
    pair.step = std::max(grid_step, length / static_cast<double>(longest_log));
    Values even;
    for (double t = time.front(); t <= time.back(); t += pair.step) {
        even.push_back(t);
    }
    // Means over a step, so that what is faster is not mistaken for something else.
    pair.first = at_times({.time = time, .value = physics::local_mean(time, first, 2.0 * pair.step)}, even);
    pair.second = at_times({.time = time, .value = physics::local_mean(time, second, 2.0 * pair.step)}, even);
    return pair;
}

/// Of the samples of a window with those of the other channel `shift` steps later; 0 where these are fewer than half.
double shifted_correlation(const EvenChannels& pair, std::size_t begin, std::size_t end, std::ptrdiff_t shift) {
    const auto size = static_cast<std::ptrdiff_t>(pair.second.size());
    const std::ptrdiff_t from = std::max(static_cast<std::ptrdiff_t>(begin), -shift);
    const std::ptrdiff_t to = std::min(static_cast<std::ptrdiff_t>(end), size - shift);
    if (2 * (to - from) < static_cast<std::ptrdiff_t>(end - begin)) {
        return 0.0;
    }
    return correlation({pair.first.begin() + from, pair.first.begin() + to},
                       {pair.second.begin() + from + shift, pair.second.begin() + to + shift});
}

double deviation(const Values& values, std::size_t begin, std::size_t end) {
    double mean = 0.0;
    double squares = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
        mean += values[i] / static_cast<double>(end - begin);
    }
    for (std::size_t i = begin; i < end; ++i) {
        squares += (values[i] - mean) * (values[i] - mean) / static_cast<double>(end - begin);
    }
    return std::sqrt(squares);
}

/// Correlations of windows with the other channel, one for each shift from -120 to 120 s.
struct ShiftCorrelations {
    std::size_t begin = 0;  ///< of the first window, an index into the even times
    std::size_t end = 0;    ///< of the last
    std::size_t windows = 1;
    Values sum{};     ///< over the windows
    Values lowest{};  ///< of the windows
};

using Range = std::pair<std::size_t, std::size_t>;  ///< begin and end, indices into the even times

std::size_t count_of_windows(const EvenChannels& pair) {
    const double length = static_cast<double>(pair.first.size() - 1) * pair.step;
    return std::max<std::size_t>(1, static_cast<std::size_t>(length / window_length));
}

/// The windows in which something moves.
std::vector<Range> windows_of(const EvenChannels& pair) {
    const std::size_t windows = count_of_windows(pair);
    std::vector<Range> active;
    for (std::size_t w = 0; w < windows; ++w) {
        const Range range{w * pair.first.size() / windows, (w + 1) * pair.first.size() / windows};
        if (deviation(pair.first, range.first, range.second) >= least_activity) {
            active.push_back(range);
        }
    }
    return active;
}

std::ptrdiff_t most_steps(const EvenChannels& pair) { return static_cast<std::ptrdiff_t>(longest_shift / pair.step); }

ShiftCorrelations curve_of(const EvenChannels& pair, std::size_t begin, std::size_t end) {
    ShiftCorrelations curve{.begin = begin, .end = end};
    for (std::ptrdiff_t shift = -most_steps(pair); shift <= most_steps(pair); ++shift) {
        curve.sum.push_back(shifted_correlation(pair, begin, end, shift));
    }
    curve.lowest = curve.sum;
    return curve;
}

/// Both as one.
ShiftCorrelations joined(const ShiftCorrelations& one, const ShiftCorrelations& other) {
    ShiftCorrelations both{.begin = one.begin, .end = other.end, .windows = one.windows + other.windows};
    std::ranges::transform(one.sum, other.sum, std::back_inserter(both.sum), std::plus<>());
    std::ranges::transform(one.lowest, other.lowest, std::back_inserter(both.lowest),
                           [](double a, double b) { return std::min(a, b); });
    return both;
}

/// Whether there is a shift with which all its windows agree.
bool agrees_somewhere(const ShiftCorrelations& curve) { return std::ranges::max(curve.lowest) >= agree; }

/// The shift with which its windows agree best, and others that do nearly as well: laps that are alike leave it open.
ClockShift shift_of(const EvenChannels& pair, const ShiftCorrelations& curve) {
    const auto mean = [&](std::size_t k) { return curve.sum[k] / static_cast<double>(curve.windows); };
    const auto delay_at = [&](std::size_t k) {
        return static_cast<double>(static_cast<std::ptrdiff_t>(k) - most_steps(pair)) * pair.step;
    };
    const auto best = static_cast<std::size_t>(std::ranges::max_element(curve.sum) - curve.sum.begin());
    ClockShift shift{.from = pair.start + static_cast<double>(curve.begin) * pair.step,
                     .to = pair.start + static_cast<double>(curve.end) * pair.step,
                     .delay = delay_at(best),
                     .correlation = mean(best),
                     .together = mean(static_cast<std::size_t>(most_steps(pair))),
                     .windows = curve.windows};
    for (std::size_t k = 1; k + 1 < curve.sum.size(); ++k) {
        const bool is_top = mean(k) > mean(k - 1) && mean(k) >= mean(k + 1);
        if (is_top && mean(k) > mean(best) - as_good && std::abs(delay_at(k) - shift.delay) > alike) {
            shift.others.push_back(delay_at(k));
        }
    }
    if (best > 0 && best + 1 < curve.sum.size()) {
        // The top of a parabola through the best and its neighbours lies between two steps.
        const double bend = mean(best - 1) - 2.0 * mean(best) + mean(best + 1);
        const double lean = mean(best - 1) - mean(best + 1);
        shift.delay += bend < 0.0 ? 0.5 * pair.step * std::clamp(lean / bend, -1.0, 1.0) : 0.0;
    }
    return shift;
}

bool is_late(const ClockShift& one) {
    return one.correlation >= agree && one.correlation >= one.together + gained && std::abs(one.delay) >= least_shift;
}

/// Whether two agree better with one of them turned round, in each window without a shift or with one that is that of all. Where
/// that is as good as without, since half a lap changes the sign, their correlation as they are decides.
bool agree_turned_round(const EvenChannels& pair, double correlation_as_they_are) {
    std::vector<Values> curves;
    for (const auto& [begin, end] : windows_of(pair)) {
        curves.push_back(curve_of(pair, begin, end).sum);
    }
    const auto no_shift = static_cast<std::size_t>(most_steps(pair));
    double best_along = 0.0;
    double best_turned = 0.0;
    for (std::size_t k = 0; k <= 2 * no_shift; ++k) {
        double along = 0.0;
        double turned = 0.0;
        for (const Values& curve : curves) {
            along += std::max(curve[no_shift], curve[k]);
            turned -= std::min(curve[no_shift], curve[k]);
        }
        best_along = std::max(best_along, along);
        best_turned = std::max(best_turned, turned);
    }
    const double margin = better * static_cast<double>(curves.size());
    return std::abs(best_along - best_turned) < margin ? correlation_as_they_are < 0.0 : best_turned > best_along;
}

std::string sentence_of(const ClockShift& shift, const std::string& beside, const std::string& late) {
    const std::string remedy =
        late == "speed"
            ? fmt::format("[effects.input_delay] with speed = \"{:.3g} s\" brings the tire's speed back{}", shift.delay,
                          shift.all ? ""
                                    : "; that holds for a whole run: give this part one of its own with "
                                      "from and to")
            : "Shift one of them in the file";
    return fmt::format(
        "{}{} is {:.3g} s {} beside {} (r = {:.2f} with that shift, {:.2f} without): their clocks differ{}. {}",
        shift.all ? "" : fmt::format("from about {:.0f} s to {:.0f} s ", shift.from, shift.to), late,
        std::abs(shift.delay), shift.delay > 0.0 ? "late" : "early", beside, shift.correlation, shift.together,
        shift.others.empty()
            ? ""
            : fmt::format(", and laps that are alike leave open whether by {:.3g} s", fmt::join(shift.others, " or ")),
        remedy);
}

}  // namespace

std::vector<ClockShift> clock_shifts(const Values& time, const Values& first, const Values& second) {
    std::vector<ClockShift> found;
    if (time.size() < 2 || time.back() - time.front() < 2.0 * least_shift) {
        return found;
    }
    const EvenChannels pair = at_even_times(time, first, second);
    std::vector<ShiftCorrelations> parts;
    bool all = true;
    for (const auto& [begin, end] : windows_of(pair)) {
        if (shifted_correlation(pair, begin, end, 0) >= agree) {
            all = false;
            continue;
        }
        const ShiftCorrelations one = curve_of(pair, begin, end);
        if (!is_late(shift_of(pair, one))) {
            continue;
        }
        const bool is_near =
            !parts.empty() && static_cast<double>(begin - parts.back().end) * pair.step < window_length;
        if (const ShiftCorrelations both = is_near ? joined(parts.back(), one) : one;
            is_near && agrees_somewhere(both)) {
            parts.back() = both;
        } else {
            parts.push_back(one);
        }
    }
    for (const ShiftCorrelations& part : parts) {
        ClockShift shift = shift_of(pair, part);
        shift.all = all && parts.size() == 1;
        const bool is_chance =
            shift.windows == 1 && (count_of_windows(pair) > few_windows || shift.correlation < surely_agree);
        if (is_late(shift) && !is_chance) {
            found.push_back(std::move(shift));
        }
    }
    return found;
}

std::vector<std::string> clock_remarks(const Values& time, const Told& one, Told other, bool may_be_turned) {
    const double r = correlation(one.acceleration, other.acceleration);
    const bool is_open = std::abs(r) < surely_agree && time.size() > 1;
    const bool turned_round =
        may_be_turned &&
        (is_open ? agree_turned_round(at_even_times(time, one.acceleration, other.acceleration), r) : r < 0.0);
    if (turned_round) {
        std::ranges::transform(other.acceleration, other.acceleration.begin(), std::negate<>());
    }
    std::vector<std::string> remarks;
    for (const ClockShift& shift : clock_shifts(time, one.acceleration, other.acceleration)) {
        remarks.push_back(sentence_of(shift, one.name, other.name));
    }
    return remarks;
}

}  // namespace tiretherm::input
