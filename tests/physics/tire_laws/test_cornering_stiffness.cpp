// SPDX-License-Identifier: BSD-3-Clause
// Cornering stiffness from load and temperature against hand calculation, limits and a central difference.

#include "physics/tire_laws/cornering_stiffness.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace tiretherm::physics {

namespace {

const Tire tire{};
const EquivalentModulus modulus{};
constexpr double kelvin = 273.15;

double stiffness(double load, double celsius) {
    return cornering_stiffness(modulus, tire, load, celsius + kelvin).value;
}

}  // namespace

TEST(CorneringStiffness, DefaultIs30TimesTheLoadAt70Degrees) {
    // By hand at 4000 N: l = 96.699 mm; E_l = 20e6 + 310e6 / (1 + e^(-54 (0.05 - 0.096699))) = 20e6 + 310e6 / 13.4502
    // = 43.048 MPa; a = 11.6183 / 300 and x = 70 + 8 = 78 K: E_T = 603e6 - 565e6 (1 - e^-3.02075) = 65.552 MPa;
    // E_eq = 43.048 * 65.552 / 108.600 = 25.984 MPa; CP = 25.984e6 * 4.67533e-3 = 1.21485e5 N/rad
    EXPECT_NEAR(stiffness(4000.0, 70.0), 1.21485e5, 5.0);
}

TEST(CorneringStiffness, FifteenKelvinAreATenth) {
    // Assumption of the defaults, after the thesis's two procedures 15 K apart and about 10 % apart.
    EXPECT_NEAR(stiffness(4000.0, 62.5) / stiffness(4000.0, 77.5), 1.10, 0.01);
}

TEST(CorneringStiffness, FollowsTheLoadLikeAMagicFormula) {
    // sin(2 atan(Fz / 8 kN)), scaled to 4 kN; the fit of the defaults is good to 8 % from 2 to 7 kN.
    const auto formula = [](double load) { return std::sin(2.0 * std::atan(load / 8000.0)); };
    for (double load = 2000.0; load <= 7000.0; load += 500.0) {
        const double wanted = formula(load) / formula(4000.0);
        EXPECT_NEAR(stiffness(load, 70.0) / stiffness(4000.0, 70.0) / wanted, 1.0, 0.08) << load;
    }
}

TEST(CorneringStiffness, FallsWithTemperatureAndRisesWithLoad) {
    for (double celsius = -40.0; celsius < 120.0; celsius += 10.0) {
        EXPECT_GT(stiffness(4000.0, celsius), stiffness(4000.0, celsius + 10.0)) << celsius;
    }
    for (double load = 100.0; load < 9000.0; load += 100.0) {
        EXPECT_GT(stiffness(load + 100.0, 70.0), stiffness(load, 70.0)) << load;
    }
}

TEST(CorneringStiffness, ScalesWithTheFourModuli) {
    // CP is of the first degree in them, so that one factor fits the defaults to a measured stiffness.
    EquivalentModulus softer = modulus;
    for (double* value : {&softer.E_max, &softer.dE, &softer.E_mid, &softer.dE_T}) {
        *value *= 0.58;
    }
    for (const double load : {1000.0, 4000.0, 7000.0}) {
        const double scaled = cornering_stiffness(softer, tire, load, 330.0).value;
        EXPECT_NEAR(scaled / cornering_stiffness(modulus, tire, load, 330.0).value, 0.58, 1e-14);
    }
}

TEST(CorneringStiffness, IsNothingWithoutContact) {
    EXPECT_EQ(stiffness(0.0, 70.0), 0.0);
    EXPECT_EQ(cornering_stiffness(modulus, tire, 0.0, 300.0).by_temperature, 0.0);
}

TEST(CorneringStiffness, SlopeIsTheDerivative) {
    // Central difference of 0.01 K: error (a h)^2 / 6 = 3e-8 of the slope and round-off 1e-16 CP / (h dCP/dT) = 2e-12.
    const double h = 0.01;
    for (const double celsius : {-30.0, 20.0, 70.0, 110.0}) {
        const double slope = cornering_stiffness(modulus, tire, 4000.0, celsius + kelvin).by_temperature;
        const double difference = (stiffness(4000.0, celsius + h) - stiffness(4000.0, celsius - h)) / (2.0 * h);
        EXPECT_NEAR(slope / difference, 1.0, 1e-6) << celsius;
    }
}

TEST(EquivalentModulus, OfTheBeltRunsFromMaximumToMaximumLessDelta) {
    // Erratum E12; at l_t half of dE is gone. Over 54 * 0.5 the logistic is within e^-27 = 2e-12 of its limits.
    EXPECT_NEAR(modulus.belt(-0.45) / modulus.E_max, 1.0, 1e-11);
    EXPECT_NEAR(modulus.belt(0.55) / (modulus.E_max - modulus.dE), 1.0, 1e-10);
    EXPECT_DOUBLE_EQ(modulus.belt(modulus.l_t), modulus.E_max - 0.5 * modulus.dE);
}

TEST(EquivalentModulus, OfTheTreadHasGonePartOfItsWayAtHalfTheTransition) {
    // Erratum E17: at |x| = dT/2, exp(-a |x|) = 0.003, so s = -+0.997.
    const double half = 0.5 * modulus.dE_T * 0.997;
    EXPECT_NEAR(modulus.tread(modulus.T_g + 0.5 * modulus.dT).value, modulus.E_mid - half, 1e-4);
    EXPECT_NEAR(modulus.tread(modulus.T_g - 0.5 * modulus.dT).value, modulus.E_mid + half, 1e-4);
    EXPECT_DOUBLE_EQ(modulus.tread(modulus.T_g).value, modulus.E_mid);
}

TEST(EquivalentModulus, IsSofterThanEitherSpring) {
    const double E_eq = modulus.value(0.1, 343.15).value;
    EXPECT_LT(E_eq, modulus.belt(0.1));
    EXPECT_LT(E_eq, modulus.tread(343.15).value);
    EXPECT_NEAR(1.0 / E_eq, 1.0 / modulus.belt(0.1) + 1.0 / modulus.tread(343.15).value, 1e-22);
}

TEST(BulkTemperatureFactor, ReplacesTheStiffnessAndKeepsItsSign) {
    // Erratum E13: lambda K_ref = CP, with the sign of K_ref.
    EXPECT_NEAR(bulk_temperature_factor(1.2e5, -9.6e4) * -9.6e4, -1.2e5, 1e-10);
    EXPECT_NEAR(bulk_temperature_factor(1.2e5, 9.6e4), 1.25, 1e-15);
    EXPECT_EQ(bulk_temperature_factor(0.0, 0.0), 1.0);
}

}  // namespace tiretherm::physics
