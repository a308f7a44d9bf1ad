// SPDX-License-Identifier: BSD-3-Clause
// Rolling resistance moment and force, drum correction, air correction and coastdown law against hand calculation.

#include "physics/tire_laws/rolling_resistance.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace tiretherm::physics {

namespace {

const Tire thesis_tire{};  // the 225/50 R17 of the thesis
constexpr double flat = 0.0;

}  // namespace

TEST(RollingResistance, MomentAndDragCarryTheDissipatedPower) {
    // 1204 W at 100 km/h and 4000 N: M = 1204 * 0.3232 / 27.778 = 14.01 N m (50), F = 14.01 / 0.3140 = 44.6 N (51).
    // Three figures of R_R are quoted, hence 0.02 N m and 0.06 N.
    const double speed = 100.0 / 3.6;
    EXPECT_NEAR(rolling_moment(thesis_tire, 1204.0, speed, 4000.0), 14.01, 0.02);
    EXPECT_NEAR(rolling_drag(thesis_tire, 1204.0, speed, 4000.0), 44.6, 0.06);
    // M omega = E with omega = V / R_R, to round-off
    const double omega = speed / thesis_tire.rolling_radius(4000.0);
    EXPECT_NEAR(rolling_moment(thesis_tire, 1204.0, speed, 4000.0) * omega, 1204.0, 1e-10);
}

TEST(RollingResistance, BackwardsIsAsHardAsForwards) {
    EXPECT_EQ(rolling_drag(thesis_tire, 500.0, -20.0, 4000.0), rolling_drag(thesis_tire, 500.0, 20.0, 4000.0));
}

TEST(RollingResistance, IsNothingAtRestAndWithoutContact) {
    EXPECT_EQ(rolling_moment(thesis_tire, 1000.0, 0.0, 4000.0), 0.0);
    EXPECT_EQ(rolling_drag(thesis_tire, 1000.0, standing_speed, 4000.0), 0.0);
    EXPECT_EQ(rolling_drag(thesis_tire, 1000.0, 20.0, 0.0), 0.0);
}

TEST(Drum, FlatRoadIsTheLimitOfALargeDrum) {
    // Radius 0.854 m (1.707 m drum) and tire radius 0.3308 m: sqrt(0.854 / 1.1848) = 0.84900
    EXPECT_NEAR(to_drum(100.0, 1.0 / 0.854, flat, 0.3308), 84.900, 5e-3);
    // A drum of 1e6 m is flat up to r / 2R = 1.7e-7.
    EXPECT_NEAR(to_drum(100.0, 1.0 / 0.854, 1e-6, 0.3308) / to_drum(100.0, 1.0 / 0.854, flat, 0.3308), 1.0, 2e-7);
}

TEST(Drum, IsTheFormulaOfTheStandard) {
    // sqrt((R1/R2) (R2 + r)/(R1 + r)) from 1.7 m to 2.0 m diameter: sqrt(0.85 * 1.3 / 1.15) = sqrt(0.960870) = 0.980240
    EXPECT_NEAR(to_drum(1.0, 1.0 / 0.85, 1.0, 0.30), std::sqrt(0.85 / 1.0 * 1.30 / 1.15), 1e-15);
    EXPECT_NEAR(to_drum(1.0, 1.0 / 0.85, 1.0, 0.30), 0.980240, 5e-7);
}

TEST(Drum, ThereAndBackIsTheMeasurement) {
    EXPECT_NEAR(to_drum(to_drum(40.0, 1.2, flat, 0.33), flat, 1.2, 0.33), 40.0, 1e-13);
    EXPECT_NEAR(to_drum(40.0, 1.0, 1.0, 0.33), 40.0, 1e-14);
}

TEST(AirCorrection, TenKelvinColderAreEightPercent) {
    // A tire measured in 15 degC air rolls harder than at 25 degC: 1 - 0.008 * 10 = 0.92
    EXPECT_NEAR(AirCorrection{}.to_reference(50.0, 288.15), 46.0, 1e-12);
    EXPECT_EQ(AirCorrection{}.to_reference(50.0, 298.15), 50.0);
}

TEST(CoastdownLaw, IsTheProductOfPowersAndAParabola) {
    // 100^-0.5 * 4000^1 * (0.1 + 1e-4 * 100 + 1e-6 * 1e4) = 0.1 * 4000 * 0.12 = 48 N
    const CoastdownLaw law{
        .pressure_exponent = -0.5, .load_exponent = 1.0, .constant = 0.1, .linear = 1e-4, .quadratic = 1e-6};
    EXPECT_NEAR(law.force(100.0, 4000.0, 100.0), 48.0, 1e-12);
    // Four times the pressure halves it, twice the load doubles it.
    EXPECT_NEAR(law.force(400.0, 4000.0, 100.0), 24.0, 1e-12);
    EXPECT_NEAR(law.force(100.0, 8000.0, 100.0), 96.0, 1e-12);
}

}  // namespace tiretherm::physics
