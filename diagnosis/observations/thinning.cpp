// SPDX-License-Identifier: BSD-3-Clause
// Chooses the length of a run's blocks by what the simulated temperatures lose in them, and averages the sensors and the
// columns that the model does not use.

#include "diagnosis/observations/thinning.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/order_statistics.hpp"
#include "solver/sensitivity/prediction.hpp"

namespace tiretherm::diagnosis {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
/// Of a sample interval: a clock may round.
constexpr double round_off = 1e-3;

double median_interval(const std::vector<double>& time) {
    std::vector<double> intervals;
    for (std::size_t i = 1; i < time.size(); ++i) {
        intervals.push_back(time[i] - time[i - 1]);
    }
    return solver::median(std::move(intervals));
}

/// Rows of a run's log in which a sensor has a value.
std::vector<std::size_t> rows_of(const input::MeasuredSeries& series) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < series.value.size(); ++i) {
        if (!std::isnan(series.value[i])) {
            rows.push_back(i);
        }
    }
    return rows;
}

/// Rows from one value of a sensor to the next, the median.
std::size_t stride_of(const std::vector<std::size_t>& rows) {
    std::vector<double> strides{1.0};
    for (std::size_t i = 1; i < rows.size(); ++i) {
        strides.push_back(static_cast<double>(rows[i] - rows[i - 1]));
    }
    return static_cast<std::size_t>(solver::median(std::move(strides)));
}

/// The rows of a run in blocks of equal length.
struct Blocks {
    std::vector<std::size_t> first;  ///< [n_blocks + 1] row; the last is behind all
    std::vector<double> time;        ///< [n_blocks] s, mean of the block's rows

    [[nodiscard]] std::size_t count() const { return time.size(); }
};

Blocks blocks_of(const std::vector<double>& time, std::size_t samples, double interval) {
    const double length = static_cast<double>(samples) * interval;
    const auto number = [&](std::size_t row) {
        return std::floor((time[row] - time.front() + round_off * interval) / length);
    };
    Blocks blocks;
    for (std::size_t row = 0; row < time.size();) {
        blocks.first.push_back(row);
        double sum = 0.0;
        const double now = number(row);
        while (row < time.size() && number(row) == now) {
            sum += time[row++];
        }
        blocks.time.push_back(sum / static_cast<double>(row - blocks.first.back()));
    }
    blocks.first.push_back(time.size());
    return blocks;
}

/// Mean of the values that are there, from one row to before another; NaN of fewer than `least`.
template <typename Value>
double mean_of(std::size_t from, std::size_t to, std::size_t least, Value&& value) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t row = from; row < to; ++row) {
        if (const double one = value(row); !std::isnan(one)) {
            sum += one;
            ++count;
        }
    }
    return count > 0 && count >= least ? sum / static_cast<double>(count) : missing;
}

/// Sum over blocks of (change over the block)^2 per sample: what block means keep of sum T'^2.
double timing(const solver::Prediction& simulated, std::size_t channel, std::size_t samples) {
    double sum = 0.0;
    for (std::size_t row = 0; row + samples < simulated.n_times; row += samples) {
        const double change = simulated.at(row + samples, channel) - simulated.at(row, channel);
        sum += change * change / static_cast<double>(samples);
    }
    return sum;
}

/// Samples in a block. @param simulated at the run's times, or a failure
std::size_t block_length(const input::MeasuredRun& run, double interval, const solver::Prediction& simulated) {
    std::size_t most = 0;
    for (const input::MeasuredSeries& series : run.series) {
        most = std::max(most, rows_of(series).size());
    }
    const auto wanted = static_cast<std::size_t>(std::lround(static_cast<double>(most) / most_values));
    const auto short_enough =
        std::max(std::size_t{1}, static_cast<std::size_t>(always_short_enough / interval + round_off));
    std::size_t samples = std::max(std::size_t{1}, wanted);
    if (samples <= short_enough || run.time.back() - run.time.front() <= long_run || !simulated.status.ok()) {
        return std::min(samples, short_enough);
    }
    const auto loses_timing = [&](const input::MeasuredSeries& series) {
        return timing(simulated, series.channel, samples) <
               least_timing * timing(simulated, series.channel, short_enough);
    };
    while (samples > short_enough && std::ranges::any_of(run.series, loses_timing)) {
        samples = std::max(short_enough, 3 * samples / 4);
    }
    return samples;
}

