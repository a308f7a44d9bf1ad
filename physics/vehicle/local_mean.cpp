// SPDX-License-Identifier: BSD-3-Clause
// Integrals of the straight lines between samples, read off at both ends of a window that moves on.

#include "physics/vehicle/local_mean.hpp"

#include <algorithm>
#include <cstddef>

namespace tiretherm::physics {

namespace {

/// Value and integral from the first sample on, at times that mostly ascend: each caller keeps the piece in which its last time
/// lay, from which the next one is a few steps away.
class Lines {
public:
    using Piece = std::size_t;

    Lines(const std::vector<double>& time, const std::vector<double>& value) : time_(time), value_(value) {
        integral_.assign(time.size(), 0.0);
        for (std::size_t i = 1; i < time.size(); ++i) {
            integral_[i] = integral_[i - 1] + 0.5 * (value[i] + value[i - 1]) * (time[i] - time[i - 1]);
        }
    }
    [[nodiscard]] double value(double t, Piece& i) const {
        move_to(t, i);
        return value_[i] + slope(i) * (t - time_[i]);
    }
    [[nodiscard]] double integral(double t, Piece& i) const {
        move_to(t, i);
        const double dt = t - time_[i];
        return integral_[i] + dt * (value_[i] + 0.5 * slope(i) * dt);
    }

private:
    void move_to(double t, Piece& i) const {
        while (i + 2 < time_.size() && time_[i + 1] <= t) {
            ++i;
        }
        while (i > 0 && time_[i] > t) {
            --i;
        }
    }
    [[nodiscard]] double slope(std::size_t i) const { return (value_[i + 1] - value_[i]) / (time_[i + 1] - time_[i]); }

    const std::vector<double>& time_;
    const std::vector<double>& value_;
    std::vector<double> integral_;
};

double to_the_ends(const std::vector<double>& time, double t) { return std::min(t - time.front(), time.back() - t); }

std::vector<double> mean_once(const std::vector<double>& time, const std::vector<double>& value, double half) {
    const Lines lines(time, value);
    std::vector<double> mean(value);
    Lines::Piece begin = 0;
    Lines::Piece end = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const double reach = std::min(half, to_the_ends(time, time[i]));
        if (reach > 0.0) {
            mean[i] = (lines.integral(time[i] + reach, end) - lines.integral(time[i] - reach, begin)) / (2.0 * reach);
        }
    }
    return mean;
}

}  // namespace

std::vector<double> local_mean(const std::vector<double>& time, std::vector<double> value, double window) {
    if (window <= 0.0 || time.size() < 3) {
        return value;
    }
    return mean_once(time, mean_once(time, value, 0.25 * window), 0.25 * window);
}

std::vector<double> local_slope(const std::vector<double>& time, const std::vector<double>& value, double window) {
    std::vector<double> slope(time.size(), 0.0);
    if (time.size() < 2) {
        return slope;
    }
    const Lines lines(time, value);
    Lines::Piece begin = 0;
    Lines::Piece end = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        const std::size_t last = time.size() - 1;
        const double before = time[i == 0 ? 0 : i - 1];
        const double after = time[std::min(i + 1, last)];
        const double from = std::max(time.front(), std::min(before, time[i] - 0.5 * window));
        const double to = std::min(time.back(), std::max(after, time[i] + 0.5 * window));
        slope[i] = (lines.value(to, end) - lines.value(from, begin)) / (to - from);
    }
    return slope;
}

}  // namespace tiretherm::physics
