// SPDX-License-Identifier: BSD-3-Clause
// Tires and lumps at the ends of what a case may ask: contact at 30 Hz, 100 hours, -40 to 300 degC, melting, a million cells.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/order.hpp"
#include "tests/support/random_block.hpp"
#include "tests/support/tire_section.hpp"
#include "tests/support/two_node_case.hpp"

namespace tiretherm {
namespace {

using support::Dice;
using support::EndedRun;
using support::run_to_its_end;

/// What a drive may hold: standing or at 360 km/h, unloaded or twice overloaded, sliding, leaning, wet, cold or hot.
void draw_drive(Dice& dice, solver::Problem& problem) {
    const auto of = [&](double low, double high) { return dice.chance(0.2) ? low : dice.between(low, high); };
    support::hold(problem, "speed", of(0.0, 100.0));
    support::hold(problem, "vertical_load", of(0.0, 15000.0));
    support::hold(problem, "slip_angle", of(0.0, 0.3) * (dice.chance(0.5) ? 1.0 : -1.0));
    support::hold(problem, "lateral_force", of(0.0, 10000.0));
    support::hold(problem, "slip_ratio", of(-1.0, 1.0));
    support::hold(problem, "longitudinal_force", of(0.0, 10000.0));
    support::hold(problem, "camber", of(0.0, 0.2) * (dice.chance(0.5) ? 1.0 : -1.0));
    support::hold(problem, "inflation_pressure", dice.between(1e5, 5e5));
    support::hold(problem, "air_temperature", dice.between(support::coldest_kelvin, 323.15));
    support::hold(problem, "road_temperature", dice.between(support::coldest_kelvin, 343.15));
    support::hold(problem, "wet", dice.chance(0.3) ? 1.0 : 0.0);
    for (double& T : problem.initial) {
        T = dice.between(support::coldest_kelvin, support::hottest_kelvin);
    }
    problem.settings.end = dice.decades(1e-3, 1e5);
    problem.settings.output_interval = problem.settings.end;
    problem.settings.steady = dice.chance(0.2);
}

/// Load on and off thirty times a second.
void flicker(solver::Problem& problem, double load, double end) {
    std::vector<double> time;
    std::vector<double> value;
    for (int half = 0; half < static_cast<int>(60.0 * end); ++half) {
        time.insert(time.end(), {half / 60.0, (half + 1) / 60.0});
        value.insert(value.end(), 2, half % 2 == 0 ? load : 0.0);
    }
    support::schedule(problem, "vertical_load", std::move(time), std::move(value));
}

/// The two-node tire under a drive of 100 hours, logged at even intervals.
solver::Problem hundred_hours(std::uint64_t seed, double interval) {
    Dice dice(seed);
    solver::Problem problem = support::two_node_problem({});
    const auto samples = static_cast<std::size_t>(360000.0 / interval) + 1;
    std::vector<double> time;
    std::vector<double> speed;
    std::vector<double> load;
    time.reserve(samples);
    for (std::size_t i = 0; i < samples; ++i) {
        time.push_back(interval * static_cast<double>(i));
        speed.push_back(25.0 + 15.0 * std::sin(1e-3 * time.back()) + dice.between(-2.0, 2.0));
        load.push_back(4000.0 + dice.between(-500.0, 500.0));
    }
    support::log(problem, "speed", time, speed);
    support::log(problem, "vertical_load", time, load);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 303.15);
    support::start_at(problem, 296.15);
    problem.settings.end = 360000.0;
    problem.settings.output_interval = 3600.0;
    return problem;
}

}  // namespace

// Whatever a drive asks of a section with gas and rim, the run ends well and its ledger closes; the order in which the
// effects are listed changes no more than last digits.
TEST(ExtremesTire, AnyDriveEndsWellWhateverTheOrderOfTheEffects) {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        Dice dice(seed);
        solver::Problem problem = support::tire_problem(1);
        for (const char* id : {"camber_asymmetry", "radiation", "natural_convection", "groove_convection",
                               "cornering_loss", "wet_road", "inflation_pressure_rise"}) {
            if (dice.chance(0.5)) {
                support::switch_on(problem, id);
            }
        }
        draw_drive(dice, problem);
        const EndedRun controlled = run_to_its_end(problem);
        EXPECT_TRUE(expect_sound(problem, controlled)) << controlled.report.status.message;
        // Backward Euler: a fixed trapezoidal stage may overshoot to where the laws end.
        problem.settings.method = solver::Method::backward_euler;
        problem.settings.fixed_step = problem.settings.end / 5.0;
        problem.settings.tolerance = 1e-6;
        const EndedRun one = run_to_its_end(problem);
        solver::Problem other = problem;
        other.effects.clear();
        for (const std::size_t i : dice.order(problem.effects.size())) {
            other.effects.push_back(problem.effects[i]);
        }
        const EndedRun reordered = run_to_its_end(other);
        EXPECT_TRUE(expect_sound(problem, one)) << one.report.status.message;
        ASSERT_TRUE(reordered.ok()) << reordered.report.status.message;
        EXPECT_LE(support::largest_difference(one.field, reordered.field), problem.settings.tolerance);
        worst = std::max(worst, support::largest_difference(one.field, reordered.field));
    }
    support::expect_below("of another order, K", worst, 1e-6);
}

