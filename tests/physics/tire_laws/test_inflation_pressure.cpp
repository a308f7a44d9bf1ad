// SPDX-License-Identifier: BSD-3-Clause
// The tire's laws at other inflation pressures, and a wheel that spins on the spot, against hand calculation.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "physics/tire.hpp"
#include "tests/physics/effects/bench.hpp"

namespace tiretherm::physics {
namespace {

Tire at_220() {
    Tire tire;
    tire.reference_pressure = 220e3;
    return tire;
}

Inputs rolling_at(double pressure) {
    return {.speed = 100.0 / 3.6, .vertical_load = 4000.0, .inflation_pressure = pressure};
}

}  // namespace

// Rhyne for 225/50 R17: AR 50, W 225 mm, rim 2 (330.8 - 112.5) = 436.6 mm. sqrt((1.03 - 0.2) 225 (225 + 436.6)) = 351.50;
// 2.8e-4 220 351.50 + 3.45 = 25.102 kgf/mm = 246.17 N/mm.
TEST(InflationPressure, StiffensTheTireAsRhyneFound) {
    EXPECT_NEAR(Tire().vertical_stiffness(220e3), 246.17e3, 20.0);
    EXPECT_NEAR(Tire().vertical_stiffness(0.0), 3.45 * 9806.65, 1e-6) << "what the empty carcass carries";
}

// At 120 kPa the stiffness is 2.8e-4 120 351.50 + 3.45 = 15.260 kgf/mm: 4 kN act as 4000 25.102/15.260 = 6579.8 N do at 220.
TEST(InflationPressure, ContactAndRadiiAreThoseOfTheDeflection) {
    const Tire tire = at_220();
    const Inputs soft = rolling_at(120e3);
    EXPECT_NEAR(tire.reference_load(soft), 6579.8, 1.0);
    EXPECT_NEAR(tire.contact_area(soft), 2.333e-6 * 6579.8, 1e-5);
    EXPECT_NEAR(tire.contact_length(soft), tire.contact_length(6579.8), 1e-5);
    EXPECT_NEAR(tire.loaded_radius(soft), 0.3308 - 4.2e-6 * 6579.8, 1e-6);
    EXPECT_EQ(tire.reference_load(rolling_at(220e3)), 4000.0) << "exactly";
    EXPECT_EQ(Tire().reference_load(soft), 4000.0) << "without a reference the laws are those of the load";
    Inputs lifted = soft;
    lifted.vertical_load = 0.5;
    EXPECT_EQ(tire.contact_area(lifted), 0.0) << "0.5 N is no contact, whatever they deflect";
}

// (120/220)^-0.45 = 1.3136, (350/220)^-0.45 = 0.8115.
TEST(InflationPressure, LossFallsWithIt) {
    const Tire tire = at_220();
    const double at_reference = strain_power(tire, rolling_at(220e3));
    EXPECT_EQ(at_reference, strain_power(tire, 100.0 / 3.6, 4000.0));
    EXPECT_NEAR(strain_power(tire, rolling_at(120e3)) / at_reference, 1.3136, 1e-4);
    EXPECT_NEAR(strain_power(tire, rolling_at(350e3)) / at_reference, 0.8115, 1e-4);
    EXPECT_EQ(tire.pressure_factor_of_loss(0.0), tire.pressure_factor_of_loss(44e3)) << "held below a fifth";
    EXPECT_EQ(Tire().pressure_factor_of_loss(120e3), 1.0);
}

// Gas of 35 degC at 180 kPa above the atmosphere that is 60 degC: 281.325 333.15/308.15 - 101.325 = 202.824 kPa, so that the
// loss is (202.824/180)^-0.45 = 0.94770; in absolute pressures it would be (333.15/308.15)^-0.45 = 0.9655.
TEST(InflationPressure, HotGasCountsAboveTheAtmosphere) {
    const auto loss_at = [](double pressure) {
        Whole whole(two_nodes(), {{"strain_energy_loss"}, {"inflation_pressure_rise", {{"reference", 308.15}}}});
        Inputs inputs = rolling();
        inputs.inflation_pressure = pressure;
        std::vector<double> T(static_cast<std::size_t>(whole.problem().mesh.n_nodes), 333.15);
        const double hot = whole.ask(inputs, T).watts("strain_energy_loss");
        T.back() = 308.15;  // the gas alone
        return hot / whole.ask(inputs, T).watts("strain_energy_loss");
    };
    EXPECT_NEAR(loss_at(180e3), 0.94770, 1e-5);
    EXPECT_NEAR(loss_at(0.0), 0.96551, 1e-5);
}

// A wheel that spins on the spot: 3 kN along at 10 m/s are 0.6 30 kW of heat, and the tire deflects at 10 m/s.
TEST(SlipSpeed, SpinningOnTheSpotHeats) {
    Whole whole(two_nodes(), {{"strain_energy_loss"}, {"sliding_friction"}, {"air_convection"}});
    Inputs inputs = rolling();
    inputs.lateral_force = 0.0;
    inputs.slip_ratio = 0.0;
    inputs.speed = 0.0;
    inputs.longitudinal_force = 3000.0;
    EXPECT_EQ(whole.ask(inputs).watts("sliding_friction"), 0.0);
    EXPECT_EQ(whole.ask(inputs).watts("strain_energy_loss"), 0.0);
    inputs.slip_speed = 10.0;
    EXPECT_NEAR(whole.ask(inputs).watts("sliding_friction"), 18e3, 1e-6);
    const double spinning = whole.ask(inputs).watts("strain_energy_loss");
    inputs.speed = 10.0;
    inputs.slip_speed = 0.0;
    EXPECT_NEAR(spinning, whole.ask(inputs).watts("strain_energy_loss"), 1e-9);
    inputs.slip_ratio = 0.3;
    EXPECT_NEAR(whole.ask(inputs).watts("sliding_friction"), 0.6 * 3000.0 * 3.0, 1e-6) << "a ratio of 10 m/s is 3 m/s";
}

// A locked wheel does not turn: nothing is deformed, whichever way its slip is given, and 0.6 3000 N 10 m/s are the heat of
// sliding. A tenth of slip is a tenth of the revolutions, and the thesis's V stays to be had.
TEST(SlipRatio, ALockedWheelDoesNotRoll) {
    Inputs inputs = rolling();
    inputs.lateral_force = 0.0;
    inputs.slip_ratio = 0.0;
    inputs.speed = 10.0;
    inputs.longitudinal_force = -3000.0;
    Whole whole(two_nodes(), {{"strain_energy_loss"}, {"sliding_friction"}});
    const double free = whole.ask(inputs).watts("strain_energy_loss");
    EXPECT_GT(free, 100.0);
    Inputs by_speed = inputs;
    for (const double slip : {-1.0, -0.1, 0.1}) {
        inputs.slip_ratio = slip;
        by_speed.slip_speed = 10.0 * slip;
        const double loss = whole.ask(inputs).watts("strain_energy_loss");
        EXPECT_NEAR(whole.watts("sliding_friction"), 0.6 * 30e3 * std::abs(slip), 1e-9);
        EXPECT_EQ(whole.ask(by_speed).watts("strain_energy_loss"), loss);
        EXPECT_EQ(slip == -1.0, loss == 0.0);
        Inputs slower = rolling();
        slower.slip_ratio = 0.0;
        slower.speed = 10.0 * (1.0 + slip);
        EXPECT_NEAR(whole.ask(slower).watts("strain_energy_loss"), loss, 1e-12 * free);
    }
    Whole of_thesis(two_nodes(), {{"strain_energy_loss", {}, {{"speed", 1}}}, {"sliding_friction"}});
    inputs.slip_ratio = -1.0;
    EXPECT_EQ(of_thesis.ask(inputs).watts("strain_energy_loss"), free);
}

}  // namespace tiretherm::physics
