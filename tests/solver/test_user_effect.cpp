// SPDX-License-Identifier: BSD-3-Clause
// Effects of the user's own in whole runs, switched on as a diagnosis does it.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/sensitivity/slopes.hpp"
#include "solver/time_integration/march.hpp"
#include "solver/user_effect.hpp"

namespace tiretherm::solver {

namespace {

MarchReport run_closed(const Problem& problem) {
    MarchReport report = run(problem, [](const Snapshot&) { return true; });
    EXPECT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_LT(report.energy_closure, 1e-10);
    return report;
}

/// A signal between 0 and 1 that nothing can foresee.
SignalHistory rough_walk(double end, double interval) {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> noise(0.0, 1.0);
    SignalHistory walk;
    for (double t = 0.0; t <= end; t += interval) {
        walk.time.push_back(t);
        walk.value.push_back(noise(engine));
    }
    return walk;
}

/// By the trapezoidal rule, which is exact for straight lines.
double integral(const SignalHistory& history) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < history.time.size(); ++i) {
        sum += 0.5 * (history.value[i] + history.value[i + 1]) * (history.time[i + 1] - history.time[i]);
    }
    return sum;
}

UserEffect heat(std::string place, SignalHistory history, double watts) {
    return {.name = "throttle_heat",
            .follows = "throttle",
            .places = {std::move(place)},
            .signal = std::move(history),
            .amount = watts};
}

}  // namespace

// Inputs without any log learn the samples of the signal: the heat given is watts times the area under its straight
// lines, however long the steps are.
TEST(UserEffect, GivesTheIntegralOfItsSignal) {
    const SignalHistory walk = rough_walk(600.0, 1.5);
    for (const std::optional<double> fixed_step : {std::optional<double>(), std::optional<double>(40.0)}) {
        Problem problem = two_node_tire();
        problem.settings.fixed_step = fixed_step;
        const std::size_t user_effect = add_user_effect(problem, heat("bulk", walk, 250.0));
        const MarchReport report = run_closed(problem);
        EXPECT_NEAR(report.joules[user_effect], 250.0 * integral(walk), 1e-10 * 250.0 * integral(walk));
        EXPECT_LT(report.steps, 400);
    }
}

// The same where every input is a log and the run does not start at 0 s: the signal is given in the run's own time.
TEST(UserEffect, CountsFromTheRunsStart) {
    const SignalHistory walk = rough_walk(100.0, 2.0);
    SignalHistory later = walk;
    for (double& t : later.time) {
        t += 1000.0;
    }
    Problem problem = two_node_tire();
    problem.settings.start = 1000.0;
    problem.settings.end = 1100.0;
    problem.input_signals = {};
    for (const std::string_view name : {"speed", "vertical_load", "air_temperature", "road_temperature"}) {
        const physics::Signal* signal = physics::find_signal(name);
        const double value = two_node_tire().input_signals.constants().*signal->member;
        problem.input_signals.add(Series{
            .signal = signal, .time = {1000.0, 1033.0, 1100.0}, .value = {value, 1.01 * value, value}, .logged = true});
    }
    problem.input_signals.start_at(1000.0);
    const physics::Inputs before = problem.input_signals.at(1017.0, JumpSide::before);
    const std::size_t user_effect = add_user_effect(problem, heat("surface", later, -40.0));
    EXPECT_EQ(problem.input_signals.at(1017.0, JumpSide::before), before);
    EXPECT_TRUE(problem.input_signals.stops().empty()) << "the log's samples bound no step";
    EXPECT_NEAR(run_closed(problem).joules[user_effect], -40.0 * integral(walk), 1e-10 * 40.0 * integral(walk));
}

// Half of the light of a laser, which layers take whole, and a user heat source of 500 W at a signal of 1 that follows
// a thousandth of the same log: the same run.
TEST(UserEffect, EqualsTheLaserThatFollowsTheSameLog) {
    const SignalHistory walk = rough_walk(1000.0, 1.0);
    Problem with_laser = strip(8);
    act(with_laser, "laser", {{"absorptivity", 0.5}});
    with_laser.effects.back().patches = {0};
    SignalHistory power = walk;
    for (double& watts : power.value) {
        watts *= 1000.0;
    }
    with_laser.input_signals.add(Series{
        .signal = physics::find_signal("laser_power"), .time = power.time, .value = power.value, .logged = true});
    Problem with_own = strip(8);
    add_user_effect(with_own, heat("surface", walk, 500.0));
    const MarchReport one = run_closed(with_laser);
    const MarchReport other = run_closed(with_own);
    EXPECT_GT(one.channel_final[0], 303.0);
    EXPECT_EQ(one.steps, other.steps);
    EXPECT_NEAR(one.channel_final[0], other.channel_final[0], 1e-9);
}