// A tread that meets a road of another temperature thirty times a second, without a loss: nothing leaves the range of start,
// air and road by more than the tolerance of a step, every switch is landed on, and the heat is in the ledger.
TEST(ExtremesTire, ContactAtThirtyHertzStaysInRange) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        Dice dice(seed);
        solver::Problem problem;
        problem.title = "tread";
        problem.mesh =
            mesh::build(mesh::Layers{.area = problem.tire.outer_area(),
                                     .stack = {{"tread", 0.008, dice.whole(1, 40), dice.decades(1.0, 50.0)}}});
        problem.materials = {support::material(dice.decades(0.05, 5.0), 1100.0, 1800.0)};
        support::switch_on(problem, "conduction");
        support::switch_on(problem, "air_convection");
        support::switch_on(problem, "road_contact", {{"Hc", dice.decades(100.0, 1e6)}});
        const std::array<double, 3> around{dice.between(support::coldest_kelvin, 323.15),
                                           dice.between(support::coldest_kelvin, 343.15),
                                           dice.between(support::coldest_kelvin, 373.15)};
        support::hold(problem, "speed", 20.0);
        support::hold(problem, "air_temperature", around[0]);
        support::hold(problem, "road_temperature", around[1]);
        support::start_at(problem, around[2]);
        flicker(problem, 6000.0, 3.0);
        problem.settings.end = 3.0;
        problem.settings.tolerance = 1e-3;
        const EndedRun run = run_to_its_end(problem);
        ASSERT_TRUE(expect_sound(problem, run)) << run.report.status.message;
        EXPECT_GE(run.report.steps, 180);
        EXPECT_LE(std::ranges::min(around) - run.coldest, problem.settings.tolerance);
        EXPECT_LE(run.hottest - std::ranges::max(around), problem.settings.tolerance);
    }
}

// One insulated cell takes up P: H(t) = H(0) + P t, and its temperature is where the integral of m c(T) is that, by bisection.
// P is constant, so that every method has H exactly and the temperature to Newton's share of the tolerance: however narrow
// the peak that it melts through, however long the step.
TEST(ExtremesTire, HeatThroughAPeakOfTheHeatCapacityIsNotLost) {
    double worst = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Dice dice(seed);
        solver::Problem problem;
        problem.title = "melting";
        problem.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{"wax", 0.01, 1, 1.0}}});
        const double half_width = dice.decades(1e-3, 10.0);
        const physics::Curve c =
            support::melting(dice.decades(500.0, 4000.0), 320.0, half_width, dice.decades(1e3, 3e5));
        SCOPED_TRACE(fmt::format("seed {}: {} K wide", seed, half_width));
        problem.materials = {support::material(physics::Curve::constant(0.3), 1000.0, c)};
        support::switch_on(problem, "conduction");
        const double watts = dice.decades(1e2, 1e6);
        support::switch_on(problem, "uniform_source", {{"power_density", watts / 0.01}});
        support::start_at(problem, 300.0);
        const double joules = 10.0 * (c.integral(dice.between(310.0, 340.0)) - c.integral(300.0));
        problem.settings.end = joules / watts;
        problem.settings.output_interval = problem.settings.end;
        problem.settings.tolerance = 1e-3;
        problem.settings.method = dice.chance(0.5) ? solver::Method::backward_euler : solver::Method::tr_bdf2;
        if (dice.chance(0.7)) {
            problem.settings.fixed_step = problem.settings.end / dice.whole(1, 10);
        }
        double low = 300.0;
        double high = 400.0;
        for (int i = 0; i < 100; ++i) {
            const double middle = 0.5 * (low + high);
            (10.0 * (c.integral(middle) - c.integral(300.0)) < joules ? low : high) = middle;
        }
        const EndedRun run = run_to_its_end(problem);
        ASSERT_TRUE(expect_sound(problem, run)) << run.report.status.message;
        worst = std::max(worst, std::abs(run.field.front() - low));
        EXPECT_NEAR(run.field.front(), low, 0.05 * problem.settings.tolerance);
    }
    support::expect_below("of the temperature, K", worst, 5e-5);
}

