// SPDX-License-Identifier: BSD-3-Clause
// Least squares on standardised samples by Eigen, with 95 % intervals of the coefficients and their shares of the
// variance.

#include "diagnosis/study/study_drivers.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace tiretherm::diagnosis {

namespace {

constexpr std::size_t samples_for_a_number = 5;
constexpr double two_sided = 1.959963984540054;  // 97.5 % of the standard normal distribution

using Vector = Eigen::VectorXd;

double mean_of(const Vector& x) { return x.mean(); }

double deviation_of(const Vector& x) {
    return std::sqrt((x.array() - x.mean()).square().sum() / static_cast<double>(x.size() - 1));
}

/// The runs at a point that came to their end.
std::vector<std::size_t> sound_runs(const StudyRecord& study, std::size_t point) {
    std::vector<std::size_t> runs;
    for (std::size_t r = point * study.samples; r < (point + 1) * study.samples; ++r) {
        if (study.outcomes[r].ok()) {
            runs.push_back(r);
        }
    }
    return runs;
}

}  // namespace

StudyRegression regression(const StudyRecord& study, std::size_t point) {
    StudyRegression line;
    const std::vector<std::size_t> runs = sound_runs(study, point);
    const auto n = static_cast<Eigen::Index>(runs.size());
    if (n < 2) {
        return line;
    }
    std::vector<StudyDriver> drivers;
    Eigen::MatrixXd X(n, 0);  // standardised
    for (const StudyColumn& column : study.columns) {
        if (!column.is_drawn || !column.is_number) {
            continue;
        }
        Vector x(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            x[i] = column.numbers[runs[static_cast<std::size_t>(i)]];
        }
        const double mean = mean_of(x);
        const double deviation = deviation_of(x);
        if (deviation > 1e-12 * std::abs(mean)) {
            X.conservativeResize(n, X.cols() + 1);
            X.col(X.cols() - 1) = (x.array() - mean) / deviation;
            drivers.push_back({.key = column.key, .unit = column.unit, .mean = mean, .standard_deviation = deviation});
        }
    }
    const auto k = X.cols();
    if (k == 0 || runs.size() < samples_for_a_number * static_cast<std::size_t>(k + 1)) {
        return line;
    }
    Vector y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        y[i] = study.outcomes[runs[static_cast<std::size_t>(i)]].hottest;
    }
    line.mean = y.mean();
    const Vector rise = y.array() - line.mean;
    const Eigen::LDLT<Eigen::MatrixXd> normal(X.transpose() * X);
    const Vector slope = normal.solve(X.transpose() * rise);
    const Eigen::MatrixXd inverse = normal.solve(Eigen::MatrixXd::Identity(k, k));
    const double left = (rise - X * slope).squaredNorm();
    const double variance = left / static_cast<double>(n - k - 1);
    line.residual = std::sqrt(variance);
    line.r_squared = rise.squaredNorm() > 0.0 ? 1.0 - left / rise.squaredNorm() : 0.0;
    line.standard_deviation = slope.norm();
    for (Eigen::Index j = 0; j < k; ++j) {
        StudyDriver& driver = drivers[static_cast<std::size_t>(j)];
        driver.kelvin = slope[j];
        driver.uncertainty = two_sided * std::sqrt(variance * inverse(j, j));
        driver.share = slope[j] * slope[j] / slope.squaredNorm();
    }
    std::ranges::stable_sort(
        drivers, [](const StudyDriver& a, const StudyDriver& b) { return std::abs(a.kelvin) > std::abs(b.kelvin); });
    line.drivers = std::move(drivers);
    return line;
}

double StudyRegression::chance_above(double temperature) const {
    const double spread = std::hypot(standard_deviation, residual);
    return spread > 0.0 ? 0.5 * std::erfc((temperature - mean) / (spread * std::sqrt(2.0)))
                        : (mean > temperature ? 1.0 : 0.0);
}

}  // namespace tiretherm::diagnosis
