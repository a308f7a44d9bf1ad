#include "exam_oracle_truth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace hidden_effects {

namespace {

constexpr double scale_prior = 0.1;
constexpr double start_prior = 3.0;  ///< K

/// One free number moved by so much: 0 the film's scale, 1 the loss's, then surface and bulk of each run.
BenchRuns moved(BenchRuns runs, std::size_t number, double by) {
    if (number == 0) {
        runs.lambda_h += by;
    } else if (number == 1) {
        runs.lambda_sel += by;
    } else {
        std::vector<double>& start = number % 2 == 0 ? runs.surface_start : runs.bulk_start;
        start[(number - 2) / 2] += by;
    }
    return runs;
}

}  // namespace

Readings readings_of(const BenchRuns& runs, const std::vector<Cause>& hidden, double tolerance) {
    Readings readings;
    for (std::size_t run = 0; run < runs.programmes.size(); ++run) {
        const Bench bench{.lambda_h = runs.lambda_h,
                          .lambda_sel = runs.lambda_sel,
                          .surface_start = runs.surface_start[run],
                          .bulk_start = runs.bulk_start[run],
                          .causes = hidden};
        readings.push_back(drive_bench(bench, runs.programmes[run], tolerance));
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

Oracle::Oracle(BenchRuns runs) : runs_(std::move(runs)), plain_(readings_of(runs_, {})) {
    const std::size_t n_numbers = 2 + 2 * runs_.programmes.size();
    const auto n = static_cast<Eigen::Index>(n_numbers);
    prior_ = Eigen::VectorXd::Constant(n, start_prior);
    prior_.head(2).setConstant(scale_prior);
    columns_.resize(whitened_difference(plain_).size(), n);
    for (std::size_t j = 0; j < n_numbers; ++j) {
        // A tenth of the prior: the curvature over it is far below the noise, the local error of 1e-6 K below both.
        const double step = 0.1 * prior_[static_cast<Eigen::Index>(j)];
        const Eigen::VectorXd above = whitened_difference(readings_of(moved(runs_, j, step), {}));
        const Eigen::VectorXd below = whitened_difference(readings_of(moved(runs_, j, -step), {}));
        columns_.col(static_cast<Eigen::Index>(j)) = (above - below) / (2.0 * step);
    }
    Eigen::MatrixXd precision = columns_.transpose() * columns_;
    precision.diagonal() += prior_.cwiseInverse().cwiseAbs2();
    inverse_ = precision.llt().solve(Eigen::MatrixXd::Identity(n, n));
}

Eigen::VectorXd Oracle::whitened_difference(const Readings& readings) const {
    std::vector<Eigen::VectorXd> parts;
    Eigen::Index size = 0;
    for (std::size_t run = 0; run < readings.size(); ++run) {
        const auto add = [&](const Noise& noise, std::vector<double> values, const std::vector<double>& plain) {
            std::transform(values.begin(), values.end(), plain.begin(), values.begin(), std::minus<>());
            parts.push_back(whitened(noise, runs_.programmes[run].time, values));
            size += parts.back().size();
        };
        add(camera_noise, readings[run].surface, plain_[run].surface);
        add(probe_noise, readings[run].bulk, plain_[run].bulk);
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

Eigen::VectorXd Oracle::left_by(const std::vector<Cause>& causes) const { return left_of(readings_of(runs_, causes)); }

double correlation(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.dot(b) / (a.norm() * b.norm()); }

std::optional<double> number_for(const Oracle& oracle, const Variant& variant, double sign, double sigma,
                                 double critical_speed) {
    constexpr double invisible = 1e-3;  // standard deviations
    const auto shows = [&](double step) {
        return oracle.left_by({cause_of(variant, variant.absent + step, critical_speed)}).norm();
    };
    const double direction = variant.typical > 0.0 ? sign : -sign;
    const double most = (direction > 0.0 ? variant.high : variant.low) - variant.absent;
    double before = 0.0;
    double seen_before = 0.0;
    double step = sign * variant.typical;
    for (int i = 0; i < 8; ++i) {
        const double seen = shows(step);
        if (seen < invisible || (step == most && seen < sigma)) {
            return std::nullopt;
        }
        if (std::abs(seen - sigma) < 0.005 * sigma) {
            return variant.absent + step;
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