/// Blocks and the times of sensors that stay as they are, ascending.
std::vector<double> times_of(const Blocks& blocks, const input::MeasuredRun& run, const std::vector<bool>& row_stays) {
    std::vector<double> times = blocks.time;
    for (std::size_t row = 0; row < run.time.size(); ++row) {
        if (row_stays[row]) {
            times.push_back(run.time[row]);
        }
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

void thin(input::MeasuredRun& run, std::size_t samples, double interval, const solver::Prediction& simulated) {
    const Blocks blocks = blocks_of(run.time, samples, interval);
    std::vector<bool> row_stays(run.time.size(), false);
    std::vector<std::size_t> strides;
    for (const input::MeasuredSeries& series : run.series) {
        const std::vector<std::size_t> rows = rows_of(series);
        strides.push_back(stride_of(rows));
        for (std::size_t i = 0; samples < 2 * strides.back() && i < rows.size(); ++i) {
            row_stays[rows[i]] = true;
        }
    }
    const std::vector<double> times = times_of(blocks, run, row_stays);
    const auto index = [&](double t) {
        return static_cast<std::size_t>(std::ranges::lower_bound(times, t) - times.begin());
    };
    // What the model says at the middle of each block; nothing where it cannot be run: the diagnosis will say so.
    solver::Prediction middle;
    if (simulated.status.ok()) {
        middle = solver::predict(run.problem, {.times = blocks.time, .step_ends = simulated.step_ends});
    }
    const bool has_model = simulated.status.ok() && middle.status.ok();
    for (std::size_t s = 0; s < run.series.size(); ++s) {
        input::MeasuredSeries& series = run.series[s];
        std::vector<double> value(times.size(), missing);
        if (samples < 2 * strides[s]) {
            for (const std::size_t row : rows_of(series)) {
                value[index(run.time[row])] = series.value[row];
            }
        } else {
            const std::size_t half = (samples / strides[s] + 1) / 2;
            for (std::size_t b = 0; b < blocks.count(); ++b) {
                value[index(blocks.time[b])] =
                    mean_of(blocks.first[b], blocks.first[b + 1], half, [&](std::size_t row) {
                        return series.value[row] -
                               (has_model ? simulated.at(row, series.channel) - middle.at(b, series.channel) : 0.0);
                    });
            }
        }
        series.value = std::move(value);
    }
    for (input::UnusedSignal& signal : run.unused) {
        std::vector<double> value(times.size(), missing);
        for (std::size_t row = 0; row < run.time.size(); ++row) {
            if (row_stays[row]) {
                value[index(run.time[row])] = signal.value[row];
            }
        }
        for (std::size_t b = 0; b < blocks.count(); ++b) {
            value[index(blocks.time[b])] =
                mean_of(blocks.first[b], blocks.first[b + 1], 1, [&](std::size_t row) { return signal.value[row]; });
        }
        signal.value = std::move(value);
    }
    run.time = times;
}

}  // namespace

Thinned thinned(const input::Experiment& experiment) {
    Thinned result{.experiment = experiment, .runs = {}, .remarks = {}};
    for (input::MeasuredRun& run : result.experiment.runs) {
        ThinnedRun& into = result.runs.emplace_back();
        if (run.problem.settings.steady || 2 * run.time.size() <= 3 * most_values) {
            continue;
        }
        into.interval = median_interval(run.time);
        const solver::Prediction simulated = solver::predict(run.problem, {.times = run.time});
        into.samples = block_length(run, into.interval, simulated);
        if (into.samples > 1) {
            thin(run, into.samples, into.interval, simulated);
            const double rate = 1.0 / into.interval;
            result.remarks.push_back(remark::thinned(run.name, rate, rate / static_cast<double>(into.samples),
                                                     static_cast<long>(into.samples)));
        }
    }
    return result;
}

void take_values(const Thinned& from, input::Experiment& to) {
    for (std::size_t r = 0; r < from.runs.size() && r < to.runs.size(); ++r) {
        if (from.runs[r].samples > 1) {
            to.runs[r].time = from.experiment.runs[r].time;
            to.runs[r].series = from.experiment.runs[r].series;
            to.runs[r].unused = from.experiment.runs[r].unused;
        }
    }
}

}  // namespace tiretherm::diagnosis
