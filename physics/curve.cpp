// SPDX-License-Identifier: BSD-3-Clause
// Values, slopes, exact integrals and means of quadratics, of quadratics held outside a range and of tables with linear
// interpolation; over very narrow intervals the mean of the last two is the average of the end values.

#include "physics/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tiretherm::physics {

Curve Curve::constant(double value) { return quadratic(value, 0.0, 0.0); }

Curve Curve::quadratic(double c0, double c1, double c2) {
    Curve curve;
    curve.c0_ = c0;
    curve.c1_ = c1;
    curve.c2_ = c2;
    return curve;
}

Curve Curve::quadratic_about(double origin, double a, double b, double c) {
    return quadratic(a - b * origin + c * origin * origin, b - 2.0 * c * origin, c);
}

Curve Curve::within(double low, double high) const {
    assert(!is_table_ && low < high);
    Curve curve = *this;
    curve.has_range_ = true;
    curve.low_ = low;
    curve.high_ = high;
    return curve;
}

std::optional<std::array<double, 2>> Curve::range() const {
    return has_range_ ? std::optional(std::array{low_, high_}) : std::nullopt;
}

Curve Curve::table(std::vector<double> x, std::vector<double> y) {
    assert(!x.empty() && x.size() == y.size());
    Curve curve;
    curve.is_table_ = true;
    curve.area_.push_back(0.0);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
        curve.area_.push_back(curve.area_.back() + 0.5 * (y[i] + y[i + 1]) * (x[i + 1] - x[i]));
    }
    curve.x_ = std::move(x);
    curve.y_ = std::move(y);
    return curve;
}

Curve Curve::scaled(double factor) const {
    if (!is_table_) {
        Curve curve = *this;
        curve.c0_ *= factor;
        curve.c1_ *= factor;
        curve.c2_ *= factor;
        return curve;
    }
    std::vector<double> y = y_;
    for (double& value : y) {
        value *= factor;
    }
    return table(x_, std::move(y));
}

Curve Curve::plus_line(double origin, double slope) const {
    if (!is_table_) {
        return plus_quadratic(origin, 0.0, slope, 0.0);
    }
    std::vector<double> y = y_;
    for (std::size_t i = 0; i < y.size(); ++i) {
        y[i] += slope * (x_[i] - origin);
    }
    return table(x_, std::move(y));
}

Curve Curve::plus_quadratic(double origin, double a, double b, double c) const {
    assert(!is_table_);
    const Curve more = quadratic_about(origin, a, b, c);
    Curve curve = *this;
    curve.c0_ += more.c0_;
    curve.c1_ += more.c1_;
    curve.c2_ += more.c2_;
    return curve;
}

double Curve::table_value(double x) const {
    if (x <= x_.front()) {
        return y_.front();
    }
    if (x >= x_.back()) {
        return y_.back();
    }
    const auto i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
    return y_[i] + (y_[i + 1] - y_[i]) * (x - x_[i]) / (x_[i + 1] - x_[i]);
}

double Curve::table_slope(double x) const {
    if (x < x_.front() || x >= x_.back()) {
        return 0.0;
    }
    const auto i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
    return (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
}

double Curve::table_integral(double x) const {
    const double before = y_.front() * x_.front();  // from 0 to x_[0], where the curve is held
    if (x <= x_.front()) {
        return y_.front() * x;
    }
    if (x >= x_.back()) {
        return before + area_.back() + y_.back() * (x - x_.back());
    }
    const auto i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
    return before + area_[i] + 0.5 * (y_[i] + table_value(x)) * (x - x_[i]);
}

/// From 0, in up to three pieces: held, the quadratic, held.
double Curve::held_integral(double x) const {
    const auto from_low = [this](double y) {
        const double inside = is_inside(y) ? y : held(y);
        return antiderivative(inside) - antiderivative(low_) + polynomial(inside) * (y - inside);
    };
    return from_low(x) - from_low(0.0);
}

Curve::Mean Curve::mean_of_pieces(double a, double b) const {
    const double width = b - a;
    // Below this width the difference of two integrals loses more digits than the midpoint rule's error.
    if (std::abs(width) < 1e-4 * (1.0 + std::abs(a))) {
        const double mean_slope = 0.5 * (slope(a) + slope(b));
        return {0.5 * (value(a) + value(b)), 0.5 * mean_slope, 0.5 * mean_slope};
    }
    const double mean = (integral(b) - integral(a)) / width;
    return {mean, (mean - value(a)) / width, (value(b) - mean) / width};
}

double Curve::minimum(double low, double high) const {
    double least = std::min(value(low), value(high));
    if (is_table_) {
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (x_[i] > low && x_[i] < high) {
                least = std::min(least, y_[i]);
            }
        }
    } else if (c2_ != 0.0) {
        if (const double vertex = -0.5 * c1_ / c2_; vertex > low && vertex < high && is_inside(vertex)) {
            least = std::min(least, value(vertex));
        }
    }
    return least;
}

}  // namespace tiretherm::physics
