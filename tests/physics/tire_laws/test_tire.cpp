// SPDX-License-Identifier: BSD-3-Clause
// Geometry, contact, radii, loss tangent and strain energy loss of the thesis's tire against independent evaluations.

#include "physics/tire.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tiretherm::physics {

namespace {

const Tire tire{};  // the 225/50 R17 of the thesis
const LossTangent law{};
constexpr double kelvin = 273.15;

double loss(double load, double kmh, double celsius) {
    const double V = kmh / 3.6;
    return strain_power(tire, V, load) * law.value(celsius + kelvin + law.shift(tire.revolutions(V, load)));
}

}  // namespace

TEST(Tire, BandIsTheThesisMass) {
    // rho 2 pi R0 W h = 1100 * 2 pi * 0.3308 * 0.225 * 0.012 = 6.173 kg (68)
    EXPECT_NEAR(tire.band_mass(), 6.173, 5e-4);
    EXPECT_NEAR(tire.outer_area(), 2.0 * std::numbers::pi * 0.3308 * 0.225, 1e-12);
}

TEST(Tire, SectionRatioIsBelowOneWithTheSidewallsCorrected) {
    // (0.225 * 0.012 + 2 * 0.009 * (0.1125 - 0.012)) / (0.225 * 0.1125) = 0.004509 / 0.0253125 (erratum E3)
    EXPECT_NEAR(tire.area_ratio(), 0.004509 / 0.0253125, 1e-12);
}

TEST(Tire, ContactLengthAt4kNIs97mm) {
    // 160 - 320 / (1 + e^1.4) = 96.7 mm (erratum E2)
    EXPECT_NEAR(tire.contact_length(4000.0), 0.0967, 5e-5);
    EXPECT_NEAR(tire.contact_length(0.0), 0.0, 1e-15);
}

TEST(Tire, RadiiFallWithLoad) {
    // 0.3308 - 4.2e-6 * 4000 and 0.3483 * 4000^-0.009 (erratum E5)
    EXPECT_NEAR(tire.loaded_radius(4000.0), 0.3140, 1e-12);
    EXPECT_NEAR(tire.rolling_radius(4000.0), 0.3232, 5e-5);
    EXPECT_TRUE(std::isfinite(tire.rolling_radius(0.0)));
}

TEST(Tire, ContactAreaIsNothingWithoutContactAndNeverTheWholeTire) {
    EXPECT_EQ(tire.contact_area(0.0), 0.0);
    EXPECT_EQ(tire.contact_area(tire.minimum_load), 0.0);
    EXPECT_NEAR(tire.contact_area(4000.0), 2.333e-6 * 4000.0, 1e-15);
    EXPECT_EQ(tire.contact_area(1e9), tire.outer_area());
}

TEST(Tire, MeasuredTableReplacesALaw) {
    Tire measured = tire;
    measured.contact_length_table = Curve::table({2000.0, 6000.0}, {0.07, 0.13});
    EXPECT_NEAR(measured.contact_length(4000.0), 0.10, 1e-15);
}

TEST(LossTangent, IsThatOfTheCompoundInKelvin) {
    // Erratum E1: at 100 km/h and 4000 N, shift included, 0.34 at 50 C and 0.23 at 80 C; unshifted 0.377 and 0.250.
    const double shift = law.shift(tire.revolutions(100.0 / 3.6, 4000.0));
    EXPECT_NEAR(shift, 7.1, 0.05);  // 13.68 Hz: C2 log10(f/f0) / (C1 - log10(f/f0)) = 101.6 * -0.580 / -8.28
    EXPECT_NEAR(law.value(323.15 + shift), 0.34, 0.005);
    EXPECT_NEAR(law.value(353.15 + shift), 0.23, 0.005);
    EXPECT_NEAR(law.value(323.15), 0.377, 5e-4);
    EXPECT_NEAR(law.value(353.15), 0.250, 5e-4);
}

