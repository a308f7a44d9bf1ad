// SPDX-License-Identifier: BSD-3-Clause
// Simulated residuals with slow columns, as input to tests of the noise estimate.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "diagnosis/noise/noise_estimate.hpp"
#include "tests/diagnosis/noise/noise_sample.hpp"

/// What tests ask an estimate of the noise about.
namespace tiretherm::diagnosis::sample {

/// Camera and probe of the practice bench, sampled every 2 s: rho 0.9 at 1 s, 30 % white.
inline const Noise camera{.sigma = 0.5, .correlation_time = 9.491, .white_share = 0.3};
inline const Noise probe{.sigma = 0.3, .correlation_time = 9.491, .white_share = 0.3};
inline const Noise white{.sigma = 0.5, .correlation_time = 0.0, .white_share = 1.0};

/// Residuals, and what an estimate is asked with.
struct Data {
    std::vector<NoiseBlock> blocks;
    Eigen::VectorXd residual;
    Eigen::MatrixXd span;
    Eigen::VectorXd precision;
    std::vector<double> data_sheet;
    NoiseModel model = NoiseModel::correlated;
    bool robust = false;

    [[nodiscard]] NoiseEstimate estimate() const {
        return estimate_noise({.blocks = blocks,
                               .residual = residual,
                               .span = span,
                               .precision = precision,
                               .data_sheet = data_sheet,
                               .model = model,
                               .robust = robust});
    }
    void add(int channel, const std::vector<double>& time, const std::vector<double>& value) {
        const Eigen::Index first = residual.size();
        blocks.push_back(series_block(channel, first, time, value));
        residual.conservativeResize(first + static_cast<Eigen::Index>(value.size()));
        residual.tail(static_cast<Eigen::Index>(value.size())) =
            Eigen::Map<const Eigen::VectorXd>(value.data(), static_cast<Eigen::Index>(value.size()));
        data_sheet.resize(std::max(data_sheet.size(), static_cast<std::size_t>(channel) + 1), 0.0);
    }
    /// Slow columns, as sensitivities are: cosines of up to `columns` half periods over each block.
    void span_cosines(Eigen::Index columns) {
        span.resize(residual.size(), columns);
        for (const NoiseBlock& block : blocks) {
            for (Eigen::Index i = 0; i < block.rows(); ++i) {
                for (Eigen::Index j = 0; j < columns; ++j) {
                    span(block.first + i, j) =
                        std::cos(std::numbers::pi * static_cast<double>(j) * (static_cast<double>(i) + 0.5) /
                                 static_cast<double>(block.rows()));
                }
            }
        }
        precision = Eigen::VectorXd::Zero(columns);
    }
};

inline Data one_series(const Noise& noise, std::size_t samples, double interval, Eigen::Index columns,
                       std::uint64_t seed) {
    Data data;
    const std::vector<double> time = clock(samples, interval);
    data.add(0, time, draw(noise, time, seed));
    data.span_cosines(columns);
    return data;
}

}  // namespace tiretherm::diagnosis::sample
