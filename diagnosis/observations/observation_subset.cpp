// SPDX-License-Identifier: BSD-3-Clause
// Rebuilds the blocks of the rows that are kept; what is missing between two samples is a long interval to the noise.

#include "diagnosis/observations/observation_subset.hpp"

#include <algorithm>

namespace tiretherm::diagnosis {

Observations subset(const Observations& observations, const RowIndices& rows) {
    Observations some;
    some.times = observations.times;
    some.recordings = observations.recordings;
    some.lap_ends = observations.lap_ends;
    some.channels = observations.channels;
    some.names = observations.names;
    some.stated = observations.stated;
    some.measured = observations.measured(rows);
    for (const Eigen::Index row : rows) {
        some.rows.push_back(observations.rows[static_cast<std::size_t>(row)]);
    }
    for (const NoiseBlock& block : observations.blocks) {
        const auto from = std::ranges::lower_bound(rows, block.first);
        const auto to = std::ranges::lower_bound(rows, block.first + block.rows());
        if (from == to) {
            continue;
        }
        NoiseBlock part{
            .channel = block.channel, .first = from - rows.begin(), .time = {}, .standard_deviation = {}, .sample = {}};
        for (auto row = from; row != to; ++row) {
            const auto i = static_cast<std::size_t>(*row - block.first);
            if (block.channel < 0) {
                part.standard_deviation.push_back(block.standard_deviation[i]);
            } else {
                part.time.push_back(block.time[i]);
                part.sample.push_back(block.sample.empty() ? i : block.sample[i]);
            }
        }
        some.blocks.push_back(std::move(part));
    }
    return some;
}

Covariance subset(const Covariance& covariance, const RowIndices& rows) {
    Covariance some{.channels = covariance.channels, .weight = {}};
    if (covariance.weight.size() > 0) {
        some.weight = covariance.weight(rows);
    }
    return some;
}

}  // namespace tiretherm::diagnosis
