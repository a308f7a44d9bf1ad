// SPDX-License-Identifier: BSD-3-Clause
// Time marching: output times, energy closure, steps at jumps, steady states, observers, and failures with cell and
// effect.

#include "solver/time_integration/march.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "solver/bench.hpp"
#include "solver/hot_spot_finder.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::solver {

namespace {

struct Rows {
    std::vector<double> time;
    std::vector<std::vector<double>> channels;
    std::vector<bool> field;
    std::vector<double> stored;
    std::vector<double> attributed;
};

MarchReport collect(const Problem& problem, Rows& rows) {
    return run(problem, [&](const Snapshot& s) {
        rows.time.push_back(s.time);
        rows.channels.emplace_back(s.channels.begin(), s.channels.end());
        rows.field.push_back(s.field);
        rows.stored.push_back(s.stored);
        double sum = 0.0;
        for (const double joules : s.joules) {
            sum += joules;
        }
        rows.attributed.push_back(sum);
        return true;
    });
}

MarchReport quiet(const Problem& problem) {
    return run(problem, [](const Snapshot&) { return true; });
}

/// Heat that is not a number above 310 K; a law that never lets Newton settle; a conductance below zero.
void add_terms_nan(const physics::EvaluationState& m, physics::Terms& terms) {
    terms.heat(0, m.temperature[0] > 310.0 ? std::nan("") : 500.0);
}
void add_terms_jumping(const physics::EvaluationState& m, physics::Terms& terms) {
    terms.heat(0, m.temperature[0] > 310.0 ? -5e12 : 5e12);
}
void add_terms_negative(const physics::EvaluationState& m, physics::Terms& terms) {
    terms.exchange(0, m.temperature[0] > 310.0 ? -1.0 : 5.0, 400.0);
}
/// k T^2 loss, with and without derivatives of its own.
void add_terms_square(const physics::EvaluationState& m, physics::Terms& terms) {
    const double T = m.temperature[0];
    terms.heat(0, -1e-3 * T * T, -2e-3 * T);
}
void add_terms_square_without(const physics::EvaluationState& m, physics::Terms& terms) {
    const double T = m.temperature[0];
    terms.heat(0, -1e-3 * T * T);
}
/// Heat as strong as the laser, whatever the mesh.
void coefficients_of_lamp(const physics::ActiveEffect& /*active*/, const physics::OperatingPoint& point,
                          std::span<double> coefficients) {
    coefficients[0] = point.inputs.laser_power;
}
void add_terms_of_lamp(const physics::EvaluationState& m, physics::Terms& terms) { terms.heat(0, m.coefficients[0]); }

physics::Effect effect(std::string_view id, void (*add_terms)(const physics::EvaluationState&, physics::Terms&),
                       bool derivatives) {
    return {.id = id,
            .kind = physics::EffectKind::source,
            .equation = "",
            .source = "",
            .meaning = "",
            .model = physics::HeatEffect{.gives_derivatives = derivatives, .add_terms = add_terms}};
}

Problem with(const physics::Effect& extra) {
    Problem problem = heated_strip(5);
    problem.effects.push_back(physics::activate(extra, problem.mesh));
    return problem;
}

}  // namespace

TEST(Run, ReportsRowsExactlyAtTheOutputTimes) {
    Problem problem = heated_strip(5);
    problem.settings.end = 95.0;
    problem.settings.output_interval = 10.0;
    problem.settings.field_interval = 30.0;
    Rows rows;
    const MarchReport report = collect(problem, rows);
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    ASSERT_EQ(rows.time.size(), 11U);
    for (std::size_t i = 0; i < 10; ++i) {
        EXPECT_DOUBLE_EQ(rows.time[i], 10.0 * static_cast<double>(i));
        EXPECT_EQ(rows.field[i], i % 3 == 0);
    }
    EXPECT_DOUBLE_EQ(rows.time[10], 95.0);
    EXPECT_TRUE(rows.field[10]);
}