// A fixed step whose trapezoidal stage leads below the absolute zero is refused with what to do: a strip of 300 degC in air of
// -40 degC that would swing past its surroundings by as much as it is above them, 233 - 340 K.
TEST(ExtremesTire, AStepThatLeadsBelowTheAbsoluteZeroIsRefusedWithARemedy) {
    solver::Problem problem;
    problem.title = "quenched";
    problem.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{"rubber", 0.001, 1, 1.0}}});
    problem.materials = {support::material(physics::Curve::constant(10.0), 1000.0,
                                           physics::Curve::table({233.0, 573.0}, {1000.0, 1100.0}))};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "still_air", {{"h", 1000.0}}, {"outside"});
    support::switch_on(problem, "radiation", {}, {"outside"});
    support::hold(problem, "air_temperature", support::coldest_kelvin);
    support::start_at(problem, support::hottest_kelvin);
    problem.settings.end = 1000.0;
    problem.settings.fixed_step = 500.0;
    const EndedRun run = run_to_its_end(problem);
    EXPECT_EQ(run.report.status.outcome, solver::Outcome::not_converged);
    EXPECT_TRUE(run.report.status.message.starts_with(
        "the step is too long: its heat balance leads below the absolute zero at t = 292.893 s, in "))
        << run.report.status.message;
    EXPECT_TRUE(run.report.status.message.ends_with("; make the fixed step shorter, or leave it out"))
        << run.report.status.message;
    problem.settings.fixed_step.reset();
    EXPECT_TRUE(run_to_its_end(problem).ok());
}

TEST(ExtremesTire, HundredHoursOfEveryMinuteCloseTheirLedger) {
    const solver::Problem problem = hundred_hours(1, 60.0);
    const EndedRun run = run_to_its_end(problem);
    EXPECT_TRUE(expect_sound(problem, run)) << run.report.status.message;
    EXPECT_EQ(run.report.simulated, 360000.0);
    EXPECT_GT(run.coldest, 296.0);
    EXPECT_LT(run.hottest, support::hottest_kelvin);
}

TEST(ExtremesLong, HundredHoursOfEverySecondCloseTheirLedger) {
    const solver::Problem problem = hundred_hours(2, 1.0);
    const EndedRun run = run_to_its_end(problem);
    EXPECT_TRUE(expect_sound(problem, run)) << run.report.status.message;
    EXPECT_EQ(run.report.simulated, 360000.0);
}

// 100 x 100 x 100 cells of four materials at random, 1e-3 to 1e3 W/mK: three steps of backward Euler stay in range and close.
TEST(ExtremesLong, AMillionCellsStayInRange) {
    Dice dice(1);
    support::Block block;
    for (std::vector<double>& edge : block.edge) {
        edge.push_back(0.0);
        for (int i = 0; i < 100; ++i) {
            edge.push_back(edge.back() + 1e-4 * dice.decades(1.0, 10.0));
        }
    }
    for (const double k : {1e-3, 0.1, 10.0, 1e3}) {
        block.materials.push_back(support::material(k, 1000.0, 1800.0));
    }
    for (int i = 0; i < block.cells(); ++i) {
        block.layer.push_back(dice.whole(0, 3));
        block.initial.push_back(dice.between(support::coldest_kelvin, support::hottest_kelvin));
    }
    block.film = {10.0, 100.0, 0.0, 1e4, 50.0, 1.0};
    block.air_time = {0.0};
    block.air = {300.0};
    block.settings.end = 30.0;
    block.settings.output_interval = 30.0;
    block.settings.fixed_step = 10.0;
    block.settings.method = solver::Method::backward_euler;
    const solver::Problem problem = block.problem();
    const EndedRun run = run_to_its_end(problem);
    ASSERT_TRUE(expect_sound(problem, run)) << run.report.status.message;
    EXPECT_EQ(problem.mesh.n_cells, 1000000);
    EXPECT_LE(std::max(block.coldest() - run.coldest, run.hottest - block.hottest()), block.settings.tolerance);
}

}  // namespace tiretherm
