// SPDX-License-Identifier: BSD-3-Clause
// The thesis's effects: numbers computed by hand from their equations.
#include <cmath>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"

namespace tiretherm::physics {

TEST(Conduction, LinkCarriesKOverDepthOfTheBulk) {
    // k(55 C) = 0.29 + 0.00943 * 35 = 0.62005 W/mK; G = k / 10 mm * S_tot = 62.005 * 0.46766 = 28.997 W/K
    const Bench bench = two_nodes();
    const Terms terms = bench.said(bench.active("conduction"), rolling(), bench.T);
    EXPECT_NEAR(terms.face_G[0], 62.005 * bench.tire.outer_area(), 1e-10);
    EXPECT_NEAR(terms.face_G[0], 28.997, 1e-3);
}

TEST(Conduction, FaceBetweenTwoMaterialsIsTheirSeries) {
    // Half cells of 0.75 mm at 0.29 and 2 mm at 0.1: area / (0.75e-3/0.29 + 2e-3/0.1)
    Bench bench = specimen();
    bench.materials[1].conductivity.fill(Curve::constant(0.1));
    const Terms terms = bench.said(bench.active("conduction"), {}, bench.T);
    bool seen = false;
    for (std::size_t f = 0; f < bench.mesh.faces.size(); ++f) {
        const mesh::Face& face = bench.mesh.faces[f];
        if (bench.mesh.layer[static_cast<std::size_t>(face.a)] != bench.mesh.layer[static_cast<std::size_t>(face.b)]) {
            seen = true;
            EXPECT_NEAR(terms.face_G[f], face.area / (0.75e-3 / 0.29 + 2e-3 / 0.1), 1e-12);
        }
    }
    EXPECT_TRUE(seen);
}

TEST(Conduction, FollowsTheDirectionOfTheFace) {
    Bench bench = specimen();
    bench.materials[0].conductivity = {Curve::constant(1.0), Curve::constant(2.0), Curve::constant(3.0)};
    const Terms terms = bench.said(bench.active("conduction"), {}, bench.T);
    for (std::size_t f = 0; f < bench.mesh.faces.size(); ++f) {
        const mesh::Face& face = bench.mesh.faces[f];
        if (bench.mesh.layer[static_cast<std::size_t>(face.a)] == 0 &&
            bench.mesh.layer[static_cast<std::size_t>(face.b)] == 0) {
            const double k = 1.0 + static_cast<double>(face.axis);
            EXPECT_NEAR(terms.face_G[f], k * face.area / (face.half_a + face.half_b), 1e-12);
        }
    }
}

TEST(StrainEnergyLossEffect, SharesTheLawByMassAndScalesEachPart) {
    // 4000 N, 100 km/h: SEL of the law at the bulk's 55 C; 15 % and 85 % of it.
    const Bench bench = two_nodes();
    const Inputs in = rolling();
    const double power = strain_power(bench.tire, in.speed, in.vertical_load);
    const LossTangent law;
    const double loss = power * law.value(328.15 + law.shift(bench.tire.revolutions(in.speed, in.vertical_load)));
    ActiveEffect effect = bench.active("strain_energy_loss");
    const Terms plain = bench.said(effect, in, bench.T);
    EXPECT_NEAR(plain.watts[0], loss, 1e-9);
    EXPECT_NEAR(plain.node_q[0], 0.15 * loss, 1e-9);
    effect.parameters[0] = 2.0;
    effect.parameters[1] = 0.5;
    const Terms scaled = bench.said(effect, in, bench.T);
    EXPECT_NEAR(scaled.node_q[0], 0.30 * loss, 1e-9);
    EXPECT_NEAR(scaled.node_q[1], 0.425 * loss, 1e-9);
}

TEST(SlidingFrictionEffect, PutsItsShareIntoTheSurface) {
    // 0.6 (500 N * 27.778 m/s * 0.01 + 2000 N * 27.778 m/s * tan 2 deg) = 0.6 (138.889 + 1940.04) = 1247.36 W
    const Bench bench = two_nodes();
    const Terms terms = bench.said(bench.active("sliding_friction"), driven(), bench.T);
    EXPECT_NEAR(terms.node_q[0], 1247.36, 0.01);
    EXPECT_EQ(terms.node_q[1], 0.0);
}

TEST(SlidingFrictionEffect, DoesNotCareForTheSignConvention) {
    const Bench bench = two_nodes();
    const ActiveEffect effect = bench.active("sliding_friction");
    Inputs opposite = rolling();
    opposite.lateral_force = -opposite.lateral_force;
    opposite.longitudinal_force = -opposite.longitudinal_force;
    EXPECT_EQ(bench.watts(effect, opposite), bench.watts(effect, rolling()));
}

TEST(SlidingFrictionEffect, SwitchesEachDirectionOff) {
    const Bench bench = two_nodes();
    ActiveEffect effect = bench.active("sliding_friction");
    effect.choices[0] = 1;
    EXPECT_NEAR(bench.watts(effect, driven()), 0.6 * 1940.04, 0.01);
    effect.choices[0] = 0;
    effect.choices[1] = 1;
    EXPECT_NEAR(bench.watts(effect, driven()), 0.6 * 138.889, 0.01);
    effect.choices[0] = 1;
    EXPECT_EQ(bench.watts(effect, driven()), 0.0);
}

TEST(SlidingFrictionEffect, NeedsContact) {
    const Bench bench = two_nodes();
    Inputs lifted = rolling();
    lifted.vertical_load = 0.5;
    EXPECT_EQ(bench.watts(bench.active("sliding_friction"), lifted), 0.0);
}

TEST(AirConvectionEffect, AddsForcedAndExponentialCoefficients) {
    // 1/L = 1/0.6616 + 1/0.225, L = 0.167898 m; Re = 27.7778 L / 1.5e-5 = 310 922; 0.318 Re^0.571 = 434.9;
    // forced = 0.025 / L * 434.9 = 64.8; exponential at 308.15 K: 8.59e-11 exp(27.0864) = 49.8 W/m2K.
    const Bench bench = two_nodes();
    const double L = 1.0 / (1.0 / 0.6616 + 1.0 / 0.225);
    const double h =
        0.025 / L * 0.318 * std::pow(100.0 / 3.6 * L / 1.5e-5, 0.571) + 8.59e-11 * std::exp(0.0879 * 308.15);
    EXPECT_NEAR(h, 64.8 + 49.8, 0.2);
    const double area = bench.tire.outer_area() - 2.333e-6 * 4000.0;
    const Terms terms = bench.said(bench.active("air_convection"), rolling(), bench.T);
    EXPECT_NEAR(terms.node_G[0], h * area, 1e-9);
    EXPECT_NEAR(terms.watts[0], -12.0 * h * area, 1e-8);
}

TEST(AirConvectionEffect, ExponentialIs24At300KAnd76At313K) {
    // The check values of erratum E4: 8.59e-11 exp(0.0879 T).
    EXPECT_NEAR(8.59e-11 * std::exp(0.0879 * 300.0), 24.0, 0.5);
    EXPECT_NEAR(8.59e-11 * std::exp(0.0879 * 313.0), 76.0, 0.8);
}

TEST(AirConvectionEffect, NeverFallsBelowTheFloorAndScalesIt) {
    Bench bench = two_nodes();
    bench.T[0] = 280.0;  // exponential: 4 W/m2K
    Inputs still = rolling();
    still.speed = 0.0;
    ActiveEffect effect = bench.active("air_convection");
    effect.parameters[0] = 1.2;
    const double area = bench.tire.outer_area() - 2.333e-6 * 4000.0;
    EXPECT_NEAR(bench.said(effect, still, bench.T).node_G[0], 1.2 * 30.0 * area, 1e-10);
}

TEST(AirConvectionEffect, ClampHoldsTheExponential) {
    Bench bench = two_nodes();
    bench.T[0] = 420.0;
    ActiveEffect effect = bench.active("air_convection");
    effect.parameters[static_cast<std::size_t>(find_parameter(*effect.effect, "clamp_high"))] = 373.15;
    effect.choices = {1};
    const double held = 8.59e-11 * std::exp(0.0879 * 373.15);
    ActiveEffect off = effect;
    off.choices = {2};
    const double area = bench.tire.outer_area() - 2.333e-6 * 4000.0;
    EXPECT_NEAR(bench.said(effect, rolling(), bench.T).node_G[0] - bench.said(off, rolling(), bench.T).node_G[0],
                held * area, 1e-9 * held);
}

// Forced 64.8 W/m2K at 100 km/h: the exponential adds 129.6 at most, which it would pass at 319 K; at 363.15 K the thesis's own
// form has 8.59e-11 exp(31.921) = 6.28e3. At rest nothing is forced, and the floor stays.
TEST(AirConvectionEffect, ExponentialIsBoundedByTheForcedPart) {
    Bench bench = two_nodes();
    bench.T[0] = 363.15;
    const double area = bench.tire.outer_area() - 2.333e-6 * 4000.0;
    const double L = 1.0 / (1.0 / 0.6616 + 1.0 / 0.225);
    const double forced = 0.025 / L * 0.318 * std::pow(100.0 / 3.6 * L / 1.5e-5, 0.571);
    ActiveEffect effect = bench.active("air_convection");
    EXPECT_NEAR(bench.said(effect, rolling(), bench.T).node_G[0], 3.0 * forced * area, 1e-9);
    EXPECT_EQ(bench.said(effect, rolling(), bench.T).node_slope[0], 0.0);
    Inputs parked = rolling();
    parked.speed = 0.0;
    EXPECT_NEAR(bench.said(effect, parked, bench.T).node_G[0], 30.0 * area, 1e-9);
    effect.choices = {1};
    EXPECT_NEAR(bench.said(effect, parked, bench.T).node_G[0] / area, 6.28e3, 0.02e3);
    const HeatEffect& heat = *effect.effect->heat_effect();
    EXPECT_NE(heat.range_warning(effect, 290.0, 330.0), "") << "57 degC, and no bound";
    EXPECT_EQ(heat.range_warning(effect, 290.0, 320.0), "");
    effect.choices = {0};
    EXPECT_EQ(heat.range_warning(effect, 290.0, 363.0), "");
}

TEST(RoadContactEffect, IsHcTimesTheContactArea) {
    // 500 W/m2K * 2.333e-6 m2/N * 4000 N = 4.666 W/K; 12 K above the road: 55.99 W
    const Bench bench = two_nodes();
    const Terms terms = bench.said(bench.active("road_contact"), rolling(), bench.T);
    EXPECT_NEAR(terms.node_G[0], 4.666, 1e-12);
    EXPECT_NEAR(terms.watts[0], -55.992, 1e-9);
}

TEST(LaserEffect, QuarterOfASpecimenTakesAQuarterOfThePower) {
    const Bench bench = specimen();
    ActiveEffect effect = bench.active("laser");
    EXPECT_NEAR(bench.watts(effect, rolling()), 0.25, 1e-12);
    effect.parameters[1] = 0.9;  // absorptivity
    EXPECT_NEAR(bench.watts(effect, rolling()), 0.225, 1e-12);
}

TEST(LaserEffect, GaussianBeamIsWholeOnAWideSpecimen) {
    const Bench bench = specimen();
    ActiveEffect effect = bench.active("laser");
    effect.choices = {1};
    bench.place(effect);
    // w = 5.64 mm against 30 mm: the tail beyond is exp(-2 (30/5.64)^2) = 3e-25.
    EXPECT_NEAR(bench.watts(effect, rolling()), 0.25, 1e-12);
}

TEST(LaserEffect, DepthSpreadsTheLightByBeersLaw) {
    // 1/e depth 2 mm: cells end at 1.5 and 3 mm, so the first takes 1 - exp(-0.75), the second exp(-0.75) - exp(-1.5).
    const Bench bench = specimen();
    ActiveEffect effect = bench.active("laser");
    effect.parameters[2] = 0.002;
    bench.place(effect);
    const Terms terms = bench.said(effect, rolling(), bench.T);
    const mesh::Grid& grid = *bench.mesh.grid;
    const auto column = [&](int k) { return terms.node_q[static_cast<std::size_t>(grid.cell(0, 0, k))]; };
    EXPECT_NEAR(terms.watts[0], 0.25, 1e-12);  // what reaches the inner face stays in the last cell
    EXPECT_NEAR(column(1) / column(0), (std::exp(-0.75) - std::exp(-1.5)) / (1.0 - std::exp(-0.75)), 1e-12);
}

TEST(StillAirEffect, HasItsOwnCoefficientOnEachPatch) {
    // Quarter faces of 9 cm2; top at 40, bottom at 10 W/m2K, 20 K above the air: (40 + 10) * 9e-4 * 20 = 0.9 W
    const Bench bench = specimen();
    ActiveEffect effect = bench.active("still_air");
    ASSERT_EQ(effect.patches.size(), 2U);
    effect.overrides = {
        {.scope = Scope::patch, .index = bench.mesh.find_patch("top"), .parameter = 0, .value = 40.0},
        {.scope = Scope::patch, .index = bench.mesh.find_patch("bottom"), .parameter = 0, .value = 10.0}};
    EXPECT_NEAR(bench.watts(effect, {.air_temperature = 280.0}), -0.9, 1e-12);
}

TEST(UniformSourceEffect, HeatsByVolume) {
    // 1e5 W/m3 * 30 x 30 x 15 mm = 1.35 W
    const Bench bench = specimen();
    ActiveEffect effect = bench.active("uniform_source");
    effect.parameters[0] = 1e5;
    EXPECT_NEAR(bench.watts(effect, {}), 1.35, 1e-12);
}

}  // namespace tiretherm::physics