TEST(Run, RowsInsideAStepLieOnTheSolution) {
    // The same run with rows at every step and with rows every second: interpolation is second order like the method,
    // so that both agree to a few tolerances.
    Problem fine = heated_strip(5);
    fine.settings.tolerance = 1e-4;
    fine.settings.output_interval = 100.0;
    Problem coarse = fine;
    coarse.settings.tolerance = 1e-2;
    Rows exact;
    Rows rows;
    ASSERT_TRUE(collect(fine, exact).status.ok());
    ASSERT_TRUE(collect(coarse, rows).status.ok());
    ASSERT_EQ(exact.time.size(), rows.time.size());
    for (std::size_t i = 0; i < rows.time.size(); ++i) {
        EXPECT_NEAR(rows.channels[i][0], exact.channels[i][0], 0.05);
    }
}

TEST(Run, BooksAllHeatInEveryRow) {
    Problem problem = two_node_tire();
    problem.settings.output_interval = 7.0;
    Rows rows;
    const MarchReport report = collect(problem, rows);
    ASSERT_TRUE(report.status.ok());
    EXPECT_LT(report.energy_closure, 1e-10);
    EXPECT_GT(rows.stored.back(), 1e5);
    for (std::size_t i = 0; i < rows.time.size(); ++i) {
        EXPECT_NEAR(rows.stored[i], rows.attributed[i], 1e-9 * rows.stored.back());
    }
}

TEST(Run, FirstRowHasTheWattsOfTheStart) {
    // All at the air's 23 C but the loss: what is made at the start is the law's, and nothing leaves yet.
    const Problem problem = two_node_tire();
    std::vector<double> first;
    (void)run(problem, [&](const Snapshot& now) {
        if (first.empty()) {
            first.assign(now.watts.begin(), now.watts.end());
            EXPECT_EQ(now.joules[1], 0.0);
        }
        return true;
    });
    const physics::LossTangent law;
    const double made = physics::strain_power(problem.tire, 100.0 / 3.6, 4000.0) *
                        law.value(296.15 + law.shift(problem.tire.revolutions(100.0 / 3.6, 4000.0)));
    EXPECT_NEAR(first[1], made, 1e-9 * made);
    EXPECT_NEAR(first[3], 0.0, 1e-9);
    EXPECT_NEAR(first[4], 0.0, 1e-9);
}

TEST(Run, LandsOnEveryPointOfASchedule) {
    Problem problem = heated_strip(5);
    const physics::Signal& air = *physics::find_signal("air_temperature");
    problem.input_signals = {};
    problem.input_signals.add(
        {.signal = &air, .time = {0.0, 123.4, 123.4, 555.5, 1000.0}, .value = {300.0, 300.0, 280.0, 290.0, 290.0}});
    Rows rows;  // output_interval 0: a row for every step
    ASSERT_TRUE(collect(problem, rows).status.ok());
    for (const double stop : {123.4, 555.5, 1000.0}) {
        EXPECT_NE(std::find(rows.time.begin(), rows.time.end(), stop), rows.time.end()) << stop;
    }
}

TEST(Run, SurfaceFollowsAJumpAtOnceAndTheInsideDoesNot) {
    // Air from 300 to 250 K at 500 s. The row at the jump shows the state before it; 1 s later the surface has moved.
    Problem problem = strip(40);
    problem.channels = {{.name = "surface", .meaning = "", .where = problem.mesh.regions[0].mean}};
    problem.input_signals = {};
    problem.input_signals.add({.signal = physics::find_signal("air_temperature"),
                               .time = {0.0, 500.0, 500.0, 1000.0},
                               .value = {300.0, 300.0, 250.0, 250.0}});
    problem.settings.output_interval = 1.0;
    Rows rows;
    ASSERT_TRUE(collect(problem, rows).status.ok());
    EXPECT_NEAR(rows.channels[500][0], 300.0, 1e-9);
    EXPECT_LT(rows.channels[501][0], 299.5);
}

TEST(Run, FixedStepsAreOfThatSizeAndEndOnTime) {
    Problem problem = heated_strip(5);
    problem.settings.end = 10.0;
    problem.settings.fixed_step = 3.0;
    Rows rows;
    const MarchReport report = collect(problem, rows);
    EXPECT_EQ(report.steps, 4);
    EXPECT_EQ(rows.time, (std::vector<double>{0.0, 3.0, 6.0, 9.0, 10.0}));
}

