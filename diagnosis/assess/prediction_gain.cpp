// SPDX-License-Identifier: BSD-3-Clause
// Sums squared errors block by block and channel by channel, and draws the blocks again and again.

#include "diagnosis/assess/prediction_gain.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <utility>

#include "diagnosis/fit/block_deviations.hpp"
#include "diagnosis/noise/white_equivalent.hpp"

namespace tiretherm::diagnosis {

namespace {

/// Squared errors of one channel over one block of time.
struct Sums {
    double before = 0.0;
    double after = 0.0;
    double count = 0.0;

    [[nodiscard]] double rms_before() const { return count > 0.0 ? std::sqrt(before / count) : 0.0; }
    [[nodiscard]] double rms_after() const { return count > 0.0 ? std::sqrt(after / count) : 0.0; }
};

/// [n_blocks][n_noises]; blocks of all recordings, one after another.
using BlockSums = std::vector<std::vector<Sums>>;

BlockSums sums_of(const HeldOutErrors& before, const HeldOutErrors& after, const Observations& observations,
                  const std::vector<Noise>& noise, const std::vector<std::size_t>& first_block, double length) {
    BlockSums blocks(first_block.back(), std::vector<Sums>(noise.size()));
    const std::vector<int> noise_of = noise_of_rows(observations);
    for (std::size_t row = 0; row < noise_of.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        if (noise_of[row] < 0 || !std::isfinite(before.left[i]) || !std::isfinite(after.left[i])) {
            continue;
        }
        const Observations::Row& what = observations.rows[row];
        const std::size_t recording = observations.recordings[what.run];
        const double since = observations.times[what.run][what.time] - observations.span_of(recording).first;
        const auto within = static_cast<std::size_t>(since / length);
        const std::size_t block = std::min(first_block[recording] + within, first_block[recording + 1] - 1);
        Sums& sums = blocks[block][static_cast<std::size_t>(noise_of[row])];
        sums.before += before.left[i] * before.left[i];
        sums.after += after.left[i] * after.left[i];
        sums.count += 1.0;
    }
    return blocks;
}

/// Sums over some of the blocks. @param pick the block at each place
template <typename Pick>
std::vector<Sums> total(const BlockSums& blocks, std::size_t n, const Pick& pick) {
    std::vector<Sums> all(blocks.empty() ? 0 : blocks.front().size());
    for (std::size_t b = 0; b < n; ++b) {
        const std::vector<Sums>& one = blocks[pick(b)];
        for (std::size_t c = 0; c < all.size(); ++c) {
            all[c].before += one[c].before;
            all[c].after += one[c].after;
            all[c].count += one[c].count;
        }
    }
    return all;
}

double removed_share(const std::vector<Sums>& channels) {
    double sum = 0.0;
    double counted = 0.0;
    for (const Sums& channel : channels) {
        if (channel.before > 0.0) {
            sum += 1.0 - channel.after / channel.before;
            counted += 1.0;
        }
    }
    return counted > 0.0 ? sum / counted : 0.0;
}

}  // namespace

std::optional<double> share_explained(double before, double after, double noise) {
    const double error = before * before - noise * noise;
    return noise > 0.0 && error > noise * noise ? std::optional((before * before - after * after) / error)
                                                : std::nullopt;
}

PredictionGain compare_predictions(const HeldOutErrors& before, const HeldOutErrors& after,
                                   const Observations& observations, const std::vector<Noise>& noise,
                                   const std::vector<double>& floor) {
    PredictionGain gain;
    constexpr int fewest_blocks = 12;
    const double length = length_of_blocks(observations, noise, fewest_blocks);
    std::vector<std::size_t> first_block{0};
    for (std::size_t recording = 0; recording < observations.n_recordings(); ++recording) {
        const auto [from, to] = observations.span_of(recording);
        first_block.push_back(first_block.back() +
                              std::max<std::size_t>(1, static_cast<std::size_t>(std::round((to - from) / length))));
    }
    const BlockSums blocks = sums_of(before, after, observations, noise, first_block, length);
    const std::vector<Sums> all = total(blocks, blocks.size(), [](std::size_t b) { return b; });
    gain.removed = removed_share(all);

    std::mt19937_64 engine(1989);
    std::vector<double> drawn;
    std::vector<std::vector<double>> falls(all.size());
    for (int draw = 0; draw < 1000; ++draw) {
        const std::vector<Sums> sums = total(blocks, blocks.size(), [&](std::size_t /*b*/) {
            return static_cast<std::size_t>(engine() % blocks.size());
        });
        drawn.push_back(removed_share(sums));
        for (std::size_t c = 0; c < all.size(); ++c) {
            falls[c].push_back(sums[c].rms_before() - sums[c].rms_after());
        }
    }
    // A dozen blocks know their own scatter no better than Student's t of as many says.
    const auto n = static_cast<double>(blocks.size());
    const double wider =
        student(static_cast<int>(blocks.size()) - 1) / 1.959964 * std::sqrt(n / std::max(1.0, n - 1.0));
    const auto interval = [&](double value, std::vector<double>& of_draws) {
        std::ranges::sort(of_draws);
        return std::pair{value - wider * (value - of_draws[25]), value + wider * (of_draws[974] - value)};
    };
    std::tie(gain.low, gain.high) = interval(gain.removed, drawn);
    for (std::size_t c = 0; c < all.size(); ++c) {
        PredictionGain::Fall fall{.before = all[c].rms_before(), .after = all[c].rms_after()};
        std::tie(fall.low, fall.high) = interval(fall.before - fall.after, falls[c]);
        gain.channels.push_back(fall);
    }

    const Covariance independent = white_equivalent({.channels = noise, .weight = {}}, observations.blocks);
    double removable = 0.0;
    double counted = 0.0;
    gain.worst = 0.0;
    for (std::size_t c = 0; c < all.size(); ++c) {
        if (!(all[c].before > 0.0)) {
            continue;
        }
        const double ratio = all[c].after / all[c].before;
        gain.worst = std::max(gain.worst, std::sqrt(ratio));
        gain.least_explained =
            std::min(gain.least_explained,
                     share_explained(all[c].rms_before(), all[c].rms_after(), floor[c]).value_or(gain.least_explained));
        removable += std::max(0.0, 1.0 - floor[c] * floor[c] * all[c].count / all[c].before);
        counted += 1.0;
        const double inflation = std::pow(independent.channels[c].sigma / noise[c].sigma, 2);
        gain.log_odds -= 0.5 * all[c].count / inflation * std::log(std::max(ratio, 1e-12));
    }
    gain.removable = counted > 0.0 ? removable / counted : 0.0;

    constexpr double by_chance = 0.02;
    gain.in_every_fold = true;
    const std::vector<int> noise_of = noise_of_rows(observations);
    for (const Fold& fold : folds_of(observations)) {
        std::vector<Sums> channels(noise.size());
        for (const Eigen::Index i : fold.test) {
            if (std::isfinite(before.left[i]) && std::isfinite(after.left[i])) {
                Sums& sums = channels[static_cast<std::size_t>(noise_of[static_cast<std::size_t>(i)])];
                sums.before += before.left[i] * before.left[i];
                sums.after += after.left[i] * after.left[i];
            }
        }
        gain.in_every_fold = gain.in_every_fold && removed_share(channels) > -by_chance;
    }
    return gain;
}

}  // namespace tiretherm::diagnosis
