// SPDX-License-Identifier: BSD-3-Clause
// What `tiretherm inputs` says of signs, derived from the laws themselves: heat, shoulders, Magic Formula, brush.

#include "physics/conventions.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"
#include "physics/tire_laws/brush.hpp"
#include "physics/tire_laws/magic_formula.hpp"

namespace tiretherm::physics {
namespace {

/// All effects that read an input of the drive and can act on a section.
const std::vector<Part> every_reader{{"strain_energy_loss"}, {"sliding_friction"}, {"air_convection"},
                                     {"road_contact"},       {"cornering_loss"},   {"wet_road"},
                                     {"groove_convection"}};

std::vector<double> flows(const Inputs& inputs) {
    const Bench bench = section();
    Whole whole(bench, every_reader);
    whole.ask(inputs);
    return {whole.system().heat_flow().begin(), whole.system().heat_flow().end()};
}

MagicFormula law_of(double pKy1) {
    MagicFormula law;
    law.pCy1 = 1.3, law.pDy1 = 1.0, law.pKy1 = pKy1, law.pKy2 = 2.0;
    law.pCx1 = 1.6, law.pDx1 = 1.1, law.pKx1 = 22.0;
    return law;
}

}  // namespace

TEST(Conventions, EveryInputHasOne) {
    for (const Signal& signal : signals()) {
        EXPECT_GT(sign_convention(signal).size(), 20U) << signal.name;
        EXPECT_TRUE(sign_convention(signal).ends_with('.')) << signal.name;
    }
}

// "Heat takes the magnitude": turning the sign of one input alone changes no watt.
TEST(Conventions, HeatTakesTheMagnitudeOfSlipForcesAndSpeed) {
    const std::vector<double> expected = flows(rolling());
    for (double Inputs::*member :
         {&Inputs::speed, &Inputs::slip_angle, &Inputs::lateral_force, &Inputs::longitudinal_force}) {
        Inputs turned = rolling();
        turned.*member = -(turned.*member);
        EXPECT_EQ(flows(turned), expected);
    }
    for (const Signal& signal : signals()) {  // the sentence stands where it holds
        const bool said = sign_convention(signal).find("Heat takes the magnitude") != std::string_view::npos;
        const bool holds = signal.member == &Inputs::speed || signal.member == &Inputs::slip_angle ||
                           signal.member == &Inputs::lateral_force || signal.member == &Inputs::longitudinal_force;
        EXPECT_EQ(said, holds) << signal.name;
    }
}

// Zones go from outboard to inboard, along a meridian that counts from minus to plus: the outside shoulder is at negative arc
// lengths. Positive camber, the top leaning outboard, heats it, and cools the inside one by as much.
TEST(Conventions, PositiveCamberHeatsTheOutsideShoulder) {
    const Bench bench = section();
    EXPECT_LT(bench.mesh.columns.front().middle(), 0.0);
    EXPECT_EQ(bench.mesh.zones[static_cast<std::size_t>(bench.mesh.columns[2].zone)], "outside_shoulder");
    EXPECT_EQ(bench.mesh.zones[static_cast<std::size_t>(bench.mesh.columns[8].zone)], "inside_shoulder");
    Whole whole(bench, {{"strain_energy_loss"}, {"camber_asymmetry"}});
    const auto loss = [&](std::size_t column, double camber) {
        Inputs inputs = rolling();
        inputs.camber = camber;
        whole.ask(inputs);
        return whole.flow(bench.mesh.columns[column].first_cell);
    };
    EXPECT_GT(loss(2, 0.05), loss(2, 0.0));
    EXPECT_LT(loss(8, 0.05), loss(8, 0.0));
    EXPECT_NEAR(loss(2, 0.05), loss(8, -0.05), 1e-9 * loss(2, 0.0));
}

// "Positive loads the outside shoulder": the road pulls an outer tire of a bend towards the middle of the car, and heat of sliding
// moves outboard, as under positive camber. By two signs the same in a mirror.
TEST(Conventions, PositiveLateralForceAndCamberSlideOnTheOutsideShoulder) {
    const Bench bench = section();
    Whole whole(bench, {{"sliding_friction"}, {"pressure_across_tread"}});
    const auto heat = [&](std::size_t column, double force, double camber) {
        Inputs inputs = rolling();
        inputs.lateral_force = force;
        inputs.camber = camber;
        whole.ask(inputs);
        return whole.flow(bench.mesh.columns[column].outer);
    };
    EXPECT_GT(heat(2, 2000.0, 0.0), 1.2 * heat(8, 2000.0, 0.0));
    EXPECT_GT(heat(2, 2.0, 0.05), 1.2 * heat(8, 2.0, 0.05));
    EXPECT_NEAR(heat(2, 2000.0, 0.02), heat(8, -2000.0, -0.02), 1e-9 * heat(2, 2000.0, 0.02));
}

// The lateral force has the sign of pKy1 times the slip angle, turned when rolling backwards; the longitudinal force that of
// the slip ratio. Without shifts.
TEST(Conventions, MagicFormulaHasTheSignOfItsStiffness) {
    for (const double pKy1 : {20.0, -20.0}) {
        for (const double slip : {0.05, -0.05}) {
            for (const double speed : {20.0, -20.0}) {
                const double force = law_of(pKy1).lateral({.load = 4000.0, .slip = slip, .speed = speed}).force;
                EXPECT_EQ(force > 0.0, pKy1 * slip * speed > 0.0);
                EXPECT_GT(std::abs(force), 1000.0);
            }
        }
    }
    EXPECT_GT(law_of(20.0).longitudinal({.load = 4000.0, .slip = 0.05}).force, 1000.0);
    EXPECT_LT(law_of(20.0).longitudinal({.load = 4000.0, .slip = -0.05}).force, -1000.0);
}

TEST(Conventions, BrushHasTheSignOfItsSlip) {
    const Brush brush{.half_length = 0.08, .tread_stiffness = 5e6, .friction = 1.0, .load = 4000.0};
    EXPECT_GT(brush.force(0.02), 0.0);
    EXPECT_EQ(brush.force(-0.02), -brush.force(0.02));
    EXPECT_GT(brush.sliding_power(-0.02, 20.0), 0.0);
    EXPECT_EQ(brush.sliding_power(-0.02, 20.0), brush.sliding_power(0.02, -20.0));
}

// Heat flows into the tire from what is warmer, and none from a road that it does not touch. All at 40 degC but air or road.
TEST(Conventions, WarmerAirAndRoadHeatTheTireAndNoLoadIsNoContact) {
    const Bench bench = section();
    Whole whole(bench, {{"air_convection"}, {"road_contact"}});
    const std::vector<double> T(bench.T.size(), 313.15);
    Inputs inputs = rolling();
    inputs.air_temperature = 313.15;
    inputs.road_temperature = 323.15;
    EXPECT_GT(whole.ask(inputs, T).watts("road_contact"), 0.0);
    inputs.vertical_load = 0.0;
    EXPECT_EQ(whole.ask(inputs, T).watts("road_contact"), 0.0);
    inputs.air_temperature = 323.15;
    EXPECT_GT(whole.ask(inputs, T).watts("air_convection"), 0.0);
    inputs.air_temperature = 303.15;
    EXPECT_LT(whole.ask(inputs, T).watts("air_convection"), 0.0);
}

}  // namespace tiretherm::physics