TEST(Run, TighterToleranceTakesMoreSteps) {
    Problem problem = heated_strip(20);
    problem.settings.tolerance = 0.1;
    const MarchReport loose = quiet(problem);
    problem.settings.tolerance = 1e-4;
    const MarchReport tight = quiet(problem);
    // Second order: the step goes with tolerance^(1/3), a thousandth costs ten times the steps.
    EXPECT_GT(tight.steps, 4 * loose.steps);
    EXPECT_LT(loose.steps, 60);
}

TEST(Run, LinearProblemNeedsFewFactorisations) {
    Problem problem = heated_strip(40);
    const MarchReport report = quiet(problem);
    ASSERT_TRUE(report.status.ok());
    // Two implicit stages a step. With a factor of its own length a stage takes one correction, with that of a step nearby two.
    EXPECT_LE(report.newton_iterations, 2 * 2 * (report.steps + report.rejected));
    EXPECT_LT(report.factorisations, report.steps + report.rejected);
}

TEST(Run, SteadyStateOfAHeatedStripIsTheHeatOverTheFilm) {
    // 1e5 W/m3 * 10 mm = 1000 W leave through 2 * 20 W/K: surface 325 K. The middle is q L^2 / (8 k) = 4.310 K above it;
    // the mean over the cells q L^2/(12 k) (1 - 1/(2 n^2)...) is second order: within 0.01 K with 40 cells.
    Problem problem = heated_strip(40);
    problem.settings.steady = true;
    problem.channels.push_back({.name = "surface", .meaning = "", .where = problem.mesh.regions[0].mean});
    const MarchReport report = quiet(problem);
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_NEAR(report.channel_final[1], 325.0, 1e-8);
    EXPECT_NEAR(report.channel_final[0], 325.0 + 1e5 * 1e-4 / (12.0 * 0.29), 0.01);
    EXPECT_LT(report.energy_closure, 1e-10);
}

TEST(Run, SteadyStateWithoutExchangeIsRefusedInASentence) {
    Problem problem = heated_strip(5);
    problem.effects.erase(problem.effects.begin() + 1);
    problem.settings.steady = true;
    const MarchReport report = quiet(problem);
    EXPECT_EQ(report.status.outcome, Outcome::not_positive_definite);
    EXPECT_NE(report.status.message.find("exchanges heat with nothing"), std::string::npos) << report.status.message;
}

TEST(Run, StopsWhenTheObserverSaysSo) {
    Problem problem = heated_strip(5);
    problem.settings.output_interval = 10.0;
    int rows = 0;
    const MarchReport report = run(problem, [&](const Snapshot&) { return ++rows < 4; });
    EXPECT_EQ(report.status.outcome, Outcome::stopped);
    EXPECT_EQ(rows, 4);
}

// The next row is at the end of the run: the signal is heard before it, and the state of that moment is shown.
TEST(Run, HearsTheStopSignalBetweenRows) {
    Problem problem = heated_strip(5);
    problem.settings.output_interval = problem.settings.end;
    stop_after(0.0);
    Rows rows;
    const MarchReport report = collect(problem, rows);
    stop_after(std::numeric_limits<double>::infinity());
    EXPECT_EQ(report.status.outcome, Outcome::stopped);
    EXPECT_LT(report.simulated, 0.5 * problem.settings.end);
    EXPECT_TRUE(rows.field.back());
}

TEST(Run, SaysWhereAndWhenTheBalanceIsNotANumber) {
    const physics::Effect bad = effect("bad_heat", add_terms_nan, true);
    const MarchReport report = quiet(with(bad));
    EXPECT_EQ(report.status.outcome, Outcome::not_finite);
    EXPECT_NE(report.status.message.find("bad_heat"), std::string::npos) << report.status.message;
    EXPECT_NE(report.status.message.find("cell 0 of layer rubber"), std::string::npos) << report.status.message;
    EXPECT_NE(report.status.message.find("t = "), std::string::npos);
    EXPECT_GT(report.simulated, 0.0);  // what was computed before is kept
}

