// SPDX-License-Identifier: BSD-3-Clause
// Whitening by a one-state Kalman filter, slopes by central differences, and a secant search for the size of a cause.

#include "exam/exam_oracle_truth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace hidden_effects {

RigTrace readings_of_run(const BenchRuns& runs, std::size_t run, const std::vector<Cause>& hidden, double tolerance) {
    std::vector<double> numbers = runs.of_bench;
    numbers.insert(numbers.end(), runs.of_run[run].begin(), runs.of_run[run].end());
    return runs.rig->drive(numbers, hidden, runs.programmes[run], tolerance);
}

Readings readings_of(const BenchRuns& runs, const std::vector<Cause>& hidden, double tolerance) {
    Readings readings;
    for (std::size_t run = 0; run < runs.programmes.size(); ++run) {
        readings.push_back(readings_of_run(runs, run, hidden, tolerance));
    }
    return readings;
}

Eigen::VectorXd whitened(const Noise& noise, const std::vector<double>& times, const std::vector<double>& values) {
    const double variance = noise.standard_deviation * noise.standard_deviation;
    const double correlated = variance * noise.correlated_share;
    const double white = variance - correlated;
    double expected = 0.0;  // of the correlated part, and its variance, before the value is known
    double spread = correlated;
    Eigen::VectorXd out(static_cast<Eigen::Index>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) {
            const double kept = std::pow(noise.correlation, times[i] - times[i - 1]);
            expected *= kept;
            spread = kept * kept * spread + (1.0 - kept * kept) * correlated;
        }
        const double innovation = values[i] - expected;
        const double total = spread + white;
        out[static_cast<Eigen::Index>(i)] = innovation / std::sqrt(total);
        expected += spread / total * innovation;
        spread *= white / total;
    }
    return out;
}

Oracle::Oracle(BenchRuns runs) : runs_(std::move(runs)), plain_(readings_of(runs_, {}, runs_.rig->oracle_error)) {
    const Rig& rig = *runs_.rig;
    const std::size_t n_numbers = rig.of_bench.size() + rig.of_run.size() * runs_.programmes.size();
    const auto n = static_cast<Eigen::Index>(n_numbers);
    prior_.resize(n);
    columns_.resize(whitened_difference(plain_).size(), n);
    Eigen::Index column = 0;
    // A tenth of the prior: the curvature over it is far below the noise, the local error of the steps below both.
    const auto add = [&](double prior, double& number, std::size_t first_run, std::size_t last_run) {
        const double step = 0.1 * prior;
        const double here = number;
        const auto moved = [&](double by) {
            number = here + by;
            Readings readings = plain_;
            for (std::size_t run = first_run; run < last_run; ++run) {
                readings[run] = readings_of_run(runs_, run, {}, rig.oracle_error);
            }
            return whitened_difference(readings);
        };
        const Eigen::VectorXd above = moved(step);
        const Eigen::VectorXd below = moved(-step);
        number = here;
        columns_.col(column) = (above - below) / (2.0 * step);
        prior_[column++] = prior;
    };
    for (std::size_t j = 0; j < rig.of_bench.size(); ++j) {
        add(rig.of_bench[j].prior, runs_.of_bench[j], 0, runs_.programmes.size());
    }
    for (std::size_t run = 0; run < runs_.programmes.size(); ++run) {
        for (std::size_t j = 0; j < rig.of_run.size(); ++j) {
            add(rig.of_run[j].prior, runs_.of_run[run][j], run, run + 1);
        }
    }
    Eigen::MatrixXd precision = columns_.transpose() * columns_;
    precision.diagonal() += prior_.cwiseInverse().cwiseAbs2();
    inverse_ = precision.llt().solve(Eigen::MatrixXd::Identity(n, n));
}

Eigen::VectorXd Oracle::whitened_difference(const Readings& readings) const {
    std::vector<Eigen::VectorXd> parts;
    Eigen::Index size = 0;
    for (std::size_t run = 0; run < readings.size(); ++run) {
        for (std::size_t c = 0; c < readings[run].size(); ++c) {
            std::vector<double> values = readings[run][c];
            std::transform(values.begin(), values.end(), plain_[run][c].begin(), values.begin(), std::minus<>());
            parts.push_back(whitened(runs_.rig->channels[c].noise, runs_.programmes[run].time, values));
            size += parts.back().size();
        }
    }
    Eigen::VectorXd all(size);
    Eigen::Index from = 0;
    for (const Eigen::VectorXd& part : parts) {
        all.segment(from, part.size()) = part;
        from += part.size();
    }
    return all;
}

Eigen::VectorXd Oracle::left_of_whitened(const Eigen::VectorXd& difference) const {
    const Eigen::VectorXd imitation = inverse_ * (columns_.transpose() * difference);
    Eigen::VectorXd left(difference.size() + imitation.size());
    left << difference - columns_ * imitation, -imitation.cwiseQuotient(prior_);
    return left;
}

Eigen::VectorXd Oracle::left_of(const Readings& readings) const {
    return left_of_whitened(whitened_difference(readings));
}

Eigen::VectorXd Oracle::left_by(const std::vector<Cause>& causes) const { return left_by(causes, runs_); }

Eigen::VectorXd Oracle::left_by(const std::vector<Cause>& causes, const BenchRuns& driven) const {
    return left_of(readings_of(driven, causes, driven.rig->oracle_error));
}

double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.dot(b) / (a.norm() * b.norm()); }

std::optional<Size> size_for(const Oracle& oracle, const Variant& variant, double sign, double sigma,
                             double critical_speed, const BenchRuns* driven) {
    constexpr double invisible = 1e-3;  // standard deviations
    const BenchRuns& runs = driven != nullptr ? *driven : oracle.runs();
    const double direction = variant.typical > 0.0 ? sign : -sign;
    const double most = (direction > 0.0 ? variant.high : variant.low) - variant.absent;
    double before = 0.0;
    double seen_before = 0.0;
    double step = sign * variant.typical;
    for (int i = 0; i < 8; ++i) {
        Eigen::VectorXd left = oracle.left_by({cause_of(variant, variant.absent + step, critical_speed)}, runs);
        const double seen = left.norm();
        if (seen < invisible || (step == most && seen < sigma)) {
            return std::nullopt;
        }
        if (std::abs(seen - sigma) < runs.rig->size_error * sigma) {
            return Size{.number = variant.absent + step, .left = std::move(left)};
        }
        const double slope = (seen - seen_before) / (step - before);
        const double next = step + (sigma - seen) / slope;
        before = step;
        seen_before = seen;
        // A secant may overshoot: never beyond what is physical, never by more than tenfold, never back to nothing.
        const double size = std::clamp(std::abs(next), 0.1 * std::abs(step), 10.0 * std::abs(step));
        step = std::copysign(std::min(size, std::abs(most)), direction);
    }
    return std::nullopt;
}

}  // namespace hidden_effects
