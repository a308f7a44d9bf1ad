// SPDX-License-Identifier: BSD-3-Clause
// Moduli of cord-rubber plies (lamina theory) against hand calculation and limits.

#include "physics/tire_laws/cord_rubber.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tiretherm::physics {

namespace {

using std::numbers::pi;
/// Steel cord in rubber, a quarter of the volume.
constexpr CordRubber belt{
    .cord = {.modulus = 200e9, .poisson = 0.3}, .rubber = {.modulus = 10e6, .poisson = 0.5}, .cord_share = 0.25};

}  // namespace

TEST(CordRubber, ShareIsCordAreaOverBeltSection) {
    // 100 cords of 0.8 mm in 1.6 mm x 200 mm: pi * 0.64 / 4 * 100 / 320 = 0.157080 (erratum E10)
    EXPECT_NEAR(CordRubber::share(0.8e-3, 100.0, 1.6e-3, 0.2), 0.05 * pi, 1e-15);
}

TEST(CordRubber, WithoutCordsIsRubber) {
    CordRubber bare = belt;
    bare.cord_share = 0.0;
    const Lamina ply = lamina(bare);
    EXPECT_DOUBLE_EQ(ply.E1, 10e6);
    EXPECT_DOUBLE_EQ(ply.E2, 10e6);
    EXPECT_DOUBLE_EQ(ply.nu12, 0.5);
    EXPECT_DOUBLE_EQ(ply.nu21(), 0.5);
    EXPECT_NEAR(ply.G12, 10e6 / 3.0, 1e-8);  // E / (2 * 1.5); 1e-15 of it is round-off
}

TEST(CordRubber, EqualsTheHandComputedPly) {
    // E1 = 0.25 * 200e9 + 0.75 * 10e6 = 50.0075 GPa; E2 = 10 MPa * 1.5 / 0.75 = 20 MPa; nu12 = 0.075 + 0.375 = 0.45;
    // nu21 = 0.45 * 20e6 / 50.0075e9 = 1.79973e-4; G_r = 3.33333 MPa, G_c = 76923.1 MPa (erratum E11),
    // G12 / G_r = (1.25 G_c + 0.75 G_r) / (0.75 G_c + 1.25 G_r) = 96156.35 / 57696.47 = 1.666590
    const Lamina ply = lamina(belt);
    EXPECT_NEAR(ply.E1, 50.0075e9, 1.0);
    EXPECT_NEAR(ply.E2, 20e6, 1e-6);
    EXPECT_NEAR(ply.nu12, 0.45, 1e-15);
    EXPECT_NEAR(ply.nu21(), 1.79973e-4, 5e-10);
    EXPECT_NEAR(ply.G12 / 3.3333333e6, 1.666590, 5e-6);
}

TEST(CordRubber, PullAt20DegreesIsFarBelowThePullAlong) {
    // psi = 20 deg: cos^2 = 0.883022, sin^2 = 0.116978. 1/E_x = 0.77973/50.0075e9
    // + (1/5.55530e6 - 0.9/50.0075e9) * 0.103294 + 0.0136838/20e6 = 1.559e-11 + 1.859192e-8 + 6.8419e-10
    // = 1.929170e-8 1/Pa: 51.836 MPa
    EXPECT_NEAR(lamina(belt).modulus_at(pi / 9.0), 51.836e6, 0.001e6);
}

TEST(Lamina, LimitsAreThePullsAlongAndAcross) {
    const Lamina ply = lamina(belt);
    EXPECT_DOUBLE_EQ(ply.modulus_at(0.0), ply.E1);
    EXPECT_NEAR(ply.modulus_at(pi / 2.0) / ply.E2, 1.0, 1e-14);
    EXPECT_DOUBLE_EQ(ply.shear_modulus_at(0.0), ply.G12);
    EXPECT_NEAR(ply.shear_modulus_at(pi / 2.0) / ply.G12, 1.0, 1e-14);
    // At 45 degrees shear is a pull along one diagonal and a push along the other: 1/G = (1+nu12)/E1 + (1+nu21)/E2
    EXPECT_NEAR(1.0 / ply.shear_modulus_at(pi / 4.0), 1.45 / ply.E1 + (1.0 + ply.nu21()) / ply.E2, 1e-20);
}