TEST(Run, SaysWhichEffectKeepsTheBalanceFromConverging) {
    const physics::Effect bad = effect("jumping_heat", add_terms_jumping, true);
    const MarchReport report = quiet(with(bad));
    EXPECT_FALSE(report.status.ok());
    EXPECT_NE(report.status.message.find("jumping_heat"), std::string::npos) << report.status.message;
}

TEST(Run, SaysWhichEffectGaveANegativeConductance) {
    const physics::Effect bad = effect("backward_exchange", add_terms_negative, true);
    const MarchReport report = quiet(with(bad));
    EXPECT_EQ(report.status.outcome, Outcome::negative_conductance);
    EXPECT_NE(report.status.message.find("backward_exchange"), std::string::npos) << report.status.message;
}

TEST(Run, DerivativesByDifferenceGiveTheSameSolution) {
    const physics::Effect own = effect("square", add_terms_square, true);
    const physics::Effect difference = effect("square", add_terms_square_without, false);
    const MarchReport with_own = quiet(with(own));
    const MarchReport with_difference = quiet(with(difference));
    ASSERT_TRUE(with_own.status.ok());
    ASSERT_TRUE(with_difference.status.ok());
    EXPECT_NEAR(with_own.channel_final[0], with_difference.channel_final[0], 1e-6);
    EXPECT_NEAR(static_cast<double>(with_own.newton_iterations), static_cast<double>(with_difference.newton_iterations),
                0.1 * static_cast<double>(with_own.newton_iterations));
}

TEST(Run, FindsTheHottestAndTheColdestPlace) {
    const MarchReport report = quiet(heated_strip(5));
    EXPECT_EQ(report.hottest.node, 2);  // the middle cell of five
    EXPECT_DOUBLE_EQ(report.hottest.time, 1000.0);
    EXPECT_DOUBLE_EQ(report.coldest.temperature, 300.0);
    EXPECT_DOUBLE_EQ(report.coldest.time, 0.0);
}

TEST(Run, EffectiveLinkOfTwoNodesIsTheLink) {
    // k(T_bulk) / dZ * S_tot at the end of the run.
    const Problem problem = two_node_tire();
    const MarchReport report = quiet(problem);
    const double k = problem.link_laws[0].value(report.channel_final[1]);
    EXPECT_NEAR(report.effective_two_node_conductance, k / 0.010 * problem.tire.outer_area(), 1e-9);
}

TEST(Run, EffectiveLinkOfASlabIsThreeConductivitiesOverItsThickness) {
    // A bulk of thickness L heated uniformly, cooled through a thin layer above it: its mean is q L / (3 k) above its
    // outer face, q the flux that leaves: link 3 k A / L = 3 * 0.29 / 0.01 = 87 W/K, and the tread's 0.1 mm in series
    // makes 1 / (1/87 + 1e-4/0.29) = 84.46 W/K; the surface region is the outer surface. 60 cells: second order, 0.02 %.
    Problem problem = heated_strip(1);
    problem.mesh = mesh::build(mesh::Layers{
        .area = 1.0,
        .stack = {{.name = "skin", .thickness = 1e-4, .cells = 1}, {.name = "bulk", .thickness = 0.01, .cells = 60}}});
    problem.materials.assign(2, material(physics::Curve::constant(0.29)));
    problem.effects[1].patches = {0};  // cooled outside only
    problem.initial.assign(static_cast<std::size_t>(problem.mesh.n_nodes), 300.0);
    problem.channels.clear();
    problem.settings.steady = true;
    const double skin_share = 0.5 * 1e-4 / 0.01;  // the skin's own heat passes half the skin only
    EXPECT_NEAR(quiet(problem).effective_two_node_conductance, 84.46, 84.46 * (0.0003 + 0.03 * skin_share));
}

TEST(Run, EffectiveLinkOfOneLayerIsToItsOuterSurface) {
    // The same without the skin: 3 k A / L = 87 W/K, of which 60 cells leave 1/(2 n^2) of the mean's rise: 0.02 %.
    Problem problem = heated_strip(60);
    problem.effects[1].patches = {0};
    problem.settings.steady = true;
    EXPECT_NEAR(quiet(problem).effective_two_node_conductance, 87.0, 87.0 * 0.0003);
}

