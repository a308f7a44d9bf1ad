// SPDX-License-Identifier: BSD-3-Clause
// Extensions that move or make heat: one number each, by hand, on the bench of two nodes: surface 35 C, bulk 55 C, air
// and road 23 C, 100 km/h, 4000 N.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"
#include "physics/tire_laws/contact.hpp"

namespace tiretherm::physics {

TEST(SidewallConvection, CoolsTheBulkOfTwoNodes) {
    // 12 W/K * (23 - 55) K = -384 W, none of it from the surface.
    Whole whole(two_nodes(), {{"sidewall_convection", {{"conductance", 12.0}}}});
    whole.ask(rolling());
    EXPECT_NEAR(whole.flow(1), -384.0, 1e-9);
    EXPECT_EQ(whole.flow(0), 0.0);
}

TEST(SidewallConvection, TakesTheSidewallsWhereThereAreSome) {
    // 12 W/K over the patch plus 40 W/m2K on its area; everything 10 K above the air.
    const Bench bench = section();
    Whole whole(bench, {{"sidewall_convection", {{"conductance", 12.0}, {"h", 40.0}}}});
    whole.ask(rolling(), std::vector<double>(bench.T.size(), 306.15));
    const mesh::Patch& walls = bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("sidewalls"))];
    double given = 0.0;
    for (const mesh::PatchFace& face : walls.faces) {
        given += whole.flow(face.node);
    }
    EXPECT_NEAR(whole.watts("sidewall_convection"), -10.0 * (12.0 + 40.0 * walls.area()), 1e-9);
    EXPECT_NEAR(given, whole.watts("sidewall_convection"), 1e-9);
}

TEST(InnerGas, StandsBetweenBulkAndRim) {
    // Gas at 40 C: the bulk loses 9 (55 - 40) = 135 W, the gas gains 135 - 4 (40 - 23) = 67 W, with 70 J/K.
    Whole whole(two_nodes(), {{"inner_gas"}});
    whole.ask(rolling(), {308.15, 328.15, 313.15});
    EXPECT_NEAR(whole.flow(1), -135.0, 1e-9);
    EXPECT_NEAR(whole.flow(whole.node("gas")), 67.0, 1e-9);
    EXPECT_EQ(whole.flow(0), 0.0);
    EXPECT_EQ(whole.system().capacity(2, 300.0), 70.0);
    EXPECT_NEAR(whole.watts("inner_gas"), -68.0, 1e-9) << "what leaves to the rim at the air's temperature";
}

TEST(InnerGas, MeetsTheRimWhereThereIsOne) {
    // Gas 40 C, rim 30 C: 4 * 10 = 40 W to the rim instead of 68 W to the air. The rim: 40 + 1 (55 - 30) from the bead
    // - 10 (30 - 23) to the air = -5 W. Either order of switching on.
    const Part gas{"inner_gas"};
    const Part rim{"rim_conduction"};
    for (const std::vector<Part>& parts : {std::vector{rim, gas}, std::vector{gas, rim}}) {
        Whole whole(two_nodes(), parts);
        std::vector<double> T{308.15, 328.15, 303.15, 303.15};
        T[static_cast<std::size_t>(whole.node("gas"))] = 313.15;
        whole.ask(rolling(), T);
        EXPECT_NEAR(whole.flow(1), -135.0 - 25.0, 1e-9);
        EXPECT_NEAR(whole.flow(whole.node("gas")), 135.0 - 40.0, 1e-9);
        EXPECT_NEAR(whole.flow(whole.node("rim")), -5.0, 1e-9);
        EXPECT_NEAR(whole.watts("inner_gas"), 0.0, 1e-9);
    }
}

