// SPDX-License-Identifier: BSD-3-Clause
// Residuals, whitened slopes and information matrix at the present values; the noise of long image channels is
// estimated from a part of their rows.

#include "diagnosis/fit/fit.hpp"

#include <algorithm>
#include <cmath>

namespace tiretherm::diagnosis {

namespace {

/// Rows from which a channel's noise is estimated, enough to know its sigma to half a percent: of images, whose fine bands
/// have hundreds of thousands, every so many pixels with all their frames.
constexpr Eigen::Index enough_rows = 30000;

struct SampledRows {
    std::vector<NoiseBlock> blocks;
    std::vector<Eigen::Index> rows;
};

/// @returns nothing where every channel has few rows
std::optional<SampledRows> a_share_of(const std::vector<NoiseBlock>& blocks, std::size_t n_channels) {
    std::vector<Eigen::Index> rows(n_channels, 0);
    for (const NoiseBlock& block : blocks) {
        if (block.channel >= 0) {
            rows[static_cast<std::size_t>(block.channel)] += block.rows();
        }
    }
    if (std::ranges::all_of(rows, [](Eigen::Index n) { return n <= 2 * enough_rows; })) {
        return std::nullopt;
    }
    SampledRows share;
    std::vector<Eigen::Index> seen(n_channels, 0);  // blocks of each channel
    for (const NoiseBlock& block : blocks) {
        if (block.channel >= 0) {
            const auto c = static_cast<std::size_t>(block.channel);
            const Eigen::Index every = std::max<Eigen::Index>(1, rows[c] / enough_rows);
            if (seen[c]++ % every != 0) {
                continue;
            }
        }
        share.blocks.push_back(block);
        share.blocks.back().first = static_cast<Eigen::Index>(share.rows.size());
        for (Eigen::Index i = 0; i < block.rows(); ++i) {
            share.rows.push_back(block.first + i);
        }
    }
    return share;
}

}  // namespace

input::Experiment with_fine_steps(input::Experiment experiment) {
    constexpr double step_error = 1e-3;  // K
    for (input::MeasuredRun& run : experiment.runs) {
        run.problem.settings.tolerance = std::min(run.problem.settings.tolerance, step_error);
    }
    return experiment;
}

input::Experiment with_free_conductivity(input::Experiment experiment) {
    constexpr double room = 293.15;  // K
    const solver::Problem& problem = experiment.runs.front().problem;
    const physics::Curve& law = problem.materials.front().along(mesh::Axis::through);
    const double value = law.value(room);
    solver::FreeParameter number{.name = problem.materials.front().name + ".conductivity at 20 degC",
                                 .unit = "W m-1 K-1",
                                 .kind = solver::FreeParameter::Kind::conductivity,
                                 .layers = {},
                                 .knots = {room},
                                 .nodes = {},
                                 .runs = {},
                                 .prior = value,
                                 .standard_deviation = 0.5 * value,
                                 .low = 0.1 * value,
                                 .high = 5.0 * value};
    for (std::size_t layer = 0; layer < problem.materials.size(); ++layer) {
        if (problem.materials[layer].along(mesh::Axis::through) == law) {
            number.layers.push_back(static_cast<int>(layer));
        }
    }
    const bool is_free = std::ranges::any_of(experiment.parameters, [](const solver::FreeParameter& one) {
        return one.kind == solver::FreeParameter::Kind::conductivity ||
               one.kind == solver::FreeParameter::Kind::link_conductivity;
    });
    if (!is_free) {
        experiment.parameters.push_back(std::move(number));
    }
    return experiment;
}

Fit::Fit(const input::Experiment& experiment, const Observations& observations)
    : experiment_(experiment),
      observations_(observations),
      simulator_(experiment, observations),
      n_(static_cast<Eigen::Index>(experiment.parameters.size())),
      prior_(n_),
      precision_(n_),
      low_(n_),
      high_(n_) {
    for (Eigen::Index j = 0; j < n_; ++j) {
        const solver::FreeParameter& parameter = experiment.parameters[static_cast<std::size_t>(j)];
        prior_[j] = parameter.prior;
        precision_[j] = std::isfinite(parameter.standard_deviation)
                            ? 1.0 / (parameter.standard_deviation * parameter.standard_deviation)
                            : 0.0;
        low_[j] = parameter.low;
        high_[j] = parameter.high;
    }
    scale_ = scales_of(experiment, simulator_.start());
    covariance_.channels.resize(observations.channels.size());
}

bool Fit::move_to(const Eigen::VectorXd& values) {
    prediction_ = simulator_.at(values);
    values_ = values;
    return prediction_.status.ok();
}

void Fit::take_stated_noise() {
    for (std::size_t c = 0; c < observations_.channels.size(); ++c) {
        covariance_.channels[c] = {.sigma = stated(c) > 0.0 ? stated(c) : 1.0};
    }
}

void Fit::find_noise(const Eigen::MatrixXd& also) {
    std::vector<double> sheet;
    for (std::size_t c = 0; c < observations_.channels.size(); ++c) {
        sheet.push_back(stated(c));
    }
    const Eigen::VectorXd residual = prediction_.simulated - observations_.measured;
    Eigen::MatrixXd span(residual.size(), n_ + also.cols());
    span.leftCols(n_) = prediction_.slope * scale_.asDiagonal();
    if (also.cols() > 0) {  // nothing has no rows either
        span.rightCols(also.cols()) = also;
    }
    Eigen::VectorXd precision = Eigen::VectorXd::Zero(span.cols());
    precision.head(n_) = precision_.cwiseProduct(scale_.cwiseAbs2());
    const auto estimate = [&](const std::vector<NoiseBlock>& blocks, const Eigen::VectorXd& rest,
                              const Eigen::MatrixXd& columns) {
        noise_ = estimate_noise({.blocks = blocks,
                                 .residual = rest,
                                 .span = columns,
                                 .precision = precision,
                                 .data_sheet = std::move(sheet),
                                 .model = experiment_.noise == "white" ? NoiseModel::white : NoiseModel::correlated,
                                 .robust = experiment_.robust,
                                 .start = covariance_.channels});
    };
    if (const auto some = experiment_.robust ? std::nullopt : a_share_of(observations_.blocks, sheet.size())) {
        estimate(some->blocks, residual(some->rows), span(some->rows, Eigen::all));
    } else {
        estimate(observations_.blocks, residual, span);
    }
    covariance_ = noise_.covariance;
}

Fit::Turn Fit::minimise_squares() {
    const LeastSquaresResult result = minimise(least_squares());
    const Eigen::VectorXd by = result.values - values_;
    Turn turn{.iterations = result.iterations, .converged = result.converged};
    if (move_to(result.values)) {
        turn.moved = by.cwiseQuotient(scale_).cwiseAbs().cwiseProduct(information().diagonal().cwiseSqrt()).maxCoeff();
    }
    return turn;
}

LeastSquares Fit::least_squares() {
    return {.residuals = [this](const Eigen::VectorXd& values) { return residuals(values); },
            .n_rows = observations_.measured.size() + n_,
            .start = values_,
            .low = low_,
            .high = high_,
            .scale = scale_};
}

std::optional<Residuals> Fit::residuals(const Eigen::VectorXd& values) {
    const ModelPrediction& found = simulator_.at(values);
    if (!found.status.ok()) {
        return std::nullopt;
    }
    Eigen::MatrixXd rows(observations_.measured.size(), n_ + 1);
    rows << found.slope, found.simulated - observations_.measured;
    whiten(observations_.blocks, covariance_, rows);
    Residuals all{.value = Eigen::VectorXd(rows.rows() + n_), .slope = Eigen::MatrixXd(rows.rows() + n_, n_)};
    const Eigen::VectorXd root = precision_.cwiseSqrt();
    all.value << rows.col(n_), root.cwiseProduct(values - prior_);
    all.slope << rows.leftCols(n_), Eigen::MatrixXd(root.asDiagonal());
    return all;
}

Eigen::MatrixXd Fit::information() const {
    const Eigen::MatrixXd whitened = whitened_slopes();
    Eigen::MatrixXd matrix = whitened.transpose() * whitened;
    matrix.diagonal() += precision_.cwiseProduct(scale_.cwiseAbs2());
    return matrix;
}

Eigen::MatrixXd Fit::whitened_slopes() const {
    Eigen::MatrixXd whitened = prediction_.slope * scale_.asDiagonal();
    whiten(observations_.blocks, covariance_, whitened);
    return whitened;
}

Eigen::VectorXd Fit::whitened_residuals() const {
    Eigen::MatrixXd left = prediction_.simulated - observations_.measured;
    whiten(observations_.blocks, covariance_, left);
    return left.col(0);
}

double Fit::stated(std::size_t c) const { return observations_.stated[c]; }

Eigen::VectorXd scales_of(const input::Experiment& experiment, const Eigen::VectorXd& values) {
    Eigen::VectorXd scale(values.size());
    for (Eigen::Index j = 0; j < values.size(); ++j) {
        const solver::FreeParameter& parameter = experiment.parameters[static_cast<std::size_t>(j)];
        double size = parameter.standard_deviation;
        if (!std::isfinite(size)) {
            size = parameter.kind == solver::FreeParameter::Kind::initial ? 10.0 : std::abs(values[j]);
        }
        if (size == 0.0) {
            size = std::isfinite(parameter.high - parameter.low) ? 0.1 * (parameter.high - parameter.low) : 1.0;
        }
        scale[j] = size;
    }
    return scale;
}

}  // namespace tiretherm::diagnosis
