// SPDX-License-Identifier: BSD-3-Clause
// Stiffness of a table, the lateral force through a peak, and friction against temperature, each by hand.

#include "physics/tire_laws/handling.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "physics/tire_laws/compound.hpp"

namespace tiretherm::physics {

namespace {

constexpr double zero = 273.15;

/// 2 and 4 kN, 40 and 80 degC: 60, 50; 110, 90 kN/rad.
Handling with_table() {
    Handling handling;
    handling.stiffness_table = GridTable{.axes = {{.input = &Inputs::vertical_load, .at = {2000.0, 4000.0}},
                                                  {.input = nullptr, .at = {zero + 40.0, zero + 80.0}}},
                                         .values = {60e3, 50e3, 110e3, 90e3}};
    return handling;
}

double stiffness_at(const Handling& handling, double load, double celsius) {
    return handling.cornering_stiffness(Tire{}, {.vertical_load = load}, zero + celsius);
}

}  // namespace

// At 3 kN and 50 degC: 2 kN: 60 - 10/4 = 57.5; 4 kN: 110 - 20/4 = 105; half-way 81.25 kN/rad. Held beyond the table.
TEST(Handling, AMeasuredStiffnessTakesThePlaceOfTheFormula) {
    EXPECT_NEAR(stiffness_at(with_table(), 3000.0, 50.0), 81.25e3, 1e-6);
    EXPECT_NEAR(stiffness_at(with_table(), 9000.0, 120.0), 90e3, 1e-6);
    EXPECT_EQ(stiffness_at(with_table(), 0.0, 50.0), 0.0);
    Handling scaled = with_table();
    scaled.lambda_CP = 0.5;
    EXPECT_NEAR(stiffness_at(scaled, 3000.0, 50.0), 40.625e3, 1e-6);
    // Without it the moduli: 121.485 kN/rad at 4 kN and 70 degC (CorneringStiffness.DefaultIs30TimesTheLoadAt70Degrees).
    EXPECT_NEAR(stiffness_at(Handling{}, 4000.0, 70.0), 1.21485e5, 5.0);
}

// (60): lambda_Tb = CP/K, so that (59) gives CP as the slope of the force. K = pKy1 Fz0 sin(2 atan(Fz/(pKy2 Fz0)))
// = 20 4000 sin(2 atan(1/2)) = 64 kN/rad at 4 kN; the table has 100 at 60 degC: lambda_Tb = 1.5625.
TEST(Handling, AMeasuredStiffnessReplacesThatOfAPropertyFile) {
    Handling handling = with_table();
    handling.magic_formula = MagicFormula{};
    handling.magic_formula->pCy1 = 1.3, handling.magic_formula->pDy1 = 1.0;
    handling.magic_formula->pKy1 = 20.0, handling.magic_formula->pKy2 = 2.0;
    const Inputs inputs{.speed = 20.0, .vertical_load = 4000.0, .slip_angle = 1e-6};
    EXPECT_NEAR(handling.stiffness_of_file(inputs), 64e3, 1e-6);
    EXPECT_NEAR(handling.lateral(Tire{}, inputs, zero + 60.0, 1.0).force / 1e-6, 100e3, 1.0);
}

// (6): C = 1 + (1 - (2/pi) asin 0.9) = 1.287133; (7) at B = CP/(C D) = 1e5/(1.287133 4000) = 19.42302 and
// B x_m = 2.542467: E = (2.542467 - tan(pi/2/1.287133))/(2.542467 - atan 2.542467) = (2.542467 - 2.736011)/1.346404
// = -0.143749. At 2 degrees B x = 0.677991, its atan 0.595802, the argument 0.677991 + 0.143749 0.082189 = 0.689806:
// F = 4000 sin(1.287133 atan 0.689806) = 2805.25 N
TEST(PeakCurve, EqualsTheHandComputedFactors) {
    const PeakCurve curve{.friction = 1.0, .asymptote = 0.9, .peak_slip = 7.5 * std::numbers::pi / 180.0};
    EXPECT_NEAR(curve.shape(), 1.287133, 1e-6);
    EXPECT_NEAR(curve.curvature(19.42302), -0.143749, 1e-6);
    EXPECT_NEAR(curve.force(4000.0, 1e5, 2.0 * std::numbers::pi / 180.0).force, 2805.25, 0.01);
}

// The three features are what the curve has: slope CP, peak mu Fz at x_m, y_a far beyond.
TEST(PeakCurve, HasThePeakTheSlopeAndTheAsymptoteItWasMadeOf) {
    for (const double asymptote : {0.6, 0.9, 0.99}) {
        for (const double degrees : {5.0, 7.5, 12.0}) {
            const double x_m = degrees * std::numbers::pi / 180.0;
            const PeakCurve curve{.friction = 1.1, .asymptote = asymptote, .peak_slip = x_m};
            const auto force = [&](double slip) { return curve.force(4000.0, 1e5, slip).force; };
            EXPECT_NEAR(force(1e-6) / 1e-6, 1e5, 1.0);
            EXPECT_NEAR(force(x_m), 4400.0, 1e-3);
            EXPECT_LT(force(0.98 * x_m), 4400.0);
            EXPECT_LT(force(1.02 * x_m), 4400.0);
            EXPECT_NEAR(force(1e9), asymptote * 4400.0, 1.0);
            EXPECT_DOUBLE_EQ(force(-0.05), -force(0.05));
        }
    }
    EXPECT_EQ(PeakCurve{}.force(0.0, 0.0, 0.1).force, 0.0);
}

// Less friction lowers the peak and leaves the slope: the curve shrinks towards the origin, its peak to x_m times as much.
TEST(PeakCurve, ShrinksWithTheFriction) {
    const PeakCurve curve{.friction = 1.0, .asymptote = 0.9, .peak_slip = 0.13};
    EXPECT_NEAR(curve.force(4000.0, 1e5, 0.7 * 0.13, 0.7).force, 0.7 * 4000.0, 1e-3);
    EXPECT_NEAR(curve.force(4000.0, 1e5, 1e-6, 0.7).force / 1e-6, 1e5, 1.0);
    for (const double slip : {0.02, 0.08, 0.3}) {
        EXPECT_NEAR(curve.force(4000.0, 1e5, 0.7 * slip, 0.7).force, 0.7 * curve.force(4000.0, 1e5, slip).force, 1e-3);
    }
}

// tan delta at 40 and 80 degC, both shifted by 101.6 log10(1000/52)/(-8.86 - log10(1000/52)) = -12.8602 K:
// 0.515018 and 0.298332, ratio 0.579265. Thirds: adhesion falls by a tenth, wear stays:
// (0.3 0.9 + 0.68 0.579265 + 0.02)/(0.3 + 0.68 + 0.02) = 0.683900
TEST(Grip, IsTheSumOfAdhesionHysteresisAndWear) {
    const Grip grip{.adhesion = Curve::table({zero + 40.0, zero + 80.0}, {0.3, 0.27}),
                    .hysteresis = 0.68,
                    .wear = 0.02,
                    .reference_temperature = zero + 40.0};
    const LossTangent tread;
    const auto tan_delta = [&](double T) { return tread.value(T + tread.shift(grip.frequency)); };
    EXPECT_NEAR(tan_delta(zero + 40.0), 0.515018, 1e-6);
    EXPECT_NEAR(tan_delta(zero + 80.0), 0.298332, 1e-6);
    EXPECT_NEAR(grip.value(zero + 80.0, tan_delta), 0.683900, 1e-6);
    EXPECT_DOUBLE_EQ(grip.value(zero + 40.0, tan_delta), 1.0);
}

// The thesis (II.3.1): friction falls in the heat, and in the cold too, so that there is an optimum: with hysteresis alone at
// the loss tangent's peak, -8 degC less the shift of -12.86 K = 4.86 degC.
TEST(Grip, HasAnOptimumWhereTheLossTangentHasItsPeak) {
    const Grip grip{.hysteresis = 1.0};
    const LossTangent tread;
    const auto at = [&](double celsius) {
        return grip.value(zero + celsius, [&](double T) { return tread.value(T + tread.shift(grip.frequency)); });
    };
    EXPECT_GT(at(4.86), at(3.0));
    EXPECT_GT(at(4.86), at(7.0));
    EXPECT_LT(at(-20.0), at(4.86));
    EXPECT_LT(at(100.0), at(60.0));
}

// The peak stands at -8 degC (thesis V.5.2); within 8 K of it a parabola rounds it off at the Gaussian 4 K above:
// 2.14e15 exp(-((269.15 + 4989)/882)^2) = 2.14e15 exp(-35.540926) = 0.785569. A tables' is its highest point.
TEST(Compound, KnowsTheLargestLossTangent) {
    const mesh::Mesh none;
    ActiveEffect loss = activate(*find_effect("strain_energy_loss"), none);
    const LossPeak peak = loss_peak(loss, 0);
    EXPECT_NEAR(peak.temperature, zero - 8.0, 1e-9);
    EXPECT_NEAR(peak.value, 0.785569, 1e-6);
    EXPECT_DOUBLE_EQ(peak.frequency, 52.0);
    EXPECT_GT(tan_delta_of(loss, 0, zero - 8.0, 52.0), tan_delta_of(loss, 0, zero - 6.0, 52.0));
    loss.tables[static_cast<std::size_t>(find_table(*loss.effect, "tan_delta"))] =
        Curve::table({250.0, 270.0, 300.0}, {0.3, 0.6, 0.2});
    EXPECT_DOUBLE_EQ(loss_peak(loss, 0).temperature, 270.0);
    EXPECT_DOUBLE_EQ(loss_peak(loss, 0).value, 0.6);
}

}  // namespace tiretherm::physics