TEST(RimConduction, TakesItsHeatThroughTheBeads) {
    // Tire 20 K above the rim: 1 W/K over the bead faces by area, 20 W; the rim, at the air's 23 C, keeps all of it.
    const Bench bench = section();
    Whole whole(bench, {{"rim_conduction"}});
    std::vector<double> T(bench.T.size() + 1, 316.15);
    T.back() = 296.15;
    whole.ask(rolling(), T);
    double lost = 0.0;
    for (const mesh::PatchFace& face :
         bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("beads"))].faces) {
        lost += whole.flow(face.node);
    }
    EXPECT_NEAR(lost, -20.0, 1e-9);
    EXPECT_NEAR(whole.flow(whole.node("rim")), 20.0, 1e-9);
    EXPECT_EQ(whole.system().capacity(T.size() - 1, 300.0), 7200.0);
}

// A disc of 300 C at 1 W/K. Two nodes: into the bulk of 55 C, 245 W. Where there is a rim, of 30 C, into it: 270 W, beside the 25 W
// of the bead and 10 (30 - 23) W to the air. A section takes it through its beads, of 43 C: 257 W.
TEST(BrakeHeat, GoesToTheRimOrThroughTheBeads) {
    Whole bulk(two_nodes(), {{"brake_heat"}});
    bulk.ask(rolling());
    EXPECT_NEAR(bulk.flow(1), 245.0, 1e-9);
    EXPECT_EQ(bulk.flow(0), 0.0);
    EXPECT_NEAR(bulk.watts("brake_heat"), 245.0, 1e-9);

    for (const std::vector<Part>& parts : {std::vector<Part>{{"rim_conduction"}, {"brake_heat"}},
                                           std::vector<Part>{{"brake_heat"}, {"rim_conduction"}}}) {
        Whole rim(two_nodes(), parts);
        rim.ask(rolling(), std::vector<double>{308.15, 328.15, 303.15});
        EXPECT_NEAR(rim.flow(rim.node("rim")), 270.0 + 25.0 - 70.0, 1e-9);
        EXPECT_NEAR(rim.flow(1), -25.0, 1e-9);
    }

    const Bench bench = section();
    Whole beads(bench, {{"brake_heat"}});
    beads.ask(rolling(), std::vector<double>(bench.T.size(), 316.15));
    double taken = 0.0;
    for (const mesh::PatchFace& face :
         bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("beads"))].faces) {
        taken += beads.flow(face.node);
    }
    EXPECT_NEAR(taken, 257.0, 1e-9);
}

TEST(CorneringLoss, HeatsTheBulkWithTheSquareOfTheForce) {
    // 2.5e-6 1/N * (2000 N)^2 * 27.778 m/s = 277.78 W, none at the surface.
    Whole whole(two_nodes(), {{"cornering_loss", {{"coefficient", 2.5e-6}}}});
    whole.ask(rolling());
    EXPECT_NEAR(whole.flow(1), 277.778, 1e-3);
    EXPECT_EQ(whole.flow(0), 0.0);
}

TEST(GrooveConvection, IsAFinOnTheForcedPart) {
    // h = 61.02 (27.778/25)^0.571 = 64.81 W/m2K (ConvectionExponent); mL = 0.008 sqrt(2 * 64.81/(0.29 * 0.02)) = 1.1959,
    // tanh(mL)/(mL) = 0.6960; 0.25 * 0.6960 * 64.81 * (0.46766 - 0.00933) m2 = 5.169 W/K.
    Whole whole(two_nodes(), {{"groove_convection"}});
    whole.ask(rolling());
    EXPECT_NEAR(whole.system().terms().node_G[0], 5.169, 2e-3);
    EXPECT_NEAR(whole.watts("groove_convection"), -12.0 * whole.system().terms().node_G[0], 1e-9);
    Inputs rest = rolling();
    rest.speed = 0.0;
    EXPECT_EQ(whole.ask(rest).watts("groove_convection"), 0.0);
}

TEST(WetRoad, HeatsAndEvaporatesTheFilmItMeets) {
    // The contact is 9.3320e-3 m2 / 0.096699 m = 96.51 mm wide, not as wide as the tire: 998 * 1e-4 * 0.09651 * 27.778 = 0.26754
    // kg/s; times 0.12 * 4186 + 1e-5 * 2.45e6 = 526.8 J/kgK: 140.95 W/K; 12 K.
    Whole whole(two_nodes(), {{"wet_road"}});
    const Tire& tire = whole.problem().tire;
    EXPECT_NEAR(tire.contact_area(4000.0) / tire.contact_length(4000.0), 0.09651, 1e-5);
    EXPECT_NEAR(whole.ask(rolling()).watts("wet_road"), -12.0 * 140.95, 0.2);
    Inputs dry = rolling();
    dry.wet = 0.0;
    EXPECT_EQ(whole.ask(dry).watts("wet_road"), 0.0);
}

