// SPDX-License-Identifier: BSD-3-Clause
// Scalar Kalman filter for exponentially correlated plus white noise: whitening, its transpose and the log determinant
// in one sweep along each block.

#include "diagnosis/noise/noise.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "solver/order_statistics.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Phi(1.345) - Phi(-1.345): the mean of min(v^2, 1.345 |v|) over a standard normal v.
const double huber_mean_square = std::erf(huber_threshold / std::sqrt(2.0));

/// A step of the filter for one row: what of the predictions' error is believed, and how the rest is scaled.
struct FilterStep {
    double keep = 0.0;  ///< prediction for the next row = keep * prediction + take * value
    double take = 0.0;
    double scale = 0.0;  ///< 1 / standard deviation of the innovation
};

/// The filter of one block: it depends on times and noise, not on values, and serves all columns.
///   P_1 = sigma_a^2,   F = P + sigma_w^2,   K = P w / F,   P_next = phi^2 P (1 - K) + sigma_a^2 (1 - phi^2)
/// @returns log |V| of the block
double filter_of(const NoiseBlock& block, const Noise& noise, const Eigen::VectorXd& weight,
                 std::vector<FilterStep>& filter) {
    const bool weighted = weight.size() > 0;
    const double total = noise.sigma * noise.sigma;
    const double white = total * noise.white_share;
    const double correlated = total - white;
    const double spread = weighted ? huber_mean_square : 1.0;
    assert(total > 0.0);
    filter.resize(block.time.size());
    double variance = correlated;
    double sum = 0.0;
    for (std::size_t i = 0; i < block.time.size(); ++i) {
        const double w = weighted ? weight[block.first + static_cast<Eigen::Index>(i)] : 1.0;
        const double innovation = variance + white;
        const double gain = variance * w / innovation;
        const bool last = i + 1 == block.time.size();
        assert(last || block.time[i + 1] > block.time[i]);
        const bool forgets = last || noise.correlation_time <= 0.0;
        const double elapsed = forgets ? 0.0 : (block.time[i + 1] - block.time[i]) / noise.correlation_time;
        const double phi = forgets ? 0.0 : std::exp(-elapsed);
        const double renewed = forgets ? 1.0 : -std::expm1(-2.0 * elapsed);  // 1 - phi^2
        filter[i] = {.keep = phi * (1.0 - gain), .take = phi * gain, .scale = std::sqrt(w / (spread * innovation))};
        sum += std::log(spread * innovation / w);
        variance = phi * phi * variance * (1.0 - gain) + correlated * renewed;
    }
    return sum;
}

/// Whether the filter of one block serves the next as well: pixels of a camera are read at the same moments.
bool shares_filter(const NoiseBlock* last, const NoiseBlock& block, const Eigen::VectorXd& weight) {
    return last != nullptr && weight.size() == 0 && last->channel == block.channel && last->time == block.time;
}

/// Runs the filter down some columns at once; side by side they hide each other's latency.
template <int columns>
void filter_columns(const std::vector<FilterStep>& filter, Eigen::Ref<Eigen::MatrixXd> rows) {
    std::array<double, columns> prediction{};
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const FilterStep& step = filter[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < columns; ++j) {
            double& p = prediction[static_cast<std::size_t>(j)];
            const double value = rows(i, j);
            rows(i, j) = (value - p) * step.scale;
            p = step.keep * p + step.take * value;
        }
    }
}

}  // namespace

double median_interval(std::span<const NoiseBlock> blocks, int channel) {
    std::vector<double> intervals;
    for (const NoiseBlock& block : blocks) {
        for (std::size_t i = 1; block.channel == channel && i < block.time.size(); ++i) {
            intervals.push_back(block.time[i] - block.time[i - 1]);
        }
    }
    return solver::median(std::move(intervals));
}

double Noise::rho_1s() const { return correlation_time > 0.0 ? std::exp(-1.0 / correlation_time) : 0.0; }

