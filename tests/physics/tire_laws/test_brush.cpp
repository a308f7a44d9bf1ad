// SPDX-License-Identifier: BSD-3-Clause
// Brush model: slopes, saturation, and the balance of sliding, stored and total power, against closed forms of the
// thesis.

#include "physics/tire_laws/brush.hpp"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "physics/tire_laws/cornering_stiffness.hpp"

namespace tiretherm::physics {

namespace {

/// a = 50 mm, c_p = 20 MPa, mu Fz = 4000 N: C = 2 * 20e6 * 0.0025 = 1e5 N/rad, sigma_sl = 3 * 4000 / 1e5 = 0.12.
constexpr Brush brush{.half_length = 0.05, .tread_stiffness = 20e6, .friction = 1.0, .load = 4000.0};
constexpr double speed = 30.0;

double sum_of_strips(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

TEST(Brush, InitialSlopesAreThoseOfTheThesis) {
    // (3): 2 c_p a^2 and (2/3) c_p a^3. One-sided differences of 1e-9 are off by sigma / sigma_sl and 3 times it.
    EXPECT_NEAR(brush.stiffness(), 1e5, 1e-9);
    EXPECT_NEAR(brush.force(1e-9) / 1e-9 / 1e5, 1.0, 1e-8);
    EXPECT_NEAR(-brush.aligning_moment(1e-9) / 1e-9 / (2.0 / 3.0 * 20e6 * 0.05 * 0.05 * 0.05), 1.0, 3e-8);
    // A wholly adhering contact keeps both slopes: (2).
    Brush glued = brush;
    glued.friction = std::numeric_limits<double>::infinity();
    EXPECT_NEAR(glued.force(0.5), 0.5e5, 1e-9);
    EXPECT_EQ(glued.adhesion_end(0.5), -0.05);
}

TEST(Brush, HalfTheSlidingSlipGivesSevenEighthsOfTheFriction) {
    // u = 1/2: F = mu Fz (1 - 1/8) = 3500 N; M = -4000 * 0.05 * 0.5 / 8 = -12.5 N m; adhesion ends at x = 0, where the
    // deflection 0.06 * 0.05 = 3 mm meets mu q / c_p = 3 * 4000 / 0.2 / 20e6 = 3 mm.
    EXPECT_NEAR(brush.full_sliding_slip(), 0.12, 1e-15);
    EXPECT_NEAR(brush.force(0.06), 3500.0, 1e-9);
    EXPECT_NEAR(brush.aligning_moment(0.06), -12.5, 1e-12);
    EXPECT_NEAR(brush.adhesion_end(0.06), 0.0, 1e-15);
}

TEST(Brush, SaturatesAtTheFriction) {
    for (const double slip : {0.12, 0.2, 5.0}) {
        EXPECT_EQ(brush.force(slip), 4000.0);
        EXPECT_EQ(brush.aligning_moment(slip), 0.0);
        EXPECT_EQ(brush.adhesion_end(slip), 0.05);
    }
    // It arrives there with neither a jump nor a kink: 1 - F/(mu Fz) = (1 - u)^3 = 1e-12 at u = 0.9999
    EXPECT_NEAR(brush.force(0.12 * 0.9999) / 4000.0, 1.0, 2e-12);
}

TEST(Brush, IsAntisymmetricAndGrowsWithSlip) {
    double last = 0.0;
    for (double slip = 0.005; slip < 0.12; slip += 0.005) {
        EXPECT_EQ(brush.force(-slip), -brush.force(slip));
        EXPECT_EQ(brush.aligning_moment(-slip), -brush.aligning_moment(slip));
        EXPECT_GT(brush.force(slip), last);
        last = brush.force(slip);
    }
    EXPECT_EQ(brush.force(0.0), 0.0);
}

TEST(Brush, IsNothingWithoutLoadOrFriction) {
    for (const Brush& slippery : {Brush{.half_length = 0.05, .tread_stiffness = 20e6, .friction = 0.0, .load = 4000.0},
                                  Brush{.half_length = 0.05, .tread_stiffness = 20e6, .friction = 1.0, .load = 0.0}}) {
        for (const double slip : {0.0, 0.05}) {
            EXPECT_EQ(slippery.force(slip), 0.0);
            EXPECT_EQ(slippery.aligning_moment(slip), 0.0);
            EXPECT_EQ(slippery.sliding_power(slip, speed), 0.0);
        }
    }
}

TEST(Brush, PowerTakenUpIsSlidingAndReleasedPower) {
    // Over a time dt a bristle's root moves sigma V dt across the road and V dt along the contact. The force on it
    // takes up c_p v sigma V per length; of that c_p v dv/dt stays in the bristle and the rest is friction. Summed over
    // the contact, with v = 0 where it enters: F V sigma = sliding + V c_p v(-a)^2 / 2. Round-off of a sum of two terms.
    for (const double slip : {1e-4, 0.01, 0.06, 0.119, 0.12, 0.3, -0.05}) {
        const double taken_up = brush.force(slip) * speed * slip;
        EXPECT_NEAR((brush.sliding_power(slip, speed) + brush.released_power(slip, speed)) / taken_up, 1.0, 1e-12);
        EXPECT_EQ(brush.released_power(slip, speed), 0.0);
    }
    Brush glued = brush;
    glued.friction = std::numeric_limits<double>::infinity();
    EXPECT_EQ(glued.sliding_power(0.06, speed), 0.0);
    EXPECT_NEAR(glued.released_power(0.06, speed) / (glued.force(0.06) * speed * 0.06), 1.0, 1e-15);
}

TEST(Brush, WhatAdhesionTakesUpIsStoredUntilBristlesSlide) {
    // At u = 1/2 the front half adheres with c_p sigma a^2 / 2 = 20e6 * 0.06 * 0.0025 / 2 = 1500 N, times sigma V
    // = 1.8 m/s: 2700 W, which is V c_p v^2 / 2 = 30 * 20e6 * (3 mm)^2 / 2. F V sigma = 3500 * 1.8 = 6300 W.
    EXPECT_NEAR(brush.stored_power(0.06, speed), 2700.0, 1e-9);
    EXPECT_NEAR(brush.sliding_power(0.06, speed), 6300.0, 1e-9);
    EXPECT_EQ(brush.stored_power(0.12, speed), 0.0);
}

TEST(Brush, SlicesSumUpToTheSlidingPower) {
    for (const double slip : {0.003, 0.06, 0.11, 0.4}) {
        for (const std::size_t slices : {1U, 2U, 7U, 100U}) {
            const double total = brush.sliding_power(slip, speed);
            EXPECT_NEAR(sum_of_strips(brush.sliding_power_slices(slip, speed, slices)) / total, 1.0, 1e-13) << slip;
        }
    }
    EXPECT_TRUE(brush.sliding_power_slices(0.06, speed, 0).empty());
}

TEST(Brush, SlidesInTheRearOnly) {
    // At u = 1/2 adhesion ends in the middle: the two slices in front have none of the 6300 W.
    const std::vector<double> power = brush.sliding_power_slices(0.06, speed, 4);
    EXPECT_EQ(power[0], 0.0);
    EXPECT_EQ(power[1], 0.0);
    EXPECT_GT(power[2], 0.0);
    // By hand, x from -a/2 to 0: sigma mu * Fz * 11/32 = 82.5 J/m; mu^2 (q(0)^2 - q(-a/2)^2) / (2 c_p)
    // = 6e4^2 (1 - 9/16) / 4e7 = 39.375 J/m; times 30 m/s = 3656.25 W. The rest: 6300 - 3656.25 W
    EXPECT_NEAR(power[2], 3656.25, 1e-9);
    EXPECT_NEAR(power[3], 2643.75, 1e-9);
}

TEST(Brush, FullSlidingHeatsEverySliceWithoutASign) {
    // Beyond sigma_sl every tip slides; far beyond, the power follows the pressure: symmetric up to sigma_sl / sigma.
    const std::vector<double> power = brush.sliding_power_slices(-1200.0, -speed, 6);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_GT(power[i], 0.0);
        EXPECT_NEAR(power[i] / power[5 - i], 1.0, 4e-4);  // 2 * 0.12 / 1200, doubled
    }
    EXPECT_EQ(brush.sliding_power(0.06, 0.0), 0.0);
}

TEST(Brush, TakesItsStiffnessFromTheTire) {
    // C = 2 c_p a^2 with 2 a = l, so the brush of a tire has its cornering stiffness.
    const Tire tire{};
    const double CP = cornering_stiffness({}, tire, 4000.0, 343.15).value;
    const double l = tire.contact_length(4000.0);
    const Brush own{
        .half_length = 0.5 * l, .tread_stiffness = Brush::tread_stiffness_of(CP, l), .friction = 1.0, .load = 4000.0};
    EXPECT_NEAR(own.stiffness() / CP, 1.0, 1e-15);
}

TEST(Brush, ABrakedTireTakesUpForceTimesSlipSpeed) {
    // kappa = -0.05 at 30 m/s: sigma = -0.05 / 0.95, rolling speed 28.5 m/s; sigma V_r = kappa V_x = -1.5 m/s
    const double sigma = Brush::of_slip_ratio(-0.05);
    EXPECT_NEAR(brush.sliding_power(sigma, 0.95 * 30.0), -1.5 * brush.force(sigma), 1e-9);
}

}  // namespace tiretherm::physics
