// SPDX-License-Identifier: BSD-3-Clause
// Steady states against long transients, and against Kirchhoff's transform for k(T).

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/order.hpp"
#include "tests/support/two_node_case.hpp"

namespace tiretherm {
namespace {

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    EXPECT_EQ(a.size(), b.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
        worst = std::max(worst, std::abs(a[i] - b[i]));
    }
    return worst;
}

/// The steady field, and the field after `end` seconds, some thirty of the slowest time constant: exp(-30) = 1e-13 of
/// the way is left. Steps grow as the field settles, and what they leave is Newton's share of the tolerance of 1e-5 K.
void expect_steady_equals_transient(solver::Problem problem, double end) {
    problem.settings.end = end;
    problem.settings.output_interval = end;
    problem.settings.tolerance = 1e-5;
    const std::vector<double> late = support::final_field(problem);
    problem.settings.steady = true;
    const std::vector<double> steady = support::final_field(problem);
    support::expect_below(problem.title, largest_difference(late, steady), 1e-5);
    const double rise = *std::max_element(steady.begin(), steady.end()) - problem.initial.front();
    EXPECT_GT(rise, 10.0);  // the comparison is about something
}

TEST(SteadyState, TireEqualsItsLongTransient) {
    // Loss tangent, convection and link all depend on temperature. Bulk capacity 9445 J/K over some 15 W/K: 600 s.
    const support::TwoNodeThesis thesis;
    solver::Problem problem = support::two_node_problem(thesis);
    problem.title = "two nodes";
    support::hold(problem, "speed", 100.0 / 3.6);
    support::hold(problem, "vertical_load", 7000.0);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 296.15);
    support::start_at(problem, 296.15);
    expect_steady_equals_transient(problem, 30000.0);
}

TEST(SteadyState, LaserSpotWithRadiationEqualsItsLongTransient) {
    // k(T), radiation and natural convection: every nonlinearity of the specimen. 15 mm of rubber that loses 20 W/m2K
    // on both faces in all: 29700/20 = 1500 s, and as long again through the bulk.
    solver::Problem problem;
    problem.title = "laser spot";
    problem.mesh = mesh::build(mesh::Axisymmetric{.radius = {{0.005642, 6, 1.0}, {0.034, 10, 4.0}},
                                                  .stack = {{"tread", 0.003, 8, 2.0}, {"bulk", 0.012, 10, 3.0}}});
    problem.materials = {support::material(physics::Curve::quadratic_about(293.15, 0.29, 0.0094, 0.0), 1100.0,
                                           physics::Curve::quadratic_about(293.15, 1700.0, 4.0, 0.0)),
                         support::material(physics::Curve::quadratic_about(293.15, 0.06, 0.0002, 1e-6), 1100.0,
                                           physics::Curve::constant(1800.0))};
    for (const std::string_view id : {"conduction", "laser", "radiation", "natural_convection", "still_air"}) {
        support::switch_on(problem, id);
    }
    support::hold(problem, "laser_power", 3.0);
    support::hold(problem, "air_temperature", 296.15);
    support::start_at(problem, 296.15);
    expect_steady_equals_transient(problem, 90000.0);
}

TEST(SteadyState, VaryingConductivityIsKirchhoffsIntegralOnAnyGrid) {
    // 1500 W/m2 enter at the inner surface, pass 12 mm of k(T) and leave through 25 W/m2K: the outer surface stands 60
    // K above the air, and the inner one where the integral of k dT between them is q d (Kirchhoff's transform; Carslaw
    // and Jaeger, section 1.6): one root, by bisection. The scheme takes the mean of k between the temperatures of a
    // face, which sums to that integral over any grid; 1e-8 K is Newton's share of the tolerance below.
    constexpr double q = 1500.0;
    constexpr double outer = 60.0;  // K above 293.15 K, as all temperatures here
    const auto integral = [](double T) { return T * (0.29 + T * (0.5 * 0.0094 - T * 1e-5)); };
    double low = outer;
    double high = outer + 60.0;
    for (int i = 0; i < 100; ++i) {
        const double inner = 0.5 * (low + high);
        (integral(inner) - integral(outer) < q * 0.012 ? low : high) = inner;
    }
    for (const int cells : {1, 2, 9}) {
        solver::Problem problem;
        problem.title = "Kirchhoff";
        problem.mesh = mesh::build(mesh::Layers{.area = 2.0, .stack = {{"rubber", 0.012, cells, 1.7}}});
        problem.materials = {support::material(physics::Curve::quadratic_about(293.15, 0.29, 0.0094, -3e-5), 1100.0,
                                               physics::Curve::constant(1800.0))};
        support::switch_on(problem, "conduction");
        support::switch_on(problem, "still_air", {{"h", 25.0}}, {"outside"});
        support::switch_on(problem, "laser", {}, {"inside"});
        support::hold(problem, "air_temperature", 293.15);
        support::hold(problem, "laser_power", 2.0 * q);
        support::start_at(problem, 330.0);
        problem.settings.steady = true;
        problem.settings.tolerance = 1e-7;
        support::read(problem, "outside", mesh::over_patch(problem.mesh, 0));
        support::read(problem, "inside", mesh::over_patch(problem.mesh, 1));
        const solver::MarchReport report = support::run_closed(problem);
        EXPECT_NEAR(report.channel_final[0], 293.15 + outer, 1e-8);
        EXPECT_NEAR(report.channel_final[1], 293.15 + low, 1e-8);
    }
}

}  // namespace
}  // namespace tiretherm
