// SPDX-License-Identifier: BSD-3-Clause
// Data check: sensors whose samples were brought to a higher rate, by holding values, by straight lines, or by a smooth
// interpolation that leaves the upper part of the spectrum empty.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <fmt/format.h>

#include "input/measurements/data_warnings.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t least_knots = 20;
constexpr std::size_t largest_ratio = 100;
constexpr double uneven = 0.01;                 ///< of the interval; a clock may round
constexpr double on_grid = 0.98;                ///< of the changes of what is held lie on one grid
constexpr double least_share_of_changes = 0.3;  ///< of the grid's samples: a coarse sensor that rests changes at fewer
constexpr double of_the_knots = 0.85;           ///< of the squares of the second differences is at the knots
constexpr double lie_straight = 0.95;           ///< of the intervals between them
constexpr double bent = 3.0;                    ///< times what is between them, of most knots
constexpr double most_knots = 0.6;              ///< of all that are bent
constexpr double rounding = 1.25;     ///< steps of the logger: off a straight line where it and its ends are rounded
constexpr std::size_t segment = 256;  ///< samples of a spectrum
constexpr std::size_t least_segments = 8;
constexpr std::size_t most_segments = 200;
constexpr std::size_t largest_smooth_ratio = 16;
constexpr double empty = 1e-3;    ///< of the density below the edge
constexpr double flat = 4.0;      ///< between two bands below the edge: noise, and no signal that fades
constexpr double at_edge = 0.25;  ///< of the density below; an interpolating spline has this at the edge

bool is_even(const std::vector<double>& time) {
    const double usual = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
    for (std::size_t i = 1; i < time.size(); ++i) {
        if (std::abs(time[i] - time[i - 1] - usual) > uneven * usual) {
            return false;
        }
    }
    return true;
}

/// Of the weights of all samples, the share that lies on the best grid of a ratio, and where that grid begins.
struct Grid {
    double share = 0.0;
    std::size_t first = 0;
};
/// @param all the sum of the weights  @param least share; a ratio is given up as soon as too much lies off its grids
Grid best_grid(const std::vector<double>& weight, double all, std::size_t ratio, double least) {
    constexpr std::size_t turns = 64;  // between two looks at what lies off
    std::vector<double> sums(ratio, 0.0);
    double seen = 0.0;
    for (std::size_t begin = 0; begin < weight.size() && all > 0.0; begin += ratio) {
        const std::size_t n = std::min(ratio, weight.size() - begin);
        for (std::size_t i = 0; i < n; ++i) {
            sums[i] += weight[begin + i];
            seen += weight[begin + i];
        }
        if (begin % (turns * ratio) == 0 && seen - std::ranges::max(sums) > 1.001 * (1.0 - least) * all) {
            return {};
        }
    }
    const auto most = std::ranges::max_element(sums);
    return {all > 0.0 ? *most / all : 0.0, static_cast<std::size_t>(most - sums.begin())};
}

std::size_t most_ratio(std::size_t n) { return std::min(largest_ratio, n / least_knots); }

/// Each value stands for so many samples; a coarse sensor stands on its steps for all sorts of times.
Resampling held_resampling(const RecordedColumn& column) {
    const std::vector<double>& value = column.value;
    std::vector<double> changed(value.size(), 0.0);
    std::size_t changes = 0;
    for (std::size_t i = 1; i < value.size(); ++i) {
        changed[i] = value[i] != value[i - 1] ? 1.0 : 0.0;
        changes += value[i] != value[i - 1] ? 1 : 0;
    }
    for (std::size_t ratio = most_ratio(value.size()); ratio > 1; --ratio) {
        const Grid grid = best_grid(changed, static_cast<double>(changes), ratio, on_grid);
        const double of_grid =
            static_cast<double>(changes) * static_cast<double>(ratio) / static_cast<double>(value.size());
        if (changes >= least_knots && grid.share > on_grid && of_grid > least_share_of_changes) {
            return {Resampling::How::held, ratio, grid.first};
        }
    }
    return {};
}

