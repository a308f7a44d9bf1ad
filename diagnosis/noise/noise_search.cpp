// SPDX-License-Identifier: BSD-3-Clause
// Central differences and Newton steps in the logarithms of the correlation time and of the white part, and standard
// deviations from the curvature.

#include "diagnosis/noise/noise_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <Eigen/LU>

#include "mesh/parallel.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::diagnosis {

namespace {

using Trial = NoiseLikelihood::Trial;
/// log(tau) and log(1 + white variance / (correlated variance dt / tau)), tau the correlation time in seconds and dt the
/// interval. Over a few samples slow noise is a random walk of which data give the step's variance, 2 dt / tau times
/// that of the noise, not the two alone: in these measures the likelihood has no curved valley.
using Point = Eigen::Vector2d;

constexpr double difference_step = 0.05;  ///< a third of what a thousand samples leave uncertain
constexpr double longest_step = 1.0;
constexpr double most_white = 0.98;

struct Search {
    const NoiseLikelihood& likelihood;
    std::size_t channel = 0;
    double interval = 0.0;  ///< s
    Point low{};
    Point high{};

    [[nodiscard]] Point point(double correlation_time, double white_share) const {
        return {std::log(correlation_time),
                std::log1p(white_share / (1.0 - white_share) * correlation_time / interval)};
    }
    [[nodiscard]] Trial at(const Point& x) const {
        const double time = std::exp(x[0]);
        const double ratio = std::expm1(x[1]) * interval / time;
        return likelihood.try_correlation(channel, time, ratio / (1.0 + ratio));
    }
    [[nodiscard]] Point clipped(const Point& x) const { return x.cwiseMax(low).cwiseMin(high); }
};

/// The likelihood around a point, to second order.
struct Neighbourhood {
    Eigen::Vector2d slope;
    Eigen::Matrix2d curvature;
    Eigen::Vector2d log_sigma_slope;  ///< of the best sigma
};

/// Central differences about the point, or about the nearest one that has room for them.
Neighbourhood around(const Search& search, const Point& x) {
    solver::leave_if_stopped();
    const Point h = (0.25 * (search.high - search.low)).cwiseMin(difference_step);
    const Point centre = x.cwiseMax(search.low + h).cwiseMin(search.high - h);
    const std::array<Point, 7> places{Point(0, 0),  Point(1, 0), Point(0, 1),  Point(-1, 0),
                                      Point(0, -1), Point(1, 1), Point(-1, -1)};
    std::array<Trial, places.size()> trials;
    in_parallel(places.size(), [&](std::size_t i) { trials[i] = search.at(centre + places[i].cwiseProduct(h)); });
    const Trial& middle = trials[0];
    const std::span up(&trials[1], 2);
    const std::span down(&trials[3], 2);
    const double corners = trials[5].value + trials[6].value;
    Neighbourhood result;
    for (Eigen::Index k = 0; k < 2; ++k) {
        const auto i = static_cast<std::size_t>(k);
        result.slope[k] = (up[i].value - down[i].value) / (2.0 * h[k]);
        result.curvature(k, k) = (up[i].value + down[i].value - 2.0 * middle.value) / (h[k] * h[k]);
        result.log_sigma_slope[k] = (up[i].log_sigma - down[i].log_sigma) / (2.0 * h[k]);
    }
    const double sides = up[0].value + up[1].value + down[0].value + down[1].value;
    result.curvature(0, 1) = result.curvature(1, 0) = (corners + 2.0 * middle.value - sides) / (2.0 * h[0] * h[1]);
    result.slope += result.curvature * (x - centre);
    return result;
}

/// Which of the two may still move: not one at its bound that would go beyond.
std::array<bool, 2> movable(const Search& search, const Point& x, const Eigen::Vector2d& slope) {
    std::array<bool, 2> free{};
    for (Eigen::Index k = 0; k < 2; ++k) {
        const double margin = 1e-6 * (search.high[k] - search.low[k]);
        const bool held =
            (x[k] <= search.low[k] + margin && slope[k] >= 0.0) || (x[k] >= search.high[k] - margin && slope[k] <= 0.0);
        free[static_cast<std::size_t>(k)] = !held;
    }
    return free;
}

/// The inverse of the curvature over what is free; zero elsewhere. Not positive definite: false.
bool invert(const Eigen::Matrix2d& curvature, const std::array<bool, 2>& free, Eigen::Matrix2d& inverse) {
    inverse.setZero();
    if (free[0] && free[1]) {
        if (!(curvature(0, 0) > 0.0) || !(curvature.determinant() > 1e-6 * curvature(0, 0) * curvature(1, 1))) {
            return false;
        }
        inverse = curvature.inverse();
        return true;
    }
    for (Eigen::Index k = 0; k < 2; ++k) {
        if (free[static_cast<std::size_t>(k)]) {
            if (!(curvature(k, k) > 0.0)) {
                return false;
            }
            inverse(k, k) = 1.0 / curvature(k, k);
        }
    }
    return true;
}

/// Newton's step, or one downhill where the likelihood is not convex.
Point step_from(const Neighbourhood& here, const std::array<bool, 2>& free) {
    Eigen::Matrix2d inverse;
    Point step;
    if (invert(here.curvature, free, inverse)) {
        step = -inverse * here.slope;
    } else {
        for (Eigen::Index k = 0; k < 2; ++k) {
            const double slope = free[static_cast<std::size_t>(k)] ? here.slope[k] : 0.0;
            step[k] = -longest_step * slope / (1.0 + std::abs(slope));
        }
    }
    const double excess = step.cwiseAbs().maxCoeff() / longest_step;
    return excess > 1.0 ? step / excess : step;
}

Point coarse_start(const Search& search) {
    constexpr std::array shares{0.05, 0.35, 0.7};
    constexpr std::size_t times = 6;
    std::array<Point, times * shares.size()> points;
    std::array<double, points.size()> value;
    in_parallel(points.size(), [&](std::size_t i) {
        const double part = (static_cast<double>(i / shares.size()) + 0.5) / times;
        points[i] =
            search.point(std::exp(search.low[0] + part * (search.high[0] - search.low[0])), shares[i % shares.size()]);
        const Trial trial = search.at(points[i]);
        value[i] = !trial.empty && std::isfinite(trial.value) ? trial.value : std::numeric_limits<double>::infinity();
    });
    const auto lowest = std::ranges::min_element(value);
    return std::isfinite(*lowest) ? points[static_cast<std::size_t>(lowest - value.begin())] : search.low;
}

}  // namespace

