// SPDX-License-Identifier: BSD-3-Clause
// Sums the score of each block of time and puts their scatter between two inverses of the information.

#include "diagnosis/fit/block_deviations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis {

double student(int freedom) {
    constexpr std::array table{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
    if (freedom <= static_cast<int>(table.size())) {
        return table[static_cast<std::size_t>(std::max(1, freedom) - 1)];
    }
    // Cornish-Fisher to first order: 1.96 + (1.96^3 + 1.96) / (4 freedom); 0.3 % off at 11.
    return 1.959964 + 2.3722 / freedom + 2.8 / (static_cast<double>(freedom) * freedom);
}

Eigen::VectorXd jackknife_half_widths(const std::vector<Eigen::VectorXd>& values) {
    if (values.size() < 2) {
        return {};
    }
    const auto n = static_cast<double>(values.size());
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(values.front().size());
    for (const Eigen::VectorXd& one : values) {
        mean += one / n;
    }
    Eigen::VectorXd square = Eigen::VectorXd::Zero(mean.size());
    for (const Eigen::VectorXd& one : values) {
        square += (one - mean).cwiseAbs2();
    }
    return student(static_cast<int>(values.size()) - 1) * (square * ((n - 1.0) / n)).cwiseSqrt();
}

double length_of_blocks(const Observations& observations, const std::vector<Noise>& noise, int fewest) {
    constexpr double forgotten = 3.0;
    constexpr double most = 60.0;
    double total = 0.0;
    for (std::size_t recording = 0; recording < observations.n_recordings(); ++recording) {
        const auto [from, to] = observations.span_of(recording);
        total += to - from;
    }
    double slowest = 0.0;
    for (const Noise& one : noise) {
        slowest = std::max(slowest, one.correlation_time);
    }
    return std::clamp(forgotten * slowest, total / most, total / fewest);
}

std::vector<std::size_t> blocks_of_rows(const Observations& observations, double seconds, long fewest) {
    std::vector<std::size_t> first{0};
    std::vector<std::pair<double, double>> spans;
    for (std::size_t recording = 0; recording < observations.n_recordings(); ++recording) {
        spans.push_back(observations.span_of(recording));
        const double length = spans.back().second - spans.back().first;
        first.push_back(first.back() + static_cast<std::size_t>(std::max(fewest, std::lround(length / seconds))));
    }
    std::vector<std::size_t> blocks;
    for (const Observations::Row& what : observations.rows) {
        const std::size_t recording = observations.recordings[what.run];
        const auto [from, to] = spans[recording];
        const std::size_t n = first[recording + 1] - first[recording];
        const double share = to > from ? (observations.times[what.run][what.time] - from) / (to - from) : 0.0;
        blocks.push_back(first[recording] + std::min(n - 1, static_cast<std::size_t>(share * static_cast<double>(n))));
    }
    return blocks;
}

BlockDeviations block_deviations(const Refit& fit, const Observations& observations, double seconds) {
    BlockDeviations found{.deviation = fit.deviations()};
    const Eigen::Index n = fit.values.size();
    std::vector<Eigen::Index> free;
    for (Eigen::Index j = 0; j < n; ++j) {
        if (fit.at_bound.empty() || !fit.at_bound[static_cast<std::size_t>(j)]) {
            free.push_back(j);
        }
    }
    if (free.empty() || seconds <= 0.0) {
        return found;
    }
    std::map<std::size_t, Eigen::VectorXd> scores;
    const std::vector<std::size_t> blocks = blocks_of_rows(observations, seconds);
    for (std::size_t row = 0; row < blocks.size(); ++row) {
        const auto i = static_cast<Eigen::Index>(row);
        const Eigen::VectorXd slope = fit.slopes.row(i).transpose()(free);
        auto [at, is_new] = scores.try_emplace(blocks[row], Eigen::VectorXd::Zero(slope.size()));
        at->second += slope * fit.residual[i];
    }
    found.blocks = static_cast<int>(scores.size());
    found.wide = student(found.blocks - 1);
    if (found.blocks < 2) {
        return found;
    }
    Eigen::MatrixXd A = fit.slopes(Eigen::all, free).transpose() * fit.slopes(Eigen::all, free);
    A.diagonal() += fit.precision(free);
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(A.rows());
    for (const auto& [key, score] : scores) {
        mean += score / found.blocks;
    }
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(A.rows(), A.cols());
    for (const auto& [key, score] : scores) {
        scatter += (score - mean) * (score - mean).transpose();
    }
    scatter *= static_cast<double>(found.blocks) / (found.blocks - 1);
    const Eigen::VectorXd unit = A.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd scaled = unit.asDiagonal() * A * unit.asDiagonal();
    scaled.diagonal().array() += 1e-9;
    const Eigen::LDLT<Eigen::MatrixXd> inverse(scaled);
    const Eigen::MatrixXd left = inverse.solve(Eigen::MatrixXd(unit.asDiagonal() * scatter * unit.asDiagonal()));
    const Eigen::MatrixXd both = inverse.solve(Eigen::MatrixXd(left.transpose()));
    for (std::size_t k = 0; k < free.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const double variance = both(i, i) * unit[i] * unit[i];
        const Eigen::Index j = free[k];
        found.deviation[j] = std::max(found.deviation[j], std::sqrt(std::max(0.0, variance)) * fit.scale[j]);
    }
    return found;
}

}  // namespace tiretherm::diagnosis