TEST(Run, WarnsWhenTheSurfaceLeavesTheRangeOfTheConvectionLaw) {
    // Started at 120 degC, the outer surface is beyond the 50 degC of the thesis; a clamp there answers the warning, and so does
    // the bound.
    Problem problem = two_node_tire();
    problem.effects[3].choices = {1};
    EXPECT_TRUE(quiet(problem).warnings.empty());
    problem.initial.assign(2, 393.15);
    const MarchReport hot = quiet(problem);
    ASSERT_EQ(hot.warnings.size(), 1U);
    EXPECT_NE(hot.warnings[0].text().find("120.0 degC"), std::string::npos) << hot.warnings[0].text();
    physics::ActiveEffect& air = problem.effects[3];
    air.parameters[static_cast<std::size_t>(physics::find_parameter(*air.effect, "clamp_high"))] = 323.15;
    EXPECT_TRUE(quiet(problem).warnings.empty());
    problem.effects[3] = physics::activate(*air.effect, problem.mesh);
    EXPECT_TRUE(quiet(problem).warnings.empty());
}

TEST(Defects, ListsAllThatIsWrongWithAProblem) {
    Problem problem = heated_strip(3);
    problem.materials.clear();
    problem.settings.tolerance = 0.0;
    problem.settings.end = -1.0;
    problem.initial[0] = -5.0;
    EXPECT_EQ(defects(problem).size(), 4U);
    EXPECT_TRUE(defects(heated_strip(3)).empty());
}

// A schedule has a point at 0.3 s, a log a sample at 0.1 + 0.2 s, which is 5.6e-17 s later. No step leads from one to the
// other: in a step of no length a reading would be a difference over nothing.
TEST(March, NoStepOfNoLengthIsLeftUpToASample) {
    Problem problem = heated_strip(10);
    problem.input_signals.add(
        {.signal = physics::find_signal("vertical_load"), .time = {0.0, 0.3, 0.9}, .value = {0.0, 1.0, 0.0}});
    problem.input_signals.add({.signal = physics::find_signal("speed"),
                               .time = {0.0, 0.1 + 0.2, 0.9},
                               .value = {0.0, 1.0, 0.0},
                               .logged = true});
    problem.settings.end = 0.9;
    problem.settings.tolerance = 1e-6;
    double last = 0.0;
    double shortest = 0.9;
    const MarchReport report = run(problem, [&](const Snapshot& now) {
        EXPECT_TRUE(std::isfinite(now.channels[0])) << "at " << now.time << " s";
        if (now.time > 0.0) {
            shortest = std::min(shortest, now.time - last);
        }
        last = now.time;
        return true;
    });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_GT(shortest, 1e-9);
}

// Hottest is the peak, on the face between the middle two of four cells of 2.5 mm. In the steady state the surface is at
// 300 K + q L/(2 h) = 325 K, and the parabola rises by q L^2/(8 k) = 4.3103 K above it. Its flux at the surface goes through half a
// cell in a straight line, which lifts all centres by q d^2/(8 k) = 0.2694 K: 329.5797 K. The middle cells are 0.2694 K colder.
TEST(March, HottestIsThePeakBetweenTheCells) {
    Problem problem = heated_strip(4);
    problem.settings.steady = true;  // on the way there, a rise below `creeping_rise` would not count
    const MarchReport report = run(problem, [](const Snapshot&) { return true; });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_NEAR(report.hottest.temperature, 329.5797, 1e-4);
}

