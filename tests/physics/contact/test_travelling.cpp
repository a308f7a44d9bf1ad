// SPDX-License-Identifier: BSD-3-Clause
// Travelling contact: conductance of two half-spaces, times of contact, and the same exchange at every wheel angle.

#include "physics/contact/travelling.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "mesh/ring.hpp"
#include "physics/tire_laws/contact.hpp"
#include "solver/system.hpp"
#include "tests/support/tire_section.hpp"

namespace tiretherm::physics {

namespace {

using std::numbers::pi;

Inputs rolling_at_angle(double wheel_angle) {
    Inputs in;
    in.speed = 100.0 / 3.6;
    in.vertical_load = 4000.0;
    in.road_temperature = 296.15;
    in.wheel_angle = wheel_angle;
    return in;
}

const ContactOfHalfSpaces surfaces{
    .interface_h = 2.5e4, .effusivity_a = std::sqrt(0.29 * 1.98e6), .effusivity_b = std::sqrt(1.2 * 2.07e6)};

}  // namespace

// Two half-spaces: what the conductance of a moment gives at the surface that is left, 1 - e_b/(e_a+e_b) (1 - g), is the
// flux h g, whose mean is that of mean_conductance.
TEST(ContactOfHalfSpaces, GivesAtEachMomentWhatItsMeanIsMadeOf) {
    const double end = 4e-3;
    const double share = surfaces.effusivity_b / (surfaces.effusivity_a + surfaces.effusivity_b);
    const double rate = surfaces.interface_h * (1.0 / surfaces.effusivity_a + 1.0 / surfaces.effusivity_b);
    double mean = 0.0;
    const int n = 4000;
    for (int i = 0; i < n; ++i) {  // the midpoint rule in the root of time
        const double x = (i + 0.5) / n;
        const double left = scaled_erfc(rate * std::sqrt(end) * x);
        mean += 2.0 * x / n * surfaces.conductance_at(end * x * x) * (1.0 - share * (1.0 - left));
    }
    EXPECT_NEAR(mean, surfaces.mean_conductance(end), 1e-6 * mean);
    EXPECT_EQ(surfaces.conductance_at(0.0), surfaces.interface_h);
}

// 4 kN: l = 0.160 - 0.320/(1 + e^1.4) = 0.0967 m on R_R = 0.3483 * 4000^-0.009 = 0.3232 m.
TEST(TravellingContact, MeetsThePlaceAtAngleZeroHalfATurnAfterTheStart) {
    const Tire tire;
    const double length = tire.contact_length(4000.0) / tire.rolling_radius(4000.0);
    const TravellingContact start(tire, rolling_at_angle(0.0));
    EXPECT_NEAR(start.length(), length, 1e-15);
    EXPECT_NEAR(start.length(), 0.0967 / 0.3232, 2e-4);
    EXPECT_FALSE(start.part(0, 1).inside);
    EXPECT_FALSE(TravellingContact(tire, rolling_at_angle(pi - 0.51 * length)).part(0, 1).inside);
    EXPECT_FALSE(TravellingContact(tire, rolling_at_angle(pi + 0.51 * length)).part(0, 1).inside);
    for (const double turns : {0.0, 5.0, -3.0, 4e5}) {
        const auto part = TravellingContact(tire, rolling_at_angle(2.0 * pi * turns + pi - 0.25 * length)).part(0, 1);
        EXPECT_TRUE(part.inside) << turns;
        EXPECT_NEAR(part.from, 0.25 * length, 1e-9);
    }
    Inputs back = rolling_at_angle(-pi + 0.25 * length);
    back.speed = -back.speed;
    EXPECT_NEAR(TravellingContact(tire, back).part(0, 1).from, 0.25 * length, 1e-12) << "from the other side";
    Inputs rest = rolling_at_angle(pi);
    rest.speed = 0.0;
    EXPECT_FALSE(TravellingContact(tire, rest).touches());
    Inputs lifted = rolling_at_angle(pi);
    lifted.vertical_load = 0.0;
    EXPECT_FALSE(TravellingContact(tire, lifted).touches());
}

TEST(TravellingContact, LiesWhollyInTheSectorsAtAnyAngle) {
    const Tire tire;
    for (const int sectors : {2, 7, 60}) {
        for (const double angle : {0.0, 0.3, 1.7, pi, 5.9, 123.4}) {
            const TravellingContact contact(tire, rolling_at_angle(angle));
            double held = 0.0;
            double concentrated = 0.0;
            for (int s = 0; s < sectors; ++s) {
                const auto part = contact.part(s, sectors);
                held += part.to - part.from;
                concentrated += concentration(contact, s, sectors) / sectors;
            }
            EXPECT_NEAR(held, contact.length(), 1e-12) << sectors << " sectors, " << angle;
            EXPECT_NEAR(concentrated, 1.0, 1e-12);
        }
    }
}

namespace {

solver::Problem ring_with(std::initializer_list<const char*> effects, int sectors) {
    solver::Problem problem = support::tire_problem(1);
    problem.effects.clear();
    problem.mesh = mesh::build(support::tire_section(problem.tire, 1));
    problem.mesh = mesh::ring(problem.mesh, sectors);
    for (const char* id : effects) {
        problem.effects.push_back(activate(in_frames(*find_effect(id)), problem.mesh));
    }
    return problem;
}

/// Sum of an effect's exchanges and heat on a tire of 1 K above the road. W
double watts(const solver::Problem& problem, const Inputs& in, std::size_t effect = 0) {
    solver::System system(problem);
    std::vector<double> coefficients(system.n_coefficients());
    system.evaluate_coefficients(in, coefficients);
    const std::vector<double> T(static_cast<std::size_t>(problem.mesh.n_nodes), in.road_temperature + 1.0);
    system.evaluate(T, coefficients);
    return system.terms().watts[effect];
}

}  // namespace

// A surface that stayed at its temperature would give S times the mean of the conductances of each moment: by the midpoint
// rule in the root of time, as above. It does so at every angle, wherever the sectors' borders lie.
TEST(TravellingContactOnARing, ExchangesTheSameAtEveryAngle) {
    const solver::Problem problem = ring_with({"travelling_contact"}, 37);
    const Inputs first = rolling_at_angle(0.0);
    const double duration = problem.tire.contact_length(4000.0) / first.speed;
    double mean = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double x = (i + 0.5) / 4000.0;
        mean += 2.0 * x / 4000.0 * surfaces.conductance_at(duration * x * x);
    }
    const double expected = -mean * problem.tire.contact_area(4000.0);
    for (const double angle : {0.0, 0.01, 0.4, 2.0, 77.7}) {
        EXPECT_NEAR(watts(problem, rolling_at_angle(angle)), expected, 1e-5 * std::abs(expected)) << angle;
    }
}