TEST(Lamina, OfOneMaterialIsTheSameAtEveryAngle) {
    // E1 = E2 = E and G = E / (2 (1 + nu)) make the middle term 2 cos^2 sin^2, so the bracket is (cos^2 + sin^2)^2 / E.
    const Isotropic steel{.modulus = 200e9, .poisson = 0.3};
    const Lamina sheet{.E1 = 200e9, .E2 = 200e9, .nu12 = 0.3, .G12 = steel.shear_modulus()};
    for (int degrees = 0; degrees <= 90; degrees += 5) {
        const double angle = degrees * pi / 180.0;
        EXPECT_NEAR(sheet.modulus_at(angle) / 200e9, 1.0, 1e-14) << degrees;
        EXPECT_NEAR(sheet.shear_modulus_at(angle) / steel.shear_modulus(), 1.0, 1e-14) << degrees;
    }
}

TEST(CordRubber, ShearModulusRunsFromRubberToCord) {
    // V_c -> 1: G_r * 2 G_c / (2 G_r) = G_c, up to (1 - V_c) G_c / G_r = 1e-9 * 2.3e4
    CordRubber full = belt;
    full.cord_share = 1.0 - 1e-9;
    EXPECT_NEAR(lamina(full).G12 / full.cord.shear_modulus(), 1.0, 3e-5);
    double last = 0.0;
    for (double share = 0.0; share < 0.95; share += 0.1) {
        full.cord_share = share;
        EXPECT_GT(lamina(full).G12, last);
        last = lamina(full).G12;
    }
}

TEST(Laminate, OfOnePlyIsTheThesiss56) {
    // One ply is free to shear, so that its compliances turn as (56) has them, with G_xy by erratum E11.
    const Lamina ply = lamina(belt);
    for (const double degrees : {0.0, 12.0, 24.0, 45.0, 67.0, 90.0}) {
        const double angle = degrees * pi / 180.0;
        const Sheet one = laminate(ply, angle, 1);
        EXPECT_NEAR(one.E_x / ply.modulus_at(angle), 1.0, 1e-7) << degrees;
        EXPECT_NEAR(one.E_y / ply.modulus_at(angle + pi / 2.0), 1.0, 1e-7) << degrees;
        EXPECT_NEAR(one.G_xy / ply.shear_modulus_at(angle), 1.0, 1e-7) << degrees;
        const double s2 = std::sin(angle) * std::sin(angle);
        const double c2 = 1.0 - s2;
        const double nu = one.E_x * (ply.nu12 / ply.E1 * (c2 * c2 + s2 * s2) -
                                     (1.0 / ply.E1 + 1.0 / ply.E2 - 1.0 / ply.G12) * s2 * c2);
        EXPECT_NEAR(one.nu_xy, nu, 1e-6 * std::abs(nu)) << degrees;
    }
}

TEST(Laminate, APairHoldsItsPliesWhereCordsDoNotStretch) {
    // Cords without end stiff, E1 >> E2: the pair can only turn its cords. A pull along x shortens y by
    // nu = cot^2(psi) (the cords' length is kept: c^2 eps_x + s^2 eps_y = 0), shears the plies along their cords by
    // gamma12 = -2 s c (eps_x - eps_y) and stretches them across by eps2 = eps_x + eps_y. Energy per volume:
    //     E_x eps_x^2 = G12 gamma12^2 + E2 eps2^2,  eps_y = -eps_x cot^2:
    //     E_x = G12 (2 s c (1 + cot^2))^2 + E2 (1 - cot^2)^2 = 4 G12 cot^2 + E2 (1 - cot^2)^2
    // At 24 degrees cot^2 = 5.04468; G12 = 5.5553 MPa, E2 = 20 MPa: 112.10 + 327.19 = 439.29 MPa; of one ply 38 MPa
    Lamina ply = lamina(belt);
    ply.E1 *= 1e4;  // 5e14 Pa
    const Sheet pair = laminate(ply, 24.0 * pi / 180.0, 2);
    EXPECT_NEAR(pair.nu_xy, 5.04468, 1e-3);
    EXPECT_NEAR(pair.E_x, 439.29e6, 0.05e6);
    EXPECT_LT(ply.modulus_at(24.0 * pi / 180.0), 0.1 * pair.E_x);
    // Ten plies at +-psi are five pairs; at 45 degrees x and y are alike.
    EXPECT_NEAR(laminate(ply, 24.0 * pi / 180.0, 10).E_x / pair.E_x, 1.0, 1e-12);
    const Sheet even = laminate(lamina(belt), pi / 4.0, 2);
    EXPECT_NEAR(even.E_x / even.E_y, 1.0, 1e-12);
}

}  // namespace tiretherm::physics
