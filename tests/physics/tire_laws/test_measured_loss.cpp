// SPDX-License-Identifier: BSD-3-Clause
// The total of the loss as a machine measured it, and fields in time, as the effects use them.
#include <cmath>

#include <gtest/gtest.h>

#include "physics/effects/bench.hpp"
#include "physics/tire_laws/measured_loss.hpp"

namespace tiretherm::physics {

namespace {

/// Force over speed (10, 30 m/s) and load (2000, 6000 N): 20, 60; 28, 84 N.
GridTable drum() {
    return {
        .axes = {{.input = &Inputs::speed, .at = {10.0, 30.0}}, {.input = &Inputs::vertical_load, .at = {2e3, 6e3}}},
        .values = {20.0, 60.0, 28.0, 84.0}};
}

Inputs at(double speed, double load) { return {.speed = speed, .vertical_load = load}; }

}  // namespace

// At 15 m/s and 5000 N: a quarter of the way in speed, three quarters in load. 10 m/s: 20 + 0.75 40 = 50; 30 m/s:
// 28 + 0.75 56 = 70; a quarter between them: 55 N.
TEST(GridTable, IsInterpolatedAsByHand) {
    EXPECT_NEAR(drum().value(at(15.0, 5000.0), 0.0), 55.0, 1e-12);
    EXPECT_NEAR(drum().value(at(10.0, 2000.0), 0.0), 20.0, 1e-12);
    EXPECT_NEAR(drum().value(at(30.0, 6000.0), 0.0), 84.0, 1e-12);
}

TEST(GridTable, IsHeldBeyondItsEnds) {
    EXPECT_NEAR(drum().value(at(50.0, 9000.0), 0.0), 84.0, 1e-12);
    EXPECT_NEAR(drum().value(at(0.0, 0.0), 0.0), 20.0, 1e-12);
}

TEST(GridTable, KnowsTheBulksTemperature) {
    GridTable table{.axes = {{.input = nullptr, .at = {300.0, 340.0}}}, .values = {60.0, 40.0}};
    EXPECT_NEAR(table.value({}, 310.0), 55.0, 1e-12);
}

// SAE J2452 in kPa, N and km/h: P = 230, Z = 4000, V = 80, alpha = -0.4, beta = 0.9, a = 0.1, b = 2e-4, c = 1e-6:
//   230^-0.4 = exp(-0.4 5.43808) = 0.113576; 4000^0.9 = exp(0.9 8.29405) = 1745.3; a + b V + c V^2 = 0.1224
//   F = 0.113576 1745.3 0.1224 = 24.263 N, and 24.263 N 22.2222 m/s = 539.2 W
TEST(MeasuredLoss, CoastdownCoefficientsGiveForceTimesSpeed) {
    MeasuredLoss loss{.coastdown = CoastdownFit{.law = {.pressure_exponent = -0.4,
                                                        .load_exponent = 0.9,
                                                        .constant = 0.1,
                                                        .linear = 2e-4,
                                                        .quadratic = 1e-6}},
                      .table = {}};
    Inputs inputs = at(80.0 / 3.6, 4000.0);
    inputs.inflation_pressure = 230e3;
    EXPECT_NEAR(loss.power(inputs, 0.0), 539.2, 0.2);
    inputs.speed = -inputs.speed;
    EXPECT_NEAR(loss.power(inputs, 0.0), 539.2, 0.2);
    // In psi, lbf and mph the same law has other coefficients; the units say so. 1 psi = 6894.757 Pa.
    loss.coastdown->pressure_unit = 6894.757;
    loss.coastdown->law.constant *= std::pow(6.894757, -0.4);
    loss.coastdown->law.linear *= std::pow(6.894757, -0.4);
    loss.coastdown->law.quadratic *= std::pow(6.894757, -0.4);
    EXPECT_NEAR(loss.power(inputs, 0.0), 539.2, 0.2);
}

// However the tire is meshed, the heat of the loss is force times speed: 55 N 15 m/s = 825 W; none without contact.
TEST(MeasuredLoss, IsTheTotalOfTheLossOnEveryMesh) {
    for (const Bench& bench : {two_nodes(), section()}) {
        ActiveEffect loss = activate(*find_effect("strain_energy_loss"), bench.mesh);
        loss.total = std::make_shared<const MeasuredLoss>(MeasuredLoss{.table = drum()});
        bench.place(loss);
        EXPECT_NEAR(bench.watts(loss, at(15.0, 5000.0)), 825.0, 825.0 * 1e-12);
        EXPECT_EQ(bench.watts(loss, at(15.0, 0.0)), 0.0);
        EXPECT_EQ(bench.watts(loss, at(0.0, 5000.0)), 0.0);
    }
}

// 60 N at 300 K and 40 N at 340 K: at the bulk's mean of 310 K 55 N, at 10 m/s 550 W, and -0.5 N/K 10 m/s = -5 W/K.
TEST(MeasuredLoss, FollowsTheBulksTemperatureWithItsSlope) {
    Bench bench = two_nodes();
    ActiveEffect loss = activate(in_frames(*find_effect("strain_energy_loss")), bench.mesh);
    loss.total = std::make_shared<const MeasuredLoss>(
        MeasuredLoss{.table = {.axes = {{.input = nullptr, .at = {300.0, 340.0}}}, .values = {60.0, 40.0}},
                     .bulk_temperatures = {300.0, 340.0}});
    bench.place(loss);
    const std::vector<double> T{305.0, 310.0};
    const Terms terms = bench.said(loss, at(10.0, 4000.0), T);
    EXPECT_NEAR(terms.watts[0], 550.0, 1e-9);
    const auto bulk = static_cast<std::size_t>(bench.mesh.find_region("bulk"));
    EXPECT_NEAR(terms.region_slope[2 * bulk] + terms.region_slope[2 * bulk + 1], -5.0, 1e-10);
    EXPECT_NEAR(bench.said(loss, at(10.0, 4000.0), {305.0, 400.0}).watts[0], 400.0, 1e-9);
}

// Frames at 10 and 20 s: a quarter of the way the first counts three quarters; beyond the ends they are held.
TEST(Field, IsStraightBetweenItsFrames) {
    const Field field{
        .nodes = {0, 1}, .time = {10.0, 20.0}, .weights = {{1.0, 0.0}, {0.25, 0.75}}, .watts = {100.0, 200.0}};
    std::vector<double> out(4, -1.0);
    field.shares_at(12.5, out);
    EXPECT_EQ(out, (std::vector{0.75, 0.25, 0.0, 0.0}));
    field.shares_at(-5.0, out);
    EXPECT_EQ(out, (std::vector{1.0, 0.0, 0.0, 0.0}));
    field.shares_at(20.0, out);
    EXPECT_EQ(out, (std::vector{0.0, 1.0, 0.0, 0.0}));
    field.watts_at(15.0, out);
    EXPECT_EQ(out, (std::vector{50.0, 100.0, 0.0, 0.0}));
}

// A shape keeps the law's total to round-off at any time; watts are the file's, of friction times the tire's share.
TEST(Field, ShapesKeepTheLawsTotalAndWattsTheFiles) {
    const Bench bench = section();
    for (const std::string_view id : {"sliding_friction", "strain_energy_loss"}) {
        const ActiveEffect plain = bench.active(id);
        ActiveEffect shaped = activate(in_frames(*find_effect(id)), bench.mesh);
        Field field{.nodes = plain.nodes, .time = {0.0, 10.0}, .weights = {plain.weights, plain.weights}, .watts = {}};
        std::ranges::fill(field.weights[1], 0.0);
        field.weights[1][2] = 1.0;
        shaped.field = std::make_shared<const Field>(field);
        bench.place(shaped);
        Inputs inputs = rolling();
        const double total = bench.watts(plain, inputs);
        ASSERT_GT(total, 0.0);
        for (const double t : {-1.0, 0.0, 3.7, 10.0, 50.0}) {
            inputs.time = t;
            EXPECT_NEAR(bench.watts(shaped, inputs), total, 1e-13 * total) << id << t;
        }
        const Terms late = bench.said(shaped, inputs, bench.T);
        EXPECT_NEAR(late.node_q[static_cast<std::size_t>(plain.nodes[2])], total, 1e-12 * total);
        field.watts = {100.0, 300.0};
        shaped.field = std::make_shared<const Field>(field);
        inputs.time = 5.0;
        EXPECT_NEAR(bench.watts(shaped, inputs), id == "sliding_friction" ? 0.6 * 200.0 : 200.0, 1e-11);
    }
}

}  // namespace tiretherm::physics
