// SPDX-License-Identifier: BSD-3-Clause
// Law of one variable: c0 + c1 x + c2 x^2 (thesis (34)) or a table. Its mean over two temperatures makes the steady
// flux exact (Kirchhoff's transform).
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tiretherm::physics {

/// A law of one variable: a quadratic c0 + c1 x + c2 x^2 (thesis (34)), or a table joined by straight lines and held
/// constant beyond its ends. A quadratic may have a range, beyond which it is held as well. Used for k(T), c(T) with x in kelvin, and for tire laws with x the vertical load in N.
class Curve {
public:
    Curve() = default;
    [[nodiscard]] static Curve constant(double value);
    [[nodiscard]] static Curve quadratic(double c0, double c1, double c2);
    /// The quadratic a + b (x - origin) + c (x - origin)^2, for laws written in degrees Celsius.
    [[nodiscard]] static Curve quadratic_about(double origin, double a, double b, double c);
    /// @param x ascending, at least one  @param y as many
    [[nodiscard]] static Curve table(std::vector<double> x, std::vector<double> y);

    /// The same quadratic, held at its end values outside [low, high]; outside a table's ends it is held already.
    /// @pre it is no table, low < high
    [[nodiscard]] Curve within(double low, double high) const;
    /// Where a quadratic that is held elsewhere holds; none for one without a range and for a table.
    [[nodiscard]] std::optional<std::array<double, 2>> range() const;

    [[nodiscard]] double value(double x) const {
        return is_table_ ? table_value(x) : is_inside(x) ? polynomial(x) : polynomial(held(x));
    }
    [[nodiscard]] double slope(double x) const {
        return is_table_ ? table_slope(x) : is_inside(x) ? c1_ + 2.0 * c2_ * x : 0.0;
    }

    /// Integral from the origin 0 to x, exact for both kinds.
    [[nodiscard]] double integral(double x) const {
        return is_table_ ? table_integral(x) : has_range_ ? held_integral(x) : antiderivative(x);
    }

    /// Mean over [a, b], and its derivative with respect to a. Between two cells of one material this is the
    /// conductivity that makes the steady flux exact (Kirchhoff's transform).
    struct Mean {
        double value;
        double slope_a;
        double slope_b;
    };
    [[nodiscard]] Mean mean(double a, double b) const {
        if (is_table_ || !is_inside(a) || !is_inside(b)) {
            return mean_of_pieces(a, b);
        }
        return {c0_ + 0.5 * c1_ * (a + b) + c2_ / 3.0 * (a * a + a * b + b * b), 0.5 * c1_ + c2_ / 3.0 * (2.0 * a + b),
                0.5 * c1_ + c2_ / 3.0 * (a + 2.0 * b)};
    }

    /// The law times a factor.
    [[nodiscard]] Curve scaled(double factor) const;
    /// The law plus slope (x - origin); of a table at its points, held beyond its ends as before.
    [[nodiscard]] Curve plus_line(double origin, double slope) const;

    /// The law, which is no table, plus a quadratic about an origin: a + b (x - origin) + c (x - origin)^2.
    [[nodiscard]] Curve plus_quadratic(double origin, double a, double b, double c) const;

    [[nodiscard]] bool is_constant() const { return !is_table_ && c1_ == 0.0 && c2_ == 0.0; }
    [[nodiscard]] bool is_table() const { return is_table_; }
    /// Whether the quadratic itself holds from low to high.
    [[nodiscard]] bool is_quadratic_between(double low, double high) const {
        return !is_table_ && is_inside(low) && is_inside(high);
    }
    /// Whether it holds at any temperature.
    [[nodiscard]] bool is_quadratic() const { return !is_table_ && !has_range_; }
    /// Of a quadratic: c0, c1, c2.
    [[nodiscard]] std::array<double, 3> coefficients() const { return {c0_, c1_, c2_}; }
    /// Of a table: its points.
    [[nodiscard]] std::span<const double> table_x() const { return x_; }
    [[nodiscard]] std::span<const double> table_y() const { return y_; }
    /// Smallest value on [low, high].
    [[nodiscard]] double minimum(double low, double high) const;

    /// Calls take(member) for all that a law is made of: does not compile where one is forgotten.
    template <typename Take>
    void visit_members(const Take& take) const {
        const auto& [is_table, has_range, low, high, c0, c1, c2, x, y, area] = *this;
        (take(is_table), take(has_range), take(low), take(high), take(c0), take(c1), take(c2), take(x), take(y),
         take(area));
    }
    friend bool operator==(const Curve&, const Curve&) = default;

private:
    [[nodiscard]] bool is_inside(double x) const { return x >= low_ && x <= high_; }
    [[nodiscard]] double held(double x) const { return x < low_ ? low_ : high_; }
    [[nodiscard]] double polynomial(double x) const { return c0_ + x * (c1_ + x * c2_); }
    [[nodiscard]] double antiderivative(double x) const { return x * (c0_ + x * (0.5 * c1_ + x * c2_ / 3.0)); }
    [[nodiscard]] double held_integral(double x) const;
    [[nodiscard]] double table_value(double x) const;
    [[nodiscard]] double table_slope(double x) const;
    [[nodiscard]] double table_integral(double x) const;
    [[nodiscard]] Mean mean_of_pieces(double a, double b) const;

    bool is_table_ = false;
    bool has_range_ = false;
    double low_ = -std::numeric_limits<double>::infinity();
    double high_ = std::numeric_limits<double>::infinity();
    double c0_ = 0.0;
    double c1_ = 0.0;
    double c2_ = 0.0;
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<double> area_;  ///< integral from x_[0] to x_[i]
};

}  // namespace tiretherm::physics
