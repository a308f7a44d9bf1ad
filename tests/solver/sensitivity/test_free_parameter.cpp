// SPDX-License-Identifier: BSD-3-Clause
// Values of free parameters change laws, effects and initial temperatures as computed by hand.

#include "solver/sensitivity/free_parameter.hpp"

#include <gtest/gtest.h>

#include "solver/bench.hpp"

namespace tiretherm::solver {

namespace {

using physics::Curve;
using Kind = FreeParameter::Kind;

/// The law of the only layer, free at these temperatures.
std::vector<FreeParameter> law_at(Kind kind, const std::vector<double>& knots) {
    std::vector<FreeParameter> numbers;
    for (std::size_t k = 0; k < knots.size(); ++k) {
        FreeParameter number;
        number.kind = kind;
        number.layers = {0};
        number.knots = knots;
        number.knot = k;
        numbers.push_back(number);
    }
    return numbers;
}

void move_to(Problem& problem, const FreeParameter& number, double to) {
    move(problem, number, value_of(problem, number), to);
}

}  // namespace

// The parabola through (300, 0.2), (340, 0.3), (380, 0.5): first differences 0.0025 and 0.005 per K, second
// 0.0025/80 = 3.125e-5; at 320 K: 0.2 + 20 * 0.0025 + 3.125e-5 * 20 * (-20) = 0.2375.
TEST(FreeParameter, ThreeValuesMakeALawTheParabolaThroughThem) {
    Problem problem = strip(4);
    const std::vector<FreeParameter> numbers = law_at(Kind::conductivity, {300.0, 340.0, 380.0});
    EXPECT_NEAR(value_of(problem, numbers[1]), 0.29, 1e-15);
    move_to(problem, numbers[2], 0.5);
    move_to(problem, numbers[0], 0.2);
    move_to(problem, numbers[1], 0.3);
    const Curve& law = problem.materials[0].along(mesh::Axis::through);
    EXPECT_NEAR(law.value(300.0), 0.2, 1e-13);
    EXPECT_NEAR(law.value(340.0), 0.3, 1e-13);
    EXPECT_NEAR(law.value(380.0), 0.5, 1e-13);
    EXPECT_NEAR(law.value(320.0), 0.2375, 1e-13);
    EXPECT_EQ(problem.materials[0].along(mesh::Axis::meridian), law);  // they were one law and stay one
}

// Two values tilt a law and leave its curvature: 0.3 + 1e-5 (T - 300)^2 is 0.316 at 340 K and 0.304 at 320 K. Raised by
// 0.04 at 340 K and not at 300 K it has 0.304 + 0.02 at 320 K.
TEST(FreeParameter, TwoValuesAddALine) {
    Problem problem = strip(4);
    problem.materials[0].heat_capacity = Curve::quadratic_about(300.0, 0.3, 0.0, 1e-5);
    const std::vector<FreeParameter> numbers = law_at(Kind::heat_capacity, {300.0, 340.0});
    EXPECT_NEAR(value_of(problem, numbers[1]), 0.316, 1e-13);
    move_to(problem, numbers[1], 0.356);
    EXPECT_NEAR(problem.materials[0].heat_capacity.value(300.0), 0.3, 1e-12);
    EXPECT_NEAR(problem.materials[0].heat_capacity.value(320.0), 0.324, 1e-12);
    EXPECT_NEAR(problem.materials[0].heat_capacity.coefficients()[2], 1e-5, 1e-18);
}

// One value scales a law, a table too: 1 and 3 become 2 and 6 when the 2 in the middle becomes 4.
TEST(FreeParameter, OneValueScalesALaw) {
    Problem problem = strip(4);
    problem.materials[0].heat_capacity = Curve::table({300.0, 400.0}, {1.0, 3.0});
    const FreeParameter number = law_at(Kind::heat_capacity, {350.0}).front();
    move_to(problem, number, 4.0);
    EXPECT_NEAR(problem.materials[0].heat_capacity.value(300.0), 2.0, 1e-14);
    EXPECT_NEAR(problem.materials[0].heat_capacity.value(400.0), 6.0, 1e-14);
}

// A conductivity along the meridian that is a law of its own is not that through the thickness.
TEST(FreeParameter, AnotherLawAlongTheMeridianStays) {
    Problem problem = strip(4);
    const Curve own = Curve::constant(1.5);
    problem.materials[0].conductivity[static_cast<std::size_t>(mesh::Axis::meridian)] = own;
    move_to(problem, law_at(Kind::conductivity, {350.0}).front(), 0.58);
    EXPECT_EQ(problem.materials[0].along(mesh::Axis::meridian), own);
    EXPECT_NEAR(problem.materials[0].along(mesh::Axis::circumference).value(300.0), 0.58, 1e-15);
}

TEST(FreeParameter, LinkOfTwoLumpsIsALawOfItsOwn) {
    Problem problem = two_node_tire();
    FreeParameter number;
    number.kind = Kind::link_conductivity;
    number.knots = {350.0};
    const double before = value_of(problem, number);
    const double of_rubber = problem.materials[0].along(mesh::Axis::through).value(350.0);
    move_to(problem, number, 2.0 * before);
    EXPECT_NEAR(problem.link_laws[0].value(350.0), 2.0 * before, 1e-14);
    EXPECT_EQ(problem.materials[0].along(mesh::Axis::through).value(350.0), of_rubber);
}

// Everywhere is what places without a value of their own have; a place gets one when it is moved, and keeps it.
TEST(FreeParameter, AParameterOfAnEffectMovesEverywhereOrAtAPlace) {
    Problem problem = strip(4);
    FreeParameter everywhere;
    everywhere.effect = 1;  // still air, after conduction
    everywhere.parameter = 0;
    FreeParameter inside = everywhere;
    inside.everywhere = false;
    inside.place = 1;
    EXPECT_EQ(value_of(problem, inside), 20.0);
    move_to(problem, inside, 35.0);
    move_to(problem, everywhere, 10.0);
    EXPECT_EQ(value_of(problem, everywhere), 10.0);
    EXPECT_EQ(value_of(problem, inside), 35.0);
    move_to(problem, inside, 36.0);
    EXPECT_EQ(problem.effects[1].overrides.size(), 1U);  // not a second value for one place
    EXPECT_EQ(problem.effects[1].on_patch(0, 0), 10.0);
    EXPECT_EQ(problem.effects[1].on_patch(0, 1), 36.0);
}

TEST(FreeParameter, AnInitialTemperatureIsAShiftOfItsNodes) {
    Problem problem = strip(4);
    FreeParameter number;
    number.kind = Kind::initial;
    number.nodes = {0, 2};
    EXPECT_EQ(value_of(problem, number), 0.0);
    move(problem, number, 0.0, 3.0);
    move(problem, number, 3.0, -1.5);
    EXPECT_EQ(problem.initial[0], 298.5);
    EXPECT_EQ(problem.initial[1], 300.0);
    EXPECT_EQ(problem.initial[2], 298.5);
}

// A difference quotient needs a step that is neither nothing nor more than the number itself bears.
TEST(FreeParameter, AStepIsSmallBesideTheNumberAndWhatIsKnownOfIt) {
    FreeParameter number;
    EXPECT_NEAR(typical_step(number, -50.0), 5e-3, 1e-15);
    number.standard_deviation = 0.2;
    EXPECT_NEAR(typical_step(number, 0.0), 2e-5, 1e-18);
    FreeParameter bounded;
    bounded.low = 0.0;
    bounded.high = 1e4;
    EXPECT_NEAR(typical_step(bounded, 0.0), 1e-3, 1e-15);
    bounded.prior = 15.0;  // a number that a fit has driven to almost nothing is still one of about its prior
    EXPECT_NEAR(typical_step(bounded, 1e-12), 1.5e-3, 1e-15);
    FreeParameter initial;
    initial.kind = Kind::initial;
    EXPECT_NEAR(typical_step(initial, 0.0), 1e-4, 1e-18);
}

}  // namespace tiretherm::solver
