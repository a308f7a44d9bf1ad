// SPDX-License-Identifier: BSD-3-Clause
// What drives a hot spot: slopes by the tangent, and the probability that follows from them.
#include "solver/hot_spot/hot_spot_drivers.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "solver/sensitivity/slopes.hpp"
#include "support/problem.hpp"

namespace tiretherm::solver {

namespace {

/// A strip with heat made inside, insulated within, under air of 300 K: linear in the heat, and its inside is hottest.
Problem heated_strip() {
    Problem problem;
    problem.mesh = mesh::build(mesh::Layers{.area = 1.0, .stack = {{"rubber", 0.012, 12}}});
    problem.materials = {support::material(0.3, 1000.0, 1500.0)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "uniform_source", {{"power_density", 1e5}});
    support::switch_on(problem, "still_air", {{"h", 20.0}}, {"outside"});
    support::hold(problem, "air_temperature", 300.0);
    support::start_at(problem, 300.0);
    problem.settings.end = 1e5;
    problem.settings.steady = true;
    return problem;
}

HotPlace inside_of(const Problem& problem) {
    const mesh::Patch& inside = problem.mesh.patches[static_cast<std::size_t>(problem.mesh.find_patch("inside"))];
    return {.where = {.nodes = {inside.faces.front().node}, .weights = {1.0}}, .time = 1e5};
}

}  // namespace

// Steady: T = T_air + q L/h + q L^2/(2 k) inside, L = 12 mm: 300 + 60 + 24 = 384 K. It is proportional to q, slope
// 84 K over 1e5 W/m3; by h it is -q L/h^2 = -3 K per W/m2K, by k (scaled at one knot) -q L^2/(2 k^2) = -80 K per W/mK.
TEST(HotPlaceSlopes, AreThoseOfTheClosedForm) {
    const Problem problem = heated_strip();
    const std::vector<FreeParameter> numbers{number(problem, "uniform_source", "power_density"),
                                             number(problem, "still_air", "h"),
                                             law(FreeParameter::Kind::conductivity, {0}, {350.0}, 0)};
    const std::vector<HotPlace> places{inside_of(problem)};
    const PlaceSlopes slopes = place_slopes(problem, places, numbers);
    ASSERT_TRUE(slopes.status.ok()) << slopes.status.message;
    ASSERT_EQ(slopes.slope.size(), 3U);
    EXPECT_NEAR(slopes.temperature[0], 384.0, 1e-6);
    EXPECT_NEAR(slopes.slope[0], 84e-5, 84e-5 * 1e-5);
    EXPECT_NEAR(slopes.slope[1], -3.0, 3.0 * 1e-4);
    EXPECT_NEAR(slopes.slope[2], -80.0, 80.0 * 0.02);  // one-sided over 1e-6 of it, curved by the grid of 12 cells
}

// In a run of the lump of 12 mm (nearly: k is large) the tangent is that at the time asked for: from cold for one time
// constant, rho c L/h = 900 s, the rise is 60 K (1 - 1/e), proportional to the heat.
TEST(HotPlaceSlopes, BelongToTheirTime) {
    Problem problem = heated_strip();
    problem.materials = {support::material(400.0, 1000.0, 1500.0)};
    problem.settings.steady = false;
    problem.settings.end = 1800.0;
    problem.settings.tolerance = 1e-4;
    HotPlace place = inside_of(problem);
    const std::vector<FreeParameter> numbers{number(problem, "uniform_source", "power_density")};
    for (const double t : {900.0, 1800.0}) {
        place.time = t;
        const PlaceSlopes slopes = place_slopes(problem, std::vector{place}, numbers);
        ASSERT_TRUE(slopes.status.ok()) << slopes.status.message;
        const double rise = 60.0 * -std::expm1(-t / 900.0);
        EXPECT_NEAR(slopes.temperature[0] - 300.0, rise, 0.05);
        EXPECT_NEAR(slopes.slope[0] * 1e5, slopes.temperature[0] - 300.0, 1e-3);
    }
}

// 3 K and 4 K, independent: 5 K, shares of 36 and 64 %. One deviation above the mean lies 15.866 % of a normal
// distribution, half of it above the mean.
TEST(Spread, AddsVariancesAndTellsTheChance) {
    const Spread spread = spread_of({{.name = "film", .kelvin = -3.0}, {.name = "loss", .kelvin = 4.0}}, 380.0);
    EXPECT_DOUBLE_EQ(spread.standard_deviation, 5.0);
    EXPECT_EQ(spread.drivers[0].name, "loss");
    EXPECT_NEAR(spread.share(0), 0.64, 1e-12);
    EXPECT_NEAR(spread.share(1), 0.36, 1e-12);
    EXPECT_NEAR(spread.chance_above(385.0), 0.158655, 1e-6);
    EXPECT_NEAR(spread.chance_above(380.0), 0.5, 1e-12);
    EXPECT_NEAR(spread.chance_above(375.0), 0.841345, 1e-6);
}

TEST(Spread, WithoutUncertaintyIsCertain) {
    EXPECT_DOUBLE_EQ(spread_of({}, 380.0).chance_above(381.0), 0.0);
    EXPECT_DOUBLE_EQ(spread_of({}, 380.0).chance_above(379.0), 1.0);
}

}  // namespace tiretherm::solver
