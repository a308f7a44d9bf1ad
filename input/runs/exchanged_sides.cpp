// SPDX-License-Identifier: BSD-3-Clause
// Correlates differences of an axle's tires with the difference of their heats, over as many samples as are independent.

#include "input/runs/exchanged_sides.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"

namespace tiretherm::input {

namespace {

using Values = std::vector<double>;

constexpr double interval = 0.5;                             ///< s, of the samples that are compared
constexpr std::size_t longest_grid = 2000;                   ///< samples
constexpr std::array memories{2.0, 6.0, 20.0, 60.0, 200.0};  ///< s, in which a tire forgets
constexpr double rolling =
    0.012;  ///< heat of deformation over load and way: rolling resistance of a passenger car's tire
constexpr double clearly = 0.5;   ///< correlation
constexpr double repeated = 0.8;  ///< correlation with oneself a turn earlier, and with each other
constexpr std::size_t fewest_turns = 4;
constexpr double longest_delay = 10.0;  ///< s, of a logger's channel
constexpr double beyond_chance = 4.0;   ///< standard deviations of its transform by Fisher

/// An axle of a recording.
struct AxleRuns {
    const MeasuredRun* left = nullptr;
    const MeasuredRun* right = nullptr;
};

/// Times that are compared.
Values grid_of(const AxleRuns& axle) {
    const double from = std::max(axle.left->time.front(), axle.right->time.front());
    const double to = std::min(axle.left->time.back(), axle.right->time.back());
    const double step = std::max(interval, (to - from) / static_cast<double>(longest_grid));
    Values time;
    for (double t = from + step; t <= to; t += step) {
        time.push_back(t);
    }
    return time;
}

/// Means of the readings in the intervals that end at each time of the grid; NaN without any.
Values block_means(const MeasuredRun& run, const MeasuredSeries& series, const Values& grid) {
    const double step = grid[1] - grid[0];
    Values sum(grid.size(), 0.0);
    std::vector<std::size_t> count(grid.size(), 0);
    for (std::size_t i = 0; i < run.time.size(); ++i) {
        const double at = std::ceil((run.time[i] - grid.front()) / step);
        if (std::isfinite(series.value[i]) && at >= 0.0 && at < static_cast<double>(grid.size())) {
            sum[static_cast<std::size_t>(at)] += series.value[i];
            ++count[static_cast<std::size_t>(at)];
        }
    }
    for (std::size_t i = 0; i < grid.size(); ++i) {
        sum[i] = count[i] > 0 ? sum[i] / static_cast<double>(count[i]) : std::nan("");
    }
    return sum;
}

/// Readings of the left less those of the right tire, of all sensors that both have; NaN where one has none.
Values measured_difference(const AxleRuns& axle, const Values& grid) {
    Values total(grid.size(), 0.0);
    std::size_t sensors = 0;
    for (const MeasuredSeries& left : axle.left->series) {
        const std::string& name = axle.left->problem.channels[left.channel].name;
        const auto right = std::ranges::find_if(axle.right->series, [&](const MeasuredSeries& other) {
            return axle.right->problem.channels[other.channel].name == name;
        });
        const bool usable = axle.left->problem.channels[left.channel].quantity == solver::Quantity::temperature &&
                            right != axle.right->series.end() && !left.frozen && !right->frozen;
        if (!usable) {
            continue;
        }
        ++sensors;
        const Values of_left = block_means(*axle.left, left, grid);
        const Values of_right = block_means(*axle.right, *right, grid);
        for (std::size_t i = 0; i < grid.size(); ++i) {
            total[i] += of_left[i] - of_right[i];
        }
    }
    return sensors > 0 ? total : Values{};
}

/// Heat of deformation and sliding of a tire, W, as far as its inputs tell.
double heat(const physics::Inputs& at) {
    return std::abs(at.speed) * (rolling * at.vertical_load + std::abs(at.lateral_force * std::tan(at.slip_angle)) +
                                 std::abs(at.longitudinal_force * at.slip_ratio));
}

/// Heat of the left less that of the right tire.
Values heat_difference(const AxleRuns& axle, const Values& grid) {
    Values difference;
    for (const double t : grid) {
        difference.push_back(heat(axle.left->problem.input_signals.at(t, solver::JumpSide::after)) -
                             heat(axle.right->problem.input_signals.at(t, solver::JumpSide::after)));
    }
    return difference;
}

Values remembered(const Values& heat, double step, double memory) {
    Values sum(heat.size());
    const double kept = std::exp(-step / memory);
    for (std::size_t i = 0; i < heat.size(); ++i) {
        sum[i] = heat[i] + (i > 0 ? kept * sum[i - 1] : 0.0);
    }
    return sum;
}

Values without_trend(Values values) {
    const std::size_t n = values.size();
    return detrended({.value = std::move(values), .first = {0, n}}).value;
}

/// The correlation of a course with itself or another, so many samples earlier.
double correlation_after(const Values& later, const Values& earlier, std::size_t lag) {
    const auto n = static_cast<std::ptrdiff_t>(later.size() - lag);
    return correlation({earlier.begin(), earlier.begin() + n}, {later.end() - n, later.end()});
}

/// How many samples of two courses count, beside their memories (Bartlett 1935): each lag by which both go with themselves
/// takes some away.
double independent(const Values& a, const Values& b) {
    const auto n = static_cast<double>(a.size());
    double sum = 1.0;
    for (std::size_t lag = 1; lag <= a.size() / 4; ++lag) {
        const double both = correlation_after(a, a, lag) * correlation_after(b, b, lag);
        sum += 2.0 * (1.0 - static_cast<double>(lag) / n) * std::max(0.0, both);
    }
    return n / sum;
}

/// Whether both go through the same again and again, as on a skidpad or a machine. However often they do, a single turn counts for
/// few samples, but it is no chance that they go together in each of them.
bool repeat_together(const Values& a, const Values& b) {
    const std::size_t longest = a.size() / fewest_turns;
    bool has_changed = false;
    for (std::size_t lag = 1; lag <= longest; ++lag) {
        const double both = std::min(correlation_after(a, a, lag), correlation_after(b, b, lag));
        has_changed = has_changed || both < 1.0 - clearly;
        if (has_changed && both > repeated) {
            return true;
        }
    }
    return false;
}

/// Whether readings that come late would go with what is expected: of one swing nobody can tell half of it from its opposite.
bool may_be_late(const Values& measured, const Values& expected, double step, double sign) {
    const auto most = std::min(static_cast<std::size_t>(longest_delay / step), measured.size() / fewest_turns);
    for (std::size_t lag = 1; lag <= most; ++lag) {
        if (-sign * correlation_after(measured, expected, lag) > clearly) {
            return true;
        }
    }
    return false;
}

/// The correlation of an axle where it is beyond chance; 0 where it is not.
double verdict_of(const AxleRuns& axle) {
    const Values grid = axle.left->time.empty() || axle.right->time.empty() ? Values{} : grid_of(axle);
    Values measured = grid.size() < 20 ? Values{} : measured_difference(axle, grid);
    if (measured.empty()) {
        return 0.0;
    }
    measured = without_trend(std::move(measured));
    const Values driven = heat_difference(axle, grid);
    double best = 0.0;
    Values its;
    for (const double memory : memories) {
        Values expected = without_trend(remembered(driven, grid[1] - grid[0], memory));
        if (const double r = correlation(measured, expected); std::abs(r) > std::abs(best)) {
            best = r;
            its = std::move(expected);
        }
    }
    if (std::abs(best) < clearly || may_be_late(measured, its, grid[1] - grid[0], best < 0.0 ? -1.0 : 1.0)) {
        return 0.0;
    }
    if (std::abs(best) > repeated && repeat_together(measured, its)) {
        return best;
    }
    const double freedom = std::max(0.0, independent(measured, its) - 3.0);
    return std::atanh(std::min(std::abs(best), 0.9999)) * std::sqrt(freedom) > beyond_chance ? best : 0.0;
}

std::string listed_correlations(double front, double rear) {
    std::string text = front == 0.0 ? "" : fmt::format("r = {:.2f} in front", front);
    text += front != 0.0 && rear != 0.0 ? ", " : "";
    return text + (rear == 0.0 ? "" : fmt::format("{:.2f} behind", rear));
}

}  // namespace

std::string find_exchanged_sides(std::span<const MeasuredRun> corners, const TurnsKnown& turns) {
    const auto run_of = [&](std::string_view name) -> const MeasuredRun* {
        const auto found = std::ranges::find(corners, name, &MeasuredRun::corner);
        return found == corners.end() ? nullptr : &*found;
    };
    std::array<double, 2> r{};
    for (const std::size_t axle : {0U, 1U}) {
        const AxleRuns runs{.left = run_of(axle == 0 ? "FL" : "RL"), .right = run_of(axle == 0 ? "FR" : "RR")};
        r.at(axle) = runs.left != nullptr && runs.right != nullptr ? verdict_of(runs) : 0.0;
    }
    const auto [front, rear] = r;
    if (front >= 0.0 && rear >= 0.0) {
        return {};
    }
    if (front > 0.0 || rear > 0.0) {
        return fmt::format(
            "{} are probably exchanged: their measured difference goes against what their loads and slips "
            "make ({}), and that of the other axle does not: exchange their columns",
            front < 0.0 ? "FL and FR" : "RL and RR", listed_correlations(front, rear));
    }
    const std::string against = fmt::format(
        "left and right are probably exchanged: the measured differences of left and right tires go against what their "
        "loads "
        "and slips make ({})",
        listed_correlations(front, rear));
    if (!turns.by_vehicle || turns.course_agrees > 0.0) {
        return fmt::format("{}{}: are the columns of left and right tires exchanged?", against,
                           turns.by_vehicle ? ", though the car's turns are those over ground" : "");
    }
    return fmt::format(
        "{}{}. Both signs decide: turn yaw_rate_sign and lateral_acceleration_sign of [vehicle] round, or "
        "exchange the columns of left and right tires",
        against, turns.course_agrees < 0.0 ? ", and over ground the car turns the other way" : "");
}

}  // namespace tiretherm::input
