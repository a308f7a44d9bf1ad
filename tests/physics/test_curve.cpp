// SPDX-License-Identifier: BSD-3-Clause
// Quadratic and tabulated laws: values, integrals, means and their derivatives against hand calculation and
// differences.

#include "physics/curve.hpp"

#include <gtest/gtest.h>

namespace tiretherm::physics {

namespace {

// K1 of the thesis through 0.29 at 20 C and 0.95 at 90 C, with a bend added so that all three coefficients matter.
const Curve bent = Curve::quadratic_about(293.15, 0.29, 0.00943, 2e-5);
const Curve steps = Curve::table({290.0, 300.0, 330.0}, {1.0, 3.0, 2.0});

}  // namespace

TEST(Curve, QuadraticAboutAnOriginHasItsValueThere) {
    EXPECT_NEAR(bent.value(293.15), 0.29, 1e-12);
    EXPECT_NEAR(bent.value(363.15), 0.29 + 0.00943 * 70.0 + 2e-5 * 4900.0, 1e-12);
    EXPECT_NEAR(bent.slope(363.15), 0.00943 + 2.0 * 2e-5 * 70.0, 1e-12);
}

TEST(Curve, TableIsStraightBetweenPointsAndHeldBeyond) {
    EXPECT_DOUBLE_EQ(steps.value(280.0), 1.0);
    EXPECT_DOUBLE_EQ(steps.value(295.0), 2.0);
    EXPECT_DOUBLE_EQ(steps.value(315.0), 2.5);
    EXPECT_DOUBLE_EQ(steps.value(400.0), 2.0);
    EXPECT_DOUBLE_EQ(steps.slope(295.0), 0.2);
    EXPECT_DOUBLE_EQ(steps.slope(280.0), 0.0);
}

TEST(Curve, IntegralOfATableIsTheAreaUnderIt) {
    // 290 -> 300: 20; 300 -> 330: 75; held at 2 for ten more: 20.
    EXPECT_NEAR(steps.integral(340.0) - steps.integral(290.0), 115.0, 1e-10);
    // Held at 1 before the first point.
    EXPECT_NEAR(steps.integral(290.0) - steps.integral(280.0), 10.0, 1e-10);
    // 295 -> 315 by trapezoids: (2 + 3)/2 * 5 + (3 + 2.5)/2 * 15 = 12.5 + 41.25.
    EXPECT_NEAR(steps.integral(315.0) - steps.integral(295.0), 53.75, 1e-10);
}

TEST(Curve, MeanIsTheIntegralOverTheWidth) {
    for (const Curve& curve : {bent, steps}) {
        for (const double b : {293.0, 301.5, 329.0, 371.0}) {
            const double a = 288.0;
            EXPECT_NEAR(curve.mean(a, b).value, (curve.integral(b) - curve.integral(a)) / (b - a), 1e-11);
            EXPECT_NEAR(curve.mean(a, b).value, curve.mean(b, a).value, 1e-12);
        }
        EXPECT_NEAR(curve.mean(310.0, 310.0).value, curve.value(310.0), 1e-12);
    }
}

TEST(Curve, DerivativesOfTheMeanAreThoseOfADifference) {
    constexpr double step = 1e-3;  // central difference: error of order step^2 times the third derivative, nothing
    for (const Curve& curve : {bent, steps}) {
        const double a = 296.0;
        const double b = 321.0;
        const Curve::Mean mean = curve.mean(a, b);
        EXPECT_NEAR(mean.slope_a, (curve.mean(a + step, b).value - curve.mean(a - step, b).value) / (2.0 * step), 1e-8);
        EXPECT_NEAR(mean.slope_b, (curve.mean(a, b + step).value - curve.mean(a, b - step).value) / (2.0 * step), 1e-8);
    }
}

// 0.29 at 20 C and 0.95 at 90 C: at -40 C the line is -0.276, held at 20 C it is 0.29; at 200 C it keeps what it has at 120 C,
// 0.29 + 100 0.66/70 = 1.232857.
TEST(Curve, IsHeldOutsideItsRange) {
    const Curve line = Curve::quadratic_about(293.15, 0.29, 0.66 / 70.0, 0.0);
    const Curve held = line.within(293.15, 393.15);
    EXPECT_FALSE(line.range());
    ASSERT_TRUE(held.range());
    EXPECT_EQ((*held.range())[1], 393.15);
    EXPECT_LT(line.value(233.15), 0.0);
    EXPECT_NEAR(held.value(233.15), 0.29, 1e-12);
    EXPECT_NEAR(held.value(473.15), 1.232857, 1e-6);
    EXPECT_EQ(held.value(363.15), line.value(363.15));
    EXPECT_EQ(held.slope(233.15), 0.0);
    EXPECT_EQ(held.slope(473.15), 0.0);
    EXPECT_EQ(held.slope(300.0), line.slope(300.0));
    EXPECT_NEAR(held.minimum(233.15, 473.15), 0.29, 1e-12);
    EXPECT_FALSE(held == line);
    EXPECT_TRUE(held.scaled(2.0).range());
    EXPECT_NEAR(held.scaled(2.0).value(233.15), 0.58, 1e-12);
    EXPECT_NEAR(held.plus_line(293.15, 0.01).value(473.15), 2.232857, 1e-6);
    // 60 K at 0.29, 100 K on the line with a mean of 0.7614286, 80 K at 1.2328571.
    EXPECT_NEAR(held.integral(473.15) - held.integral(233.15), 17.4 + 76.14286 + 98.628571, 1e-5);
    EXPECT_NEAR(held.integral(233.15), 0.29 * 233.15, 1e-10);
    EXPECT_NEAR(held.mean(233.15, 473.15).value, 192.171429 / 240.0, 1e-7);
    constexpr double step = 1e-3;
    for (const double a : {240.0, 300.0, 420.0}) {
        const double b = 460.0;
        const Curve::Mean mean = held.mean(a, b);
        EXPECT_NEAR(mean.slope_a, (held.mean(a + step, b).value - held.mean(a - step, b).value) / (2.0 * step), 1e-8)
            << a;
        EXPECT_NEAR(mean.slope_b, (held.mean(a, b + step).value - held.mean(a, b - step).value) / (2.0 * step), 1e-8)
            << a;
    }
}

TEST(Curve, MinimumLooksInsideTheRange) {
    EXPECT_DOUBLE_EQ(steps.minimum(285.0, 400.0), 1.0);
    EXPECT_DOUBLE_EQ(steps.minimum(301.0, 400.0), 2.0);
    // Vertex at x = 2 with the value -1.
    EXPECT_NEAR(Curve::quadratic(3.0, -4.0, 1.0).minimum(0.0, 5.0), -1.0, 1e-15);
    EXPECT_NEAR(Curve::quadratic(3.0, -4.0, 1.0).minimum(3.0, 5.0), 0.0, 1e-15);
}

TEST(Curve, TakesAFactorAndALine) {
    for (const double x : {290.0, 296.0, 315.0, 330.0}) {
        EXPECT_NEAR(bent.scaled(1.5).value(x), 1.5 * bent.value(x), 1e-12);
        EXPECT_NEAR(steps.scaled(1.5).value(x), 1.5 * steps.value(x), 1e-12);
        EXPECT_NEAR(bent.plus_line(300.0, 0.02).value(x), bent.value(x) + 0.02 * (x - 300.0), 1e-12);
        EXPECT_NEAR(steps.plus_line(300.0, 0.02).value(x), steps.value(x) + 0.02 * (x - 300.0), 1e-12);
    }
    // A table stays held beyond its ends: at 290 it became 1 - 0.2.
    EXPECT_NEAR(steps.plus_line(300.0, 0.02).value(250.0), 0.8, 1e-12);
    EXPECT_EQ(bent.scaled(1.0), bent);
    EXPECT_EQ(steps.plus_line(300.0, 0.0), steps);
}

TEST(Curve, KnowsWhenItIsConstant) {
    EXPECT_TRUE(Curve::constant(1800.0).is_constant());
    EXPECT_FALSE(bent.is_constant());
    EXPECT_FALSE(steps.is_constant());
}

}  // namespace tiretherm::physics