NoiseBlock series_block(int channel, Eigen::Index first, std::span<const double> time, std::span<const double> value) {
    assert(channel >= 0 && time.size() == value.size());
    NoiseBlock block{.channel = channel, .first = first, .time = {}, .standard_deviation = {}, .sample = {}};
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (!std::isnan(value[i])) {
            block.time.push_back(time[i]);
            block.sample.push_back(i);
        }
    }
    return block;
}

NoiseBlock numbers_block(Eigen::Index first, std::vector<double> standard_deviation) {
    return {
        .channel = -1, .first = first, .time = {}, .standard_deviation = std::move(standard_deviation), .sample = {}};
}

double change(const Covariance& before, const Covariance& after) {
    double most = 0.0;
    for (std::size_t c = 0; c < after.channels.size(); ++c) {
        most = std::max({most, std::abs(after.channels[c].sigma / before.channels[c].sigma - 1.0),
                         std::abs(after.channels[c].rho_1s() - before.channels[c].rho_1s())});
    }
    return most;
}

void whiten(std::span<const NoiseBlock> blocks, const Covariance& covariance, Eigen::Ref<Eigen::MatrixXd> rows) {
    std::vector<FilterStep> filter;
    const NoiseBlock* last = nullptr;
    for (const NoiseBlock& block : blocks) {
        auto mine = rows.middleRows(block.first, block.rows());
        if (block.channel < 0) {
            for (Eigen::Index i = 0; i < mine.rows(); ++i) {
                mine.row(i) /= block.standard_deviation[static_cast<std::size_t>(i)];
            }
            continue;
        }
        if (!shares_filter(last, block, covariance.weight)) {
            filter_of(block, covariance.channels[static_cast<std::size_t>(block.channel)], covariance.weight, filter);
        }
        last = &block;
        constexpr int together = 8;
        Eigen::Index j = 0;
        for (; j + together <= mine.cols(); j += together) {
            filter_columns<together>(filter, mine.middleCols(j, together));
        }
        for (; j < mine.cols(); ++j) {
            filter_columns<1>(filter, mine.middleCols(j, 1));
        }
    }
}

void whiten_transposed(std::span<const NoiseBlock> blocks, const Covariance& covariance, Eigen::MatrixXd& columns) {
    std::vector<FilterStep> filter;
    for (const NoiseBlock& block : blocks) {
        auto mine = columns.middleRows(block.first, block.rows());
        if (block.channel < 0) {
            for (Eigen::Index i = 0; i < mine.rows(); ++i) {
                mine.row(i) /= block.standard_deviation[static_cast<std::size_t>(i)];
            }
            continue;
        }
        filter_of(block, covariance.channels[static_cast<std::size_t>(block.channel)], covariance.weight, filter);
        Eigen::RowVectorXd carried = Eigen::RowVectorXd::Zero(mine.cols());
        for (Eigen::Index i = mine.rows(); i-- > 0;) {
            const FilterStep& step = filter[static_cast<std::size_t>(i)];
            const Eigen::RowVectorXd scaled = step.scale * mine.row(i);
            mine.row(i) = scaled + step.take * carried;
            carried = step.keep * carried - scaled;
        }
    }
}

double log_determinant(std::span<const NoiseBlock> blocks, const Covariance& covariance) {
    std::vector<FilterStep> filter;
    double sum = 0.0;
    double of_block = 0.0;
    const NoiseBlock* last = nullptr;
    for (const NoiseBlock& block : blocks) {
        if (block.channel >= 0) {
            if (!shares_filter(last, block, covariance.weight)) {
                of_block = filter_of(block, covariance.channels[static_cast<std::size_t>(block.channel)],
                                     covariance.weight, filter);
            }
            last = &block;
            sum += of_block;
        }
        for (const double deviation : block.standard_deviation) {
            sum += 2.0 * std::log(deviation);
        }
    }
    return sum;
}

}  // namespace tiretherm::diagnosis