TEST(LossTangent, FallsBy1Point37PercentPerKelvin) {
    // -2 (T_eq + 4989) / 882^2 at 328 K
    EXPECT_NEAR(law.log_slope(328.0), -2.0 * 5317.0 / (882.0 * 882.0), 1e-12);
    const double step = 0.01;
    EXPECT_NEAR(law.log_slope(328.0), std::log(law.value(328.0 + step) / law.value(328.0 - step)) / (2.0 * step), 1e-9);
}

// The Gaussian of the thesis rises below its characterisation, to b = -4989 K; rubber has a peak at -8 degC. At 0 degC and above
// the Gaussian stands; at the peak it is that of 269.15 K, 4 K above it; 30 K below the peak that of 30 K above.
TEST(LossTangent, PeaksAtMinusEightDegreesAndFallsInTheCold) {
    const LossTangent law;
    const LossTangent gaussian{.peak = 0.0};
    for (const double T : {273.15, 293.15, 353.15}) {
        EXPECT_EQ(law.value(T), gaussian.value(T)) << T;
        EXPECT_EQ(law.log_slope(T), gaussian.log_slope(T)) << T;
    }
    EXPECT_EQ(law.value(265.15), gaussian.value(269.15));
    EXPECT_EQ(law.log_slope(265.15), 0.0);
    EXPECT_NEAR(law.value(235.15), gaussian.value(295.15), 1e-12);
    EXPECT_GT(law.log_slope(235.15), 0.0);
    EXPECT_GT(gaussian.value(235.15), 1.5 * law.value(235.15));
    for (double T = 225.15; T < 300.0; T += 3.7) {
        const double difference = (std::log(law.value(T + 1e-3)) - std::log(law.value(T - 1e-3))) / 2e-3;
        EXPECT_NEAR(law.log_slope(T), difference, 1e-6) << T;
    }
    const LossTangent own_peak{.a = 0.6, .b = 280.0, .c = 40.0};
    EXPECT_NEAR(own_peak.value(250.0), 0.6 * std::exp(-0.5625), 1e-12) << "a Gaussian whose own peak lies above";
}

TEST(StrainEnergyLoss, EqualsTheComputedWatts) {
    // Independent evaluations of (36)-(49) with the errata, rounded to 1 W.
    EXPECT_NEAR(loss(4000.0, 100.0, 50.0), 1204.0, 1.0);
    EXPECT_NEAR(loss(7000.0, 100.0, 50.0), 2664.0, 1.0);
    EXPECT_NEAR(loss(7500.0, 150.0, 50.0), 4605.0, 1.0);
    EXPECT_NEAR(loss(4000.0, 100.0, 80.0), 798.0, 1.0);
    EXPECT_NEAR(loss(7000.0, 100.0, 80.0), 1766.0, 1.0);
    EXPECT_NEAR(loss(7500.0, 150.0, 80.0), 3052.0, 1.0);
    EXPECT_NEAR(loss(4000.0, 100.0, 20.0), 1813.0, 1.0);
}

TEST(StrainEnergyLoss, MakesARollingResistanceOfOnePercent) {
    // 1204 W / (27.78 m/s * 4000 N) = 1.08 %
    EXPECT_NEAR(loss(4000.0, 100.0, 50.0) / (100.0 / 3.6 * 4000.0), 0.0108, 5e-5);
}

TEST(StrainEnergyLoss, IsNothingAtRestAndWithoutLoad) {
    EXPECT_EQ(strain_power(tire, 0.0, 4000.0), 0.0);
    EXPECT_EQ(strain_power(tire, standing_speed, 4000.0), 0.0);
    EXPECT_EQ(strain_power(tire, 30.0, 0.0), 0.0);
    EXPECT_EQ(strain_power(tire, 30.0, 1.0), 0.0);
    EXPECT_EQ(strain_power(tire, -30.0, 4000.0), strain_power(tire, 30.0, 4000.0));
}

}  // namespace tiretherm::physics