// A strip of 300 K in air of 353.15 K for 1000 s and of 300 K afterwards is hottest when the air turns cold, at a time without a row:
// its field is kept, and its peak is what the report calls the hottest. Its time constant is 1.98e6 0.01 / 40 = 495 s, so that
// it has come to within some 7 K of the warm air.
TEST(March, TheFieldOfTheHottestStepIsKept) {
    Problem problem = strip(4);
    problem.input_signals = {};
    support::schedule(problem, "air_temperature", {0.0, 1000.0, 1000.0, 3000.0}, {353.15, 353.15, 300.0, 300.0});
    problem.settings.end = 3000.0;
    problem.settings.output_interval = 700.0;
    const MarchReport report = quiet(problem);
    // At 1000 s the surface has (232 344.62 + 20 353.15) / 252 = 345.30 K. Afterwards it is cold at once and the field falls from
    // there to the middle: no place between the centres is hotter than the surface was.
    EXPECT_EQ(report.hottest.time, 1000.0);
    EXPECT_NEAR(report.hottest.temperature, 345.30, 0.01);
    ASSERT_EQ(report.hottest_field.size(), static_cast<std::size_t>(problem.mesh.n_nodes));
    const double peak = HotSpotFinder(problem.mesh, all_nodes(problem.mesh)).find(report.hottest_field).temperature;
    EXPECT_EQ(peak, report.hottest.temperature);
    EXPECT_NEAR(peak, 346.0, 3.0);
}

// 1e5 W/m3 in 10 mm leave by two films of 20 W/m2K: 25 K at the surfaces and 1e5 0.01^2 / (8 0.29) = 4.3 K more in the middle, reached to
// 5 mK after some 8.5 time constants of 495 s. What still rises by less is not a later peak.
TEST(March, APlateauIsHottestWhenItIsReached) {
    Problem problem = heated_strip(8);
    problem.settings.end = 1e5;
    const MarchReport report = quiet(problem);
    EXPECT_NEAR(report.hottest.temperature, 329.3, 0.2);
    EXPECT_LT(report.hottest.time, 8000.0);
}

// Near the plateau of the test above the error would allow steps of minutes; where none may be longer than 7 s, a row of each
// step in 1000 s makes 143 at least, and temperatures are those of the free steps within ten of their errors.
TEST(March, NoStepIsLongerThanTheLargest) {
    Problem problem = heated_strip(4);
    problem.settings.end = 1000.0;
    Rows free;
    ASSERT_TRUE(collect(problem, free).status.ok());
    problem.settings.largest_step = 7.0;
    Rows held;
    ASSERT_TRUE(collect(problem, held).status.ok());
    double longest = 0.0;
    for (std::size_t i = 1; i < held.time.size(); ++i) {
        longest = std::max(longest, held.time[i] - held.time[i - 1]);
    }
    EXPECT_LT(free.time.size(), 100U);
    EXPECT_GE(held.time.size(), 144U);
    EXPECT_LE(longest, 7.0 + 1e-9);
    EXPECT_NEAR(held.channels.back()[0], free.channels.back()[0], 10.0 * problem.settings.tolerance);
}

// A source that rises from 0 to 100 W over 1000 s gives t/10 W at t, also in rows between the ends of steps, and has given
// t^2/20 J.
TEST(Run, WattsOfARowAreThoseOfItsTime) {
    physics::Effect lamp = effect("lamp", add_terms_of_lamp, true);
    lamp.model = physics::HeatEffect{
        .n_coefficients = 1, .evaluate_coefficients = coefficients_of_lamp, .add_terms = add_terms_of_lamp};
    Problem problem = strip(4);
    problem.effects.push_back(physics::activate(lamp, problem.mesh));
    problem.input_signals.add({.signal = physics::find_signal("laser_power"),
                               .time = std::vector{0.0, 1000.0},
                               .value = std::vector{0.0, 100.0}});
    problem.settings.output_interval = 7.0;
    std::size_t rows = 0;
    const MarchReport report = run(problem, [&](const Snapshot& s) {
        EXPECT_NEAR(s.watts.back(), 0.1 * s.time, 1e-9) << s.time;
        EXPECT_NEAR(s.joules.back(), 0.05 * s.time * s.time, 1e-6) << s.time;
        ++rows;
        return true;
    });
    ASSERT_TRUE(report.status.ok()) << report.status.message;
    EXPECT_GT(rows, 2U * static_cast<std::size_t>(report.steps)) << "rows lie between the ends of steps";
}

}  // namespace tiretherm::solver