// 12 W/K between bulk and air at a signal of 0.5 is the catalogue's sidewall of 6 W/K; given the air's temperature as a
// signal it is the same again.
TEST(UserEffect, EqualsTheSidewallOfTheSameConductance) {
    Problem sidewall = two_node_tire();
    act(sidewall, "sidewall_convection", {{"conductance", 6.0}});
    const MarchReport expected = run_closed(sidewall);
    UserEffect user_effect{.name = "wall",
                           .follows = "0.5",
                           .places = {"bulk"},
                           .exchange = true,
                           .signal = {{0.0}, {0.5}},
                           .amount = 12.0};
    for (const SignalHistory& surroundings : {SignalHistory{}, SignalHistory{{0.0, 600.0}, {296.15, 296.15}}}) {
        user_effect.surroundings = surroundings;
        Problem problem = two_node_tire();
        const std::size_t e = add_user_effect(problem, user_effect);
        const MarchReport report = run_closed(problem);
        // Samples at both ends of the run may end steps elsewhere: the tolerance of a step is 0.01 K.
        EXPECT_NEAR(report.channel_final[0], expected.channel_final[0], 0.01);
        EXPECT_NEAR(report.channel_final[1], expected.channel_final[1], 0.01);
        EXPECT_NEAR(report.joules[e], expected.joules.back(), 1e-3 * std::abs(expected.joules.back()));
    }
}

// The same sidewall as a law of the calling program, which says how its heat follows the temperature.
TEST(UserEffect, LawOfTheCallingProgramEqualsTheSidewall) {
    Problem sidewall = two_node_tire();
    act(sidewall, "sidewall_convection", {{"conductance", 6.0}});
    const MarchReport expected = run_closed(sidewall);
    const auto law = std::make_shared<const physics::OwnLaw>(
        physics::OwnLaw{[](const physics::EvaluationState& m, physics::Terms& terms) {
            const auto bulk = static_cast<std::size_t>(m.active.nodes.front());
            terms.heat(m.active.nodes.front(), m.coefficients[0] * (296.15 - m.temperature[bulk]), -m.coefficients[0]);
        }});
    Problem problem = two_node_tire();
    const std::size_t e = add_user_effect(problem, heat("bulk", {{0.0}, {0.5}}, 12.0));
    ASSERT_TRUE(give_law(problem, "throttle_heat", law));
    const MarchReport report = run_closed(problem);
    // Both steps keep to the tolerance of 0.01 K.
    EXPECT_NEAR(report.channel_final[0], expected.channel_final[0], 0.01);
    EXPECT_NEAR(report.channel_final[1], expected.channel_final[1], 0.01);
    EXPECT_NEAR(report.joules[e], expected.joules.back(), 1e-3 * std::abs(expected.joules.back()));

    Problem read_again = two_node_tire();
    add_user_effect(read_again, heat("bulk", {{0.0}, {0.5}}, 12.0));
    take_laws(problem, read_again);
    EXPECT_EQ(run_closed(read_again).channel_final, report.channel_final);
    EXPECT_FALSE(give_law(problem, "air_convection", law)) << "no source of the user's";
}

// Nothing until 200 s, then 1 for 400 s: a jump takes a millisecond, half of which is lost.
TEST(UserEffect, JumpsWhereItsSignalJumps) {
    Problem problem = two_node_tire();
    const std::size_t user_effect =
        add_user_effect(problem, heat("bulk", {{0.0, 200.0, 200.0, 600.0}, {0.0, 0.0, 1.0, 1.0}}, 100.0));
    const MarchReport report = run_closed(problem);
    EXPECT_NEAR(report.joules[user_effect], 100.0 * (400.0 - 0.5e-3), 1e-7);
}