TEST(SlidingFriction, GoesRoundWithTheContactAndKeepsItsWatts) {
    solver::Problem problem = ring_with({"sliding_friction"}, 24);
    Inputs in = rolling_at_angle(1.234);
    in.lateral_force = 2000.0;
    in.slip_angle = 2.0 * support::deg;
    const double evenly = watts(problem, in);
    problem.effects[0].choices[static_cast<std::size_t>(find_choice(*problem.effects[0].effect, around_key))] =
        in_contact;
    EXPECT_TRUE(travels(problem.effects[0]));
    // 0.6 * 2000 N * 27.78 m/s * tan(2 deg) = 1164.1 W
    EXPECT_NEAR(watts(problem, in), 1164.1, 0.1);
    EXPECT_NEAR(watts(problem, in), evenly, 1e-9);
}

// The road takes the flux e_b / (e_a + e_b) (1 - g) of a heat of one; the rest enters the tread and warms its surface by theta,
// its convolution with 1/(e_a sqrt(pi t)), here by the midpoint rule. Cells that show theta exchange conductance_at theta of it.
TEST(ContactOfHalfSpaces, KeepsWhatTheRoadDoesNotTakeOfTheHeatOfSliding) {
    const double since = 3e-3;
    const double share = surfaces.effusivity_b / (surfaces.effusivity_a + surfaces.effusivity_b);
    const double rate = surfaces.interface_h * (1.0 / surfaces.effusivity_a + 1.0 / surfaces.effusivity_b);
    const auto taken = [&](double t) { return share * (1.0 - scaled_erfc(rate * std::sqrt(t))); };
    double theta = 0.0;
    const int n = 20000;
    for (int i = 0; i < n; ++i) {  // the midpoint rule in the root of the time that is left
        const double x = (i + 0.5) / n;
        theta += 2.0 * std::sqrt(since / pi) / n * (1.0 - taken(since * (1.0 - x * x))) / surfaces.effusivity_a;
    }
    const double expected = 1.0 - taken(since) + surfaces.conductance_at(since) * theta;
    EXPECT_NEAR(surfaces.kept_heat_at(since), expected, 1e-6);
    EXPECT_EQ(surfaces.kept_heat_at(0.0), 1.0);
}

// Heat between the two: cells that show its warmth 2 sqrt(t/pi)/e_a would give conductance_at of that to the road, and nothing
// goes there. 2 sqrt(0.003/pi)/757.8 = 8.155e-5 K m2/W.
TEST(ContactOfHalfSpaces, GivesNothingAwayOfHeatBetweenTheTwo) {
    const double expected = 1.0 + surfaces.conductance_at(3e-3) * 8.1556e-5 * 757.76 / surfaces.effusivity_a;
    EXPECT_NEAR(surfaces.kept_heat_at(3e-3, SlidingHeat::between), expected, 1e-4);
}

// Sectors pass what a column keeps, on the mean over the contact, and the heat budget counts the rest with the road: at every
// angle, wherever the sectors' borders lie. 1164.1 W as above.
TEST(SlidingFriction, OnARingLosesToTheRoadWhatAColumnDoes) {
    solver::Problem problem = ring_with({"travelling_contact", "sliding_friction"}, 37);
    problem.effects[1].choices[static_cast<std::size_t>(find_choice(*problem.effects[1].effect, around_key))] =
        in_contact;
    Inputs in = rolling_at_angle(0.0);
    in.lateral_force = 2000.0;
    in.slip_angle = 2.0 * support::deg;
    const double duration = problem.tire.contact_length(4000.0) / in.speed;
    double kept = 0.0;
    for (int i = 0; i < 4000; ++i) {
        const double x = (i + 0.5) / 4000.0;
        kept += 2.0 * x / 4000.0 * surfaces.kept_heat_at(duration * x * x);
    }
    ASSERT_LT(kept, 0.95);
    const double cold = watts(ring_with({"travelling_contact"}, 37), in);
    for (const double angle : {0.0, 0.01, 0.4, 2.0, 77.7}) {
        in.wheel_angle = angle;
        EXPECT_NEAR(watts(problem, in, 1), 1164.1, 0.1) << angle;
        EXPECT_NEAR(watts(problem, in, 0) - cold, (kept - 1.0) * 1164.1, 0.1) << angle;
    }
}

}  // namespace tiretherm::physics
