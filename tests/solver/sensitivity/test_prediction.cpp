// SPDX-License-Identifier: BSD-3-Clause
// Parameter slopes of the two-node tire against differences of runs, and the report of a parameter at a switch.

#include "solver/bench.hpp"
#include "solver/sensitivity/slopes.hpp"

namespace tiretherm::solver {

TEST(Prediction, SlopesOfTheTwoNodeTireEqualDifferences) {
    const Problem problem = two_node_tire();
    using Kind = FreeParameter::Kind;
    expect_differences(
        problem, {number(problem, "air_convection", "lambda_h"), number(problem, "air_convection", "exponent"),
                  number(problem, "strain_energy_loss", "lambda_blk"), number(problem, "road_contact", "Hc"),
                  law(Kind::link_conductivity, {}, {333.15}, 0), law(Kind::link_conductivity, {}, {300.0, 360.0}, 1),
                  law(Kind::heat_capacity, {1}, {300.0}, 0), start_of(problem)});
}

// A standing wave multiplies the loss by 1 + gain max(0, V - critical speed)^2: at the critical speed the slope to one
// side is zero and to the other not. Ten km/h below the speed nothing bends.
TEST(Prediction, SaysThatANumberStandsAtASwitch) {
    Problem problem = two_node_tire();
    act(problem, "standing_wave", {{"gain", 1e-3}, {"critical_speed", 100.0}});
    const std::vector<double> times{0.0, 300.0, 600.0};
    const std::vector<FreeParameter> numbers{number(problem, "standing_wave", "critical_speed"),
                                             number(problem, "air_convection", "lambda_h")};
    const Prediction at_switch =
        predict(problem, {.times = times, .parameters = numbers, .values = values_of(problem, numbers)});
    ASSERT_TRUE(at_switch.status.ok()) << at_switch.status.message;
    EXPECT_EQ(at_switch.non_smooth_parameters, std::vector<std::string>{"standing_wave.critical_speed"});
    problem.effects.back().parameters[numbers[0].parameter] = 90.0;
    const Prediction beside =
        predict(problem, {.times = times, .parameters = numbers, .values = values_of(problem, numbers)});
    ASSERT_TRUE(beside.status.ok()) << beside.status.message;
    EXPECT_TRUE(beside.non_smooth_parameters.empty());
}

}  // namespace tiretherm::solver