TEST(ContactOfHalfSpaces, AveragesTheFluxOverTheContact) {
    // The flux falls as h e^(a^2 t) erfc(a sqrt t), a = h (1/e_a + 1/e_b); Simpson's rule in s = sqrt(t), 1000 intervals.
    const ContactOfHalfSpaces contact{.interface_h = 2.5e4, .effusivity_a = 758.0, .effusivity_b = 1576.0};
    const double a = 2.5e4 * (1.0 / 758.0 + 1.0 / 1576.0);
    for (const double duration : {1e-5, 1e-3, 3.5e-3, 0.1}) {
        const double end = std::sqrt(duration);
        double sum = 0.0;
        for (int i = 0; i <= 1000; ++i) {
            const double s = end * i / 1000.0;
            const double weight = i == 0 || i == 1000 ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
            sum += weight * 2.0 * s * 2.5e4 * std::exp(a * a * s * s) * std::erfc(a * s);
        }
        EXPECT_NEAR(contact.mean_conductance(duration) / (sum * end / 3000.0 / duration), 1.0, 1e-9) << duration;
    }
}

TEST(ContactOfHalfSpaces, HasTheInterfaceAndTheHalfSpacesAsItsLimits) {
    const ContactOfHalfSpaces contact{.interface_h = 2.5e4, .effusivity_a = 758.0, .effusivity_b = 1576.0};
    EXPECT_NEAR(contact.mean_conductance(0.0), 2.5e4, 1e-9);
    const double e = 1.0 / (1.0 / 758.0 + 1.0 / 1576.0);
    const double t = 1e6;  // sqrt(tau) = 49 000: the interface counts for 2e-5
    EXPECT_NEAR(contact.mean_conductance(t) * std::sqrt(std::numbers::pi * t) / (2.0 * e), 1.0, 1e-4);
    // Both branches meet: of the closed form at sqrt(tau) = 1e-3, of e^(x^2) erfc(x) at 20.
    const double joint = 1e-6 / std::pow(2.5e4 / e, 2);
    EXPECT_NEAR(contact.mean_conductance(0.999 * joint) / contact.mean_conductance(1.001 * joint), 1.0, 2e-6);
    EXPECT_NEAR(scaled_erfc(20.0) / (std::exp(399.9) * std::erfc(std::sqrt(399.9))), 1.0, 2e-4);
}

TEST(ResolvedContact, IsSixteenTimesTheLumpedContact) {
    // l(4 kN) = 96.7 mm, t = 96.7/27778 = 3.48 ms; e = 757.8 and 1576.1, a = 48.85, sqrt(tau) = 2.882:
    // (0.1852 - 1 + 3.252)/8.31 * 2.5e4 = 7336 W/m2K on 93.32 cm2 between fresh half-spaces, 68.4 W/K. A revolution of
    // 2 pi 0.3233/27.778 = 73.1 ms leaves the tread's surface zeta(1/2) t h / (e sqrt(pi P)) = -1.46 * 3.48e-3 * 7336 /
    // (757.8 * 0.4793) = 10.3 % above its mean: 68.4/(1 - 0.103) = 76.2 W/K, against 4.67.
    Whole whole(two_nodes(), {{"resolved_contact"}});
    whole.ask(rolling());
    EXPECT_NEAR(whole.system().terms().node_G[0], 76.2, 0.3);
    EXPECT_NEAR(whole.watts("resolved_contact"), -12.0 * whole.system().terms().node_G[0], 1e-9);
    Inputs rest = rolling();
    rest.speed = 0.0;
    EXPECT_EQ(whole.ask(rest).watts("resolved_contact"), 0.0);
}

