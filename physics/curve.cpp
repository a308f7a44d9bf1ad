// SPDX-License-Identifier: BSD-3-Clause
// Values, slopes, exact integrals and means of quadratics and of tables with linear interpolation; over very narrow
// intervals a table's mean is the average of its end values.

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
        return quadratic(factor * c0_, factor * c1_, factor * c2_);
    }
    std::vector<double> y = y_;
    for (double& value : y) {
        value *= factor;
    }
    return table(x_, std::move(y));
}

Curve Curve::plus_line(double origin, double slope) const {
    if (!is_table_) {
        return quadratic(c0_ - slope * origin, c1_ + slope, c2_);
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
    return quadratic(c0_ + more.c0_, c1_ + more.c1_, c2_ + more.c2_);
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

Curve::Mean Curve::table_mean(double a, double b) const {
    const double width = b - a;
    // Below this width the difference of two integrals loses more digits than the midpoint rule's error.
    if (std::abs(width) < 1e-4 * (1.0 + std::abs(a))) {
        const double slope = 0.5 * (table_slope(a) + table_slope(b));
        return {0.5 * (table_value(a) + table_value(b)), 0.5 * slope, 0.5 * slope};
    }
    const double mean = (table_integral(b) - table_integral(a)) / width;
    return {mean, (mean - table_value(a)) / width, (table_value(b) - mean) / width};
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
        if (const double vertex = -0.5 * c1_ / c2_; vertex > low && vertex < high) {
            least = std::min(least, value(vertex));
        }
    }
    return least;
}

}  // namespace tiretherm::physics
