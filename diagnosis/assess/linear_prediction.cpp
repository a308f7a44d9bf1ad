// SPDX-License-Identifier: BSD-3-Clause
// Normal equations of chosen columns are parts of sums of products that are formed once.

#include "diagnosis/assess/linear_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

namespace tiretherm::diagnosis {

namespace {

Eigen::MatrixXd side_by_side(const Eigen::MatrixXd& numbers, const Eigen::MatrixXd& signatures,
                             const Eigen::VectorXd& left) {
    Eigen::MatrixXd all(left.size(), numbers.cols() + signatures.cols() + 1);
    all << numbers, signatures, left;
    return all;
}

Eigen::MatrixXd sums_of_products(const Eigen::MatrixXd& columns, const RowIndices& rows) {
    const Eigen::MatrixXd some = columns(rows, Eigen::all);
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
    sums.selfadjointView<Eigen::Lower>().rankUpdate(some.transpose());
    return sums.selfadjointView<Eigen::Lower>();
}

}  // namespace

LinearPrediction::LinearPrediction(const LinearisedModel& model, const Signatures& beside,
                                   const std::vector<Fold>& folds, const std::vector<std::vector<bool>>& own,
                                   const std::vector<int>& noise_of, std::size_t n_noises)
    : n_(model.slopes.cols()),
      last_(n_ + beside.raw.cols()),
      precision_(Eigen::VectorXd::Zero(last_)),
      pull_(Eigen::VectorXd::Zero(last_)),
      bounds_(beside.bounds_of_numbers),
      own_(own),
      count_(n_noises, 0.0) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    bounds_.resize(static_cast<std::size_t>(n_), {-infinite, infinite});
    bounds_.insert(bounds_.end(), beside.bounds.begin(), beside.bounds.end());
    precision_.head(n_) = model.precision;
    pull_.head(n_) = model.precision.cwiseSqrt().cwiseProduct(model.known);
    const Eigen::MatrixXd white = side_by_side(model.slopes, beside.white, model.residual);
    const Eigen::MatrixXd raw = side_by_side(model.raw, beside.raw, model.left);
    all_ = white.transpose() * white;
    for (const Fold& fold : folds) {
        FoldSums& sums = folds_.emplace_back();
        sums.rest = sums_of_products(white, fold.rest);
        sums.test = sums_of_products(white, fold.test);
        std::vector<RowIndices> of_channel(n_noises);
        for (const Eigen::Index row : fold.test) {
            of_channel[static_cast<std::size_t>(noise_of[static_cast<std::size_t>(row)])].push_back(row);
        }
        for (std::size_t c = 0; c < n_noises; ++c) {
            sums.by_channel.push_back(sums_of_products(raw, of_channel[c]));
            count_[c] += static_cast<double>(of_channel[c].size());
        }
    }
}

std::vector<Eigen::Index> LinearPrediction::columns_of(const std::vector<Eigen::Index>& chosen) const {
    std::vector<Eigen::Index> columns;
    for (Eigen::Index j = 0; j < n_; ++j) {
        columns.push_back(j);
    }
    for (const Eigen::Index k : chosen) {
        columns.push_back(n_ + k);
    }
    return columns;
}

/// Least squares of some columns, of which some are held where they start.
Eigen::VectorXd LinearPrediction::solution(const Eigen::MatrixXd& sums, const std::vector<Eigen::Index>& columns,
                                           const Eigen::VectorXd& start, const std::vector<bool>& held) const {
    Eigen::MatrixXd normal = sums(columns, columns);
    Eigen::VectorXd right = sums(columns, last_) - normal * start;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        normal(at, at) += precision_[columns[i]];
        right[at] += pull_[columns[i]] - precision_[columns[i]] * start[at];
        if (held[i] || !(normal(at, at) > 0.0)) {
            normal.row(at).setZero();
            normal.col(at).setZero();
            normal(at, at) = 1.0;
            right[at] = 0.0;
        }
    }
    const Eigen::VectorXd scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd unit = scale.asDiagonal() * normal * scale.asDiagonal();
    unit.diagonal().array() += 1e-9;  // two columns that do the same share what there is to explain
    return start + scale.cwiseProduct(unit.llt().solve(scale.cwiseProduct(right)));
}

/// The same with every step within its bounds: what the rest of the data hardly tell would go anywhere.
Eigen::VectorXd LinearPrediction::bounded(const Eigen::MatrixXd& sums, const std::vector<Eigen::Index>& columns) const {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(columns.size()));
    std::vector<bool> held(columns.size(), false);
    const Eigen::VectorXd free = solution(sums, columns, none, held);
    Eigen::VectorXd start = none;
    bool any = false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const auto [low, high] = bounds_[static_cast<std::size_t>(columns[i])];
        if (free[at] < low || free[at] > high) {
            start[at] = std::clamp(free[at], low, high);
            held[i] = any = true;
        }
    }
    return any ? solution(sums, columns, start, held) : free;
}

LinearPrediction::MeanSquares LinearPrediction::with(const std::vector<Eigen::Index>& chosen) const {
    const std::vector<Eigen::Index> columns = columns_of(chosen);
    MeanSquares squares(count_.size(), 0.0);
    for (std::size_t f = 0; f < folds_.size(); ++f) {
        Eigen::VectorXd step = bounded(folds_[f].rest, columns);
        std::vector<bool> shared(columns.size(), true);
        for (std::size_t j = 0; j < static_cast<std::size_t>(n_); ++j) {
            shared[j] = !own_[f][j];
            step[static_cast<Eigen::Index>(j)] *= shared[j] ? 1.0 : 0.0;
        }
        step = solution(folds_[f].test, columns, step, shared);
        Eigen::VectorXd error = Eigen::VectorXd::Zero(last_ + 1);
        error(columns) = -step;
        error[last_] = 1.0;
        for (std::size_t c = 0; c < squares.size(); ++c) {
            squares[c] += error.dot(folds_[f].by_channel[c] * error);
        }
    }
    for (std::size_t c = 0; c < squares.size(); ++c) {
        squares[c] = count_[c] > 0.0 ? squares[c] / count_[c] : std::numeric_limits<double>::quiet_NaN();
    }
    return squares;
}

std::vector<double> LinearPrediction::amplitudes(const std::vector<Eigen::Index>& chosen) const {
    const Eigen::VectorXd step = bounded(all_, columns_of(chosen));
    return {step.data() + n_, step.data() + step.size()};
}

double share_removed(const LinearPrediction::MeanSquares& before, const LinearPrediction::MeanSquares& after) {
    double removed = 0.0;
    double counted = 0.0;
    for (std::size_t c = 0; c < before.size(); ++c) {
        if (before[c] > 0.0) {
            removed += 1.0 - after[c] / before[c];
            counted += 1.0;
        }
    }
    return counted > 0.0 ? removed / counted : 0.0;
}

}  // namespace tiretherm::diagnosis