TEST(ContactPressureConductance, CorrectsTheContactBothWays) {
    // Hc S_cont = 500 * 2.333e-6 Fz. At 6000 N 6.999 ((6000/4500)^0.95 - 1) = 6.999 * 0.314287 = 2.19970 W/K; at 3000 N
    // 3.4995 * ((2/3)^0.95 - 1) = 3.4995 * -0.319690 = -1.11875 W/K. 12 K above the road.
    Whole whole(two_nodes(), {{"road_contact"}, {"contact_pressure_conductance"}});
    Inputs in = rolling();
    in.vertical_load = 6000.0;
    EXPECT_NEAR(whole.ask(in).watts("contact_pressure_conductance"), -12.0 * 2.19970, 1e-3);
    in.vertical_load = 3000.0;
    EXPECT_NEAR(whole.ask(in).watts("contact_pressure_conductance"), 12.0 * 1.11875, 1e-3);
    Whole without(two_nodes(), {{"contact_pressure_conductance"}});
    EXPECT_EQ(without.ask(in).watts("contact_pressure_conductance"), 0.0);
}

TEST(RadiationEffect, FollowsTheFourthPower) {
    // 0.95 * 5.670374419e-8 * (350^4 - 300^4) = 371.99 W/m2 on 9 cm2
    Bench bench = specimen();
    bench.T.assign(bench.T.size(), 350.0);
    const double flux = 0.95 * 5.670374419e-8 * (std::pow(350.0, 4) - std::pow(300.0, 4));
    EXPECT_NEAR(flux, 372.0, 0.1);
    EXPECT_NEAR(bench.watts(bench.active("radiation"), {.air_temperature = 300.0}), -flux * 9e-4, 1e-12);
}

TEST(NaturalConvectionEffect, FollowsTheQuarterPowerAndOnlyAtRest) {
    // 1.32 (50 K / 0.66 m)^0.25 = 3.894 W/m2K
    Bench bench = specimen();
    bench.T.assign(bench.T.size(), 350.0);
    const ActiveEffect effect = bench.active("natural_convection");
    const double h = 1.32 * std::pow(50.0 / 0.66, 0.25);
    EXPECT_NEAR(h, 3.894, 1e-3);
    EXPECT_NEAR(bench.watts(effect, {.air_temperature = 300.0}), -50.0 * h * 9e-4, 1e-12);
    EXPECT_EQ(bench.watts(effect, {.speed = 20.0, .air_temperature = 300.0}), 0.0);
}

TEST(NaturalConvectionEffect, KnowsChurchillAndChu) {
    // D = 0.66 m, 50 K in air of 300 K: Ra = 9.80665 * 50 * 0.287496/(300 * 1.589e-5 * 2.25e-5) = 1.31430e9,
    // Ra^(1/6) = 33.0965; Pr = 0.70622, (1 + (0.559/Pr)^(9/16))^(8/27) = 1.20507; Nu = (0.60 + 10.6288)^2 = 126.085, so
    // h = 126.085 * 0.0263/0.66 = 5.02429 W/m2K. The slope against a difference, as the contract tests the standard law.
    Bench bench = specimen();
    ActiveEffect effect = bench.active("natural_convection");
    effect.choices = {1};
    bench.T.assign(bench.T.size(), 350.0);
    const Inputs in{.air_temperature = 300.0};
    EXPECT_NEAR(bench.watts(effect, in), -50.0 * 5.02429 * 9e-4, 1e-6);
    const int node = bench.mesh.patches[static_cast<std::size_t>(bench.mesh.find_patch("top"))].faces.front().node;
    const auto n = static_cast<std::size_t>(node);
    const Terms terms = bench.said(effect, in, bench.T);
    const double slope = terms.node_slope[n] - terms.node_G[n];
    std::vector<double> up = bench.T;
    std::vector<double> down = bench.T;
    up[n] += 1e-3;
    down[n] -= 1e-3;
    EXPECT_NEAR(slope, (bench.said(effect, in, up).node_q[n] - bench.said(effect, in, down).node_q[n]) / 2e-3,
                1e-7 * std::abs(slope));
}

}  // namespace tiretherm::physics