NoiseOptimum search_noise(const NoiseLikelihood& likelihood, std::size_t channel, const NoiseBounds& bounds,
                          bool from_now) {
    Search search{.likelihood = likelihood, .channel = channel, .interval = likelihood.median_interval(channel)};
    search.low = search.point(bounds.shortest, 0.0);
    search.high = search.point(bounds.longest, most_white);
    const Noise& now = likelihood.covariance().channels[channel];
    Point x = from_now ? search.clipped(search.point(now.correlation_time, now.white_share)) : coarse_start(search);
    NoiseOptimum optimum{.best = search.at(x)};
    Neighbourhood here;
    std::array<bool, 2> free{};
    constexpr int most_steps = 20;
    for (int iteration = 0; iteration < most_steps; ++iteration) {
        here = around(search, x);
        free = movable(search, x, here.slope);
        const double before = optimum.best.value;
        Point step = step_from(here, free);
        for (int halving = 0; halving < 6; ++halving, step *= 0.5) {
            const Point next = search.clipped(x + step);
            if (Trial trial = search.at(next); !trial.empty && trial.value < optimum.best.value) {
                optimum.best = std::move(trial);
                x = next;
                break;
            }
        }
        // What is left to gain is a thousandth of a unit: a thirtieth of a standard deviation.
        if (before - optimum.best.value < 1e-3) {
            break;
        }
    }
    Eigen::Matrix2d inverse;
    if (invert(here.curvature, free, inverse)) {
        // The value is -2 log likelihood: covariance = 2 / curvature; sigma at given correlation has 1 / (2 freedom).
        const Eigen::Matrix2d spread = 2.0 * inverse;
        const double sigma = std::exp(optimum.best.log_sigma);
        optimum.sigma_deviation =
            sigma * std::sqrt(here.log_sigma_slope.dot(spread * here.log_sigma_slope) + 0.5 / optimum.best.freedom);
        const double time = optimum.best.correlation_time;
        optimum.rho_1s_deviation =
            free[0] ? std::exp(-1.0 / time) / time * std::sqrt(spread(0, 0)) : std::numeric_limits<double>::quiet_NaN();
    } else {
        optimum.sigma_deviation = optimum.rho_1s_deviation = std::numeric_limits<double>::quiet_NaN();
    }
    return optimum;
}

}  // namespace tiretherm::diagnosis