// A user's signal is no input: a case without any has none afterwards, no series either, and its steps still see the
// signal: one ends on either end of the jump at 10 s.
TEST(UserEffect, AddsNoInputToACaseWithoutInputs) {
    Problem problem;
    problem.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{.name = "rubber", .thickness = 0.01, .cells = 8}}});
    problem.materials = {material(physics::Curve::constant(0.29))};
    act(problem, "conduction");
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 300.0);
    problem.settings.end = 20.0;
    const std::size_t user_effect =
        add_user_effect(problem, heat("rubber", {{0.0, 10.0, 10.0, 20.0}, {0.0, 0.0, 1.0, 1.0}}, 1000.0));
    EXPECT_TRUE(problem.input_signals.series().empty());
    for (const physics::Signal& signal : physics::signals()) {
        EXPECT_FALSE(problem.input_signals.gives(signal)) << signal.name;
    }
    EXPECT_EQ(problem.input_signals.stops(), (std::vector<double>{10.0, 10.001}));
    EXPECT_EQ(problem.input_signals.samples(), (std::vector<double>{0.0, 10.0, 10.001, 20.0}));
    std::vector<double> times;
    const MarchReport report = run(problem, [&](const Snapshot& snapshot) {
        times.push_back(snapshot.time);
        return true;
    });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    for (const double stop : {10.0, 10.001}) {
        EXPECT_EQ(std::ranges::count(times, stop), 1) << stop;
    }
    EXPECT_NEAR(report.joules[user_effect], 1000.0 * (10.0 - 0.5e-3), 1e-7);
    EXPECT_LT(report.energy_closure, 1e-10);
}

// A missing sample is bridged: between 0 at 0 s and 1 at 100 s the mean is a half.
TEST(UserEffect, BridgesMissingSamples) {
    Problem problem = two_node_tire();
    const double missing = std::nan("");
    const std::size_t user_effect =
        add_user_effect(problem, heat("bulk", {{0.0, 50.0, 100.0, 600.0}, {0.0, missing, 1.0, missing}}, 10.0));
    EXPECT_NEAR(run_closed(problem).joules[user_effect], 10.0 * (50.0 + 500.0), 1e-7);
}

TEST(UserEffect, HasANumberThatAFitMayMove) {
    const SignalHistory walk = rough_walk(600.0, 20.0);
    Problem problem = two_node_tire();
    add_user_effect(problem, heat("surface", walk, 80.0));
    UserEffect wall{
        .name = "wall", .follows = "throttle", .places = {"bulk"}, .exchange = true, .signal = walk, .amount = 5.0};
    add_user_effect(problem, wall);
    expect_differences(problem, {number(problem, "own_source", "watts"), number(problem, "own_exchange", "conductance"),
                                 number(problem, "air_convection", "lambda_h")});
    // And from where it is absent.
    problem.effects[find_user_effect(problem, "throttle_heat")].parameters = {0.0};
    expect_differences(problem, {number(problem, "own_source", "watts")});
}

TEST(UserEffect, TwoOfThemAreToldApart) {
    Problem problem = two_node_tire();
    UserEffect user_effect = heat("bulk", {{0.0}, {1.0}}, 100.0);
    const std::size_t first = add_user_effect(problem, user_effect);
    user_effect.name = "pad_heat";
    user_effect.amount = 30.0;
    const std::size_t second = add_user_effect(problem, user_effect);
    EXPECT_EQ(find_user_effect(problem, "throttle_heat"), first);
    EXPECT_EQ(find_user_effect(problem, "pad_heat"), second);
    EXPECT_EQ(find_user_effect(problem, "own_source"), problem.effects.size());
    EXPECT_EQ(problem.effects[second].title(), "pad_heat");
    const MarchReport report = run_closed(problem);
    EXPECT_NEAR(report.joules[first], 100.0 * 600.0, 1e-6);
    EXPECT_NEAR(report.joules[second], 30.0 * 600.0, 1e-6);
}

TEST(UserEffect, SaysWhatIsWrongAndLeavesTheProblemAlone) {
    Problem problem = two_node_tire();
    const std::size_t before = problem.effects.size();
    const UserEffect wrong{.name = "conduction",
                           .follows = "-1",
                           .places = {"surface", "moon"},
                           .exchange = true,
                           .signal = {{0.0, 5.0}, {1.0, -1.0}},
                           .amount = 3.0,
                           .surroundings = {{0.0}, {std::nan("")}}};
    const std::vector<UserEffectDefect> expected{
        {"the name \"conduction\" is empty or taken"},
        {"the mesh has no region, layer, zone or patch \"moon\""},
        {"the signal is -1 at 5 s: a conductance cannot be negative", true},
        {"the temperature of the surroundings is not a finite number at any time"}};
    EXPECT_EQ(defects(problem, wrong), expected);
    EXPECT_THROW(add_user_effect(problem, wrong), std::invalid_argument);
    EXPECT_EQ(problem.effects.size(), before);
    EXPECT_TRUE(problem.input_signals.samples().empty());
    EXPECT_TRUE(defects(problem, heat("bulk", {{0.0, 5.0}, {1.0, -1.0}}, -3.0)).empty());
    EXPECT_FALSE(defects(problem, heat("bulk", {}, 1.0)).empty());
}

}  // namespace tiretherm::solver