/// What the numbers are rounded to: all steps are multiples of the smallest; 0 where they are not.
double quantum_of(const RecordedColumn& column) {
    const double smallest = column.resolution();
    std::size_t broken = 0;
    for (std::size_t i = 1; i < column.value.size() && smallest > 0.0; ++i) {
        const double steps = (column.value[i] - column.value[i - 1]) / smallest;
        broken += std::abs(steps - std::round(steps)) > 0.05 ? 1 : 0;
    }
    return 100 * broken > column.value.size() ? 0.0 : smallest;
}

/// The share of the intervals between knots in which all samples lie on the straight line, but for rounding.
double straight_intervals(const std::vector<double>& value, const Resampling& knots, double slack) {
    std::size_t straight = 0;
    std::size_t intervals = 0;
    for (std::size_t begin = knots.first; begin + knots.ratio < value.size(); begin += knots.ratio) {
        const double rise = (value[begin + knots.ratio] - value[begin]) / static_cast<double>(knots.ratio);
        double off = 0.0;
        for (std::size_t i = 1; i < knots.ratio; ++i) {
            off = std::max(off, std::abs(value[begin + i] - value[begin] - static_cast<double>(i) * rise));
        }
        ++intervals;
        straight += off <= slack ? 1 : 0;
    }
    return static_cast<double>(straight) / static_cast<double>(std::max<std::size_t>(1, intervals));
}

/// Second differences are no more than rounding but at the knots of a grid.
Resampling linear_resampling(const RecordedColumn& column) {
    const std::vector<double>& value = column.value;
    std::vector<double> square(value.size(), 0.0);
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        const double bend = value[i - 1] - 2.0 * value[i] + value[i + 1];
        square[i] = bend * bend;
    }
    const double all = std::accumulate(square.begin(), square.end(), 0.0);
    const double slack = std::max(rounding * quantum_of(column), 1e-6 * (column.high() - column.low()));
    for (std::size_t ratio = most_ratio(value.size()); ratio > 1; --ratio) {
        const Grid grid = best_grid(square, all, ratio, of_the_knots);
        if (grid.share < of_the_knots) {
            continue;
        }
        double between = 0.0;
        std::size_t others = 0;
        std::vector<double> knots;
        for (std::size_t i = 1; i + 1 < value.size(); ++i) {
            if (i % ratio == grid.first) {
                knots.push_back(std::sqrt(square[i]));
            } else {
                between += square[i];
                ++others;
            }
        }
        const double rms = std::sqrt(between / static_cast<double>(others));
        const auto bends = std::ranges::count_if(knots, [&](double knot) { return knot > bent * rms; });
        const Resampling found{Resampling::How::linear, ratio, grid.first};
        if (knots.size() >= least_knots &&
            static_cast<double>(bends) > most_knots * static_cast<double>(knots.size()) &&
            straight_intervals(value, found, slack) > lie_straight) {
            return found;
        }
    }
    return {};
}

/// Spectral density at frequencies 1 ... segment / 2 of a segment, the mean over segments that overlap by half. Each one's
/// trend is taken away and a Hann window put over it.
std::vector<double> spectrum(const std::vector<double>& value) {
    std::vector<double> density(segment / 2 + 1, 0.0);
    std::vector<double> cosine(segment);
    for (std::size_t i = 0; i < segment; ++i) {
        cosine[i] = std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(segment));
    }
    const std::size_t available = 2 * (value.size() / segment) - 1;
    const std::size_t taken = std::min(available, most_segments);
    std::vector<double> piece(segment);
    for (std::size_t s = 0; s < taken; ++s) {
        const std::size_t begin = s * available / taken * (segment / 2);
        const double half = 0.5 * static_cast<double>(segment - 1);
        double mean = 0.0;
        double slope = 0.0;
        double xx = 0.0;
        for (std::size_t i = 0; i < segment; ++i) {
            const double x = static_cast<double>(i) - half;
            mean += value[begin + i] / static_cast<double>(segment);
            slope += x * value[begin + i];
            xx += x * x;
        }
        for (std::size_t i = 0; i < segment; ++i) {
            const double x = static_cast<double>(i) - half;
            piece[i] = (value[begin + i] - mean - slope / xx * x) * 0.5 * (1.0 - cosine[i]);
        }
        for (std::size_t f = 1; f <= segment / 2; ++f) {
            double re = 0.0;
            double im = 0.0;
            for (std::size_t i = 0; i < segment; ++i) {
                re += piece[i] * cosine[f * i % segment];
                im += piece[i] * cosine[(f * i + segment / 4) % segment];
            }
            density[f] += (re * re + im * im) / static_cast<double>(taken);
        }
    }
    return density;
}

