// SPDX-License-Identifier: BSD-3-Clause
// The swing of the tread's surface temperature within a revolution, against half-space formulas.

#include <cmath>

#include <gtest/gtest.h>

#include "physics/contact/contact_in_revolutions.hpp"
#include "solver/time_integration/march.hpp"
#include "tests/support/tire_section.hpp"

namespace tiretherm::solver {

// A tread of 60 degC on a road of 23 degC at 100 km/h and 4 kN, 2 kN across at 2 degrees. The road takes its part of the 37
// K; 0.6 * 2000 * 27.78 tan(2 deg) = 1164 W of friction on 93.32 cm2 are 124.7 kW/m2. Without a road that is at
// the exit 2 sqrt(3.48 ms/pi)/757.8, less the mean of the revolution: 10.9 K less 1.46 * 3.48 ms/(757.8 * 0.4793) * 124.7e3 =
// 1.75 K. With the road, e_b = 1576, beta = 2.5e4 (1/757.8 + 1/1576) = 48.9, g = 0.186: it takes 1576/2334 (1 - g) = 0.55 at the
// exit, where fresh half-spaces have 0.55/2.5e4 + (0.0666 - 0.814/48.9)/2334 = 4.34e-5 K m2/W, 5.41 K. It keeps half of the
// heat, so that the mean of the revolution is 0.9 K, of which the contact leaves 0.45.
TEST(SensorOutputs, TheTreadsSurfaceSwingsInEveryRevolution) {
    Problem problem = support::tire_problem(1);
    problem.effects.erase(problem.effects.begin() + 4);
    ASSERT_EQ(problem.effects[4].effect->id, "sidewall_convection") << "the lumped contact is gone";
    const mesh::Functional surface =
        problem.mesh.regions[static_cast<std::size_t>(problem.mesh.find_region("surface"))].mean;
    for (const Quantity quantity : {Quantity::temperature, Quantity::surface_at_entry, Quantity::surface_at_exit}) {
        problem.channels.push_back({.name = "c", .meaning = "", .where = surface, .quantity = quantity});
    }
    support::start_at(problem, 333.15);
    problem.settings.end = 1.0;
    std::vector<double> first;
    const auto keep_first = [&](const Snapshot& now) {
        if (first.empty()) {
            first.assign(now.channels.begin(), now.channels.end());
        }
        return true;
    };
    (void)support::run_closed(problem, keep_first);
    EXPECT_EQ(first[1], first[0]) << "without the effect nothing is known of the contact";

    support::switch_on(problem, "resolved_contact");
    first.clear();
    (void)support::run_closed(problem, keep_first);
    const physics::ContactInRevolutions contact = *physics::contact_in_revolutions(
        problem.effects.back(), std::sqrt(0.29 * 1.98e6), problem.tire, problem.input_signals.constants());
    EXPECT_EQ(first[0], 333.15);
    EXPECT_NEAR(first[1] - first[0], (first[0] - 296.15) * contact.at_entry(), 1e-9);
    EXPECT_NEAR(first[2] - first[0], (first[0] - 296.15) * contact.at_exit(), 1e-9);
    EXPECT_GT(first[1] - first[2], 10.0);

    support::hold(problem, "lateral_force", 2000.0);
    support::hold(problem, "slip_angle", 2.0 * support::deg);
    first.clear();
    (void)support::run_closed(problem, keep_first);
    const double heated = first[2] - first[0] - (first[0] - 296.15) * contact.at_exit();
    EXPECT_NEAR(heated, 5.41 - 0.45 * 0.9, 0.1);

    // Half the exchange, half the swing that it makes, also of the heat of sliding.
    problem.effects.back().parameters[0] = 0.5;
    first.clear();
    (void)support::run_closed(problem, keep_first);
    const double by_half = heated * contact.heated_at_exit(0.5) / contact.heated_at_exit();
    EXPECT_NEAR(first[2] - first[0], 0.5 * (first[0] - 296.15) * contact.at_exit() + by_half, 1e-9);
    EXPECT_NEAR(by_half, 0.5 * (heated + 10.9 - 1.75), 0.1) << "between that with the whole road and that without one";
}

}  // namespace tiretherm::solver