/// The density of a share of the spectrum, up to Nyquist's frequency: its median below an edge, its mean above.
double band(const std::vector<double>& density, double from, double to, bool median) {
    const double top = static_cast<double>(segment / 2);
    std::vector<double> inside;
    for (auto f = static_cast<std::size_t>(std::ceil(from * top)); f <= static_cast<std::size_t>(to * top); ++f) {
        inside.push_back(density[std::max<std::size_t>(1, f)]);
    }
    if (inside.empty()) {
        return 0.0;
    }
    if (!median) {
        return std::accumulate(inside.begin(), inside.end(), 0.0) / static_cast<double>(inside.size());
    }
    return solver::median(std::move(inside));
}

/// Noise up to an edge and nothing half as high again: an interpolation has filled in what no logger has seen.
Resampling smooth_resampling(const RecordedColumn& column) {
    if (column.value.size() < segment * (least_segments / 2 + 1)) {
        return {};
    }
    const std::vector<double> density = spectrum(column.value);
    for (std::size_t ratio = largest_smooth_ratio; ratio > 1; --ratio) {
        const double edge = 1.0 / static_cast<double>(ratio);
        const double below = band(density, 0.7 * edge, 0.9 * edge, true);
        const double further = band(density, 0.5 * edge, 0.7 * edge, true);
        const double above = band(density, 1.5 * edge, 1.0, false);
        if (below <= 0.0 || above > empty * below || further > flat * below || below > flat * further) {
            continue;
        }
        auto f = static_cast<std::size_t>(0.8 * edge * static_cast<double>(segment / 2));
        while (f < segment / 2 && density[f] + density[f + 1] > 2.0 * at_edge * below) {
            ++f;
        }
        const auto found =
            static_cast<std::size_t>(std::lround(static_cast<double>(segment / 2) / static_cast<double>(f)));
        return {Resampling::How::smooth, std::clamp<std::size_t>(found, 2, largest_smooth_ratio), 0};
    }
    return {};
}

Resampling find_resampling(const RecordedColumn& column) {
    const std::size_t n = column.value.size();
    if (column.is_input || n < 2 * least_knots || !is_even(column.time) ||
        std::ranges::adjacent_find(column.value, std::ranges::not_equal_to{}) == column.value.end()) {
        return {};
    }
    for (const auto look : {held_resampling, linear_resampling, smooth_resampling}) {
        if (const Resampling found = look(column); found.how != Resampling::How::none) {
            return found;
        }
    }
    return {};
}

}  // namespace

const Resampling& resampling_of(const RecordedColumn& column) {
    return column.known.resampling.get([&] { return find_resampling(column); });
}

std::string find_resampled(const Recording& recording, const RecordedColumn& column) {
    const Resampling& found = resampling_of(column);
    if (found.how == Resampling::How::none) {
        return {};
    }
    const std::string_view what = found.how == Resampling::How::held ? "repeats each value in"
                                  : found.how == Resampling::How::linear
                                      ? "goes straight from one measured value to the next over"
                                      : "is smoothly interpolated: its spectrum ends at 1 /";
    const double interval = column.time[found.ratio] - column.time[0];
    const std::string how = found.how == Resampling::How::smooth
                                ? fmt::format("{} {} of the highest frequency", what, found.ratio)
                                : fmt::format("{} {} samples", what, found.ratio);
    return fmt::format(
        "{}: a value was measured every {:.4g} s.{}", how, interval,
        recording.keep_suspicious ? "" : " Fits and diagnoses take one of these samples and leave out the rest");
}

}  // namespace tiretherm::input
