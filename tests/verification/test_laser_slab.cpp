// SPDX-License-Identifier: BSD-3-Clause
// The benchmark "laser slab": the printed reference against its exact series, and block and disc meshes within 0.2 % of
// it.

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <numbers>
#include <vector>

#include "tests/support/laser_slab.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

constexpr double laboratory_air = 296.15;
const double spot = std::sqrt(1e-4 / std::numbers::pi);
constexpr std::array<double, 4> times{10.0, 60.0, 300.0, 600.0};

/// Reference values of performance.md, section 1, in C and, for the quarter, J.
struct Reference {
    std::array<double, 4> top;
    std::array<double, 4> bottom;
    std::array<double, 4> stored;
};
constexpr Reference linear{.top = {58.5838, 100.1550, 140.7838, 153.5226},
                           .bottom = {23.0000, 23.0000, 23.2203, 25.6527},
                           .stored = {2.44013, 14.07978, 62.84917, 113.64215}};
constexpr Reference nonlinear{.top = {57.3418, 86.3487, 108.0413, 113.9368},
                              .bottom = {23.0000, 23.0000, 23.1936, 25.5181},
                              .stored = {2.43817, 14.12887, 63.47797, 115.09454}};

/// K1 of 3 mm on K2 of 12 mm; the linear variant takes both at 40 C.
void fill(solver::Problem& problem, bool is_linear) {
    auto K1 = physics::Curve::quadratic_about(293.15, 0.29, 0.0094, 0.0);
    auto K2 = physics::Curve::quadratic_about(293.15, 0.060, 0.0002, 0.0);
    if (is_linear) {
        K1 = physics::Curve::constant(K1.value(313.15));
        K2 = physics::Curve::constant(K2.value(313.15));
    }
    const auto c = physics::Curve::constant(1800.0);
    problem.materials = {support::material(K1, 1100.0, c), support::material(K2, 1100.0, c)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "laser", {{"radius", spot}});
    support::switch_on(problem, "still_air");  // 10 W/m2K on top and bottom
    support::hold(problem, "laser_power", 1.0);
    support::hold(problem, "air_temperature", laboratory_air);
    support::start_at(problem, laboratory_air);
    support::read(problem, "top", mesh::at_point(problem.mesh, {0.0, 0.0, 0.0}));
    support::read(problem, "bottom", mesh::at_point(problem.mesh, {0.0, 0.0, 0.015}));
    problem.settings.end = 600.0;
    problem.settings.output_interval = 10.0;
}

/// Equal cells over the spot, then wider towards the side.
std::vector<mesh::Segment> across(int spot_cells, int cells, double ratio, double end) {
    return {{spot, spot_cells, 1.0}, {end, cells, ratio}};
}

solver::Problem block(bool is_linear) {
    solver::Problem problem;
    problem.title = "laser slab, block";
    problem.mesh = mesh::build(mesh::Block{.x = across(6, 14, 3.0, 0.030),
                                           .y = across(6, 14, 3.0, 0.030),
                                           .stack = {{"tread", 0.003, 12, 4.0}, {"bulk", 0.012, 80, 1.0}},
                                           .quarter = true});
    fill(problem, is_linear);
    problem.settings.tolerance = 0.01;
    return problem;
}

/// A round slab of the same area: pi R^2 = (60 mm)^2.
const double equal_radius = 0.060 / std::sqrt(std::numbers::pi);

solver::Problem round(bool is_linear, double radius = equal_radius) {
    solver::Problem problem;
    problem.title = "laser slab, axisymmetric";
    problem.mesh = mesh::build(mesh::Axisymmetric{.radius = across(20, 40, 5.0, radius),
                                                  .stack = {{"tread", 0.003, 20, 4.0}, {"bulk", 0.012, 100, 1.0}}});
    fill(problem, is_linear);
    problem.settings.tolerance = 0.002;
    return problem;
}

/// Errors at the five probes of performance.md as shares of each probe's own rise (top at 10, 60, 300, 600 s, bottom at
/// 600 s), and of the stored heat at the four times. @param share of the whole that the mesh is, over a quarter
std::array<double, 9> errors(const solver::Problem& problem, const Reference& reference, double quarters) {
    const support::History history = support::record(problem);
    std::array<double, 9> result;
    result.fill(1.0);
    for (std::size_t row = 0; row < history.time.size(); ++row) {
        for (std::size_t i = 0; i < times.size(); ++i) {
            if (std::abs(history.time[row] - times[i]) < 1e-6) {
                const auto share = [](double is, double should) { return (is - should) / (should - 23.0); };
                result[i] = share(history.channels[row][0] - 273.15, reference.top[i]);
                if (i == 3) {
                    result[4] = share(history.channels[row][1] - 273.15, reference.bottom[i]);
                }
                result[5 + i] = history.stored[row] / quarters / reference.stored[i] - 1.0;
            }
        }
    }
    return result;
}

constexpr double wanted = 2e-3;  // 0.2 % of each probe's own rise

void expect_all_below(const std::array<double, 9>& found, std::string_view of, double bottom_bound) {
    const std::array<std::string_view, 9> name{"top_10",    "top_60",    "top_300",    "top_600",   "bottom_600",
                                               "stored_10", "stored_60", "stored_300", "stored_600"};
    for (std::size_t i = 0; i < found.size(); ++i) {
        support::expect_below(std::string(of) + std::string(name[i]), found[i], i == 4 ? bottom_bound : wanted);
    }
}

TEST(LaserSlab, TableOfTheLinearProblemIsItsSeries) {
    // The double cosine series times the modes of two layers, laser_slab.hpp, computed here and compared with the
    // printed table: its temperatures are good to 0.0005 K, its heats are printed to 1e-5 J, and the series is cut at
    // 1e-4 K.
    const support::LaserSlab exact(
        {.layers = {{0.003, 0.478, 1.98e6}, {0.012, 0.064, 1.98e6}}, .h_top = 10.0, .h_bottom = 10.0}, 0.030, spot,
        1.0);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const support::LaserSlab::Values now = exact.at(times[i]);
        support::expect_below("top_" + std::to_string(i), 23.0 + now.top - linear.top[i], 7e-4);
        support::expect_below("bottom_" + std::to_string(i), 23.0 + now.bottom - linear.bottom[i], 7e-4);
        support::expect_below("stored_" + std::to_string(i), now.stored - linear.stored[i], 2e-5);
    }
}

// Blocks: 20 x 20 x 92 cells of a quarter, steps to 0.01 K. The bottom has risen by 2.65 K only when the front of heat,
// an exponential of 4 mm, arrives there through the bulk: what is 0.2 % on top is 0.5 % of that, 13 mK.

TEST(LaserSlab, LinearBlockIsWithinAFifthOfAPercent) { expect_all_below(errors(block(true), linear, 1.0), "", 5e-3); }

TEST(LaserSlab, NonlinearBlockIsWithinAFifthOfAPercentInTenSeconds) {
    // K1 and K2 grow with temperature; reference by Richardson extrapolation, good to 0.003 K.
    const std::clock_t begin = std::clock();  // of this process, so that other work on the machine does not count
    expect_all_below(errors(block(false), nonlinear, 1.0), "", 5e-3);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    testing::Test::RecordProperty("seconds", support::formatted({seconds}));
#if defined(__OPTIMIZE__) && !defined(TIRETHERM_SANITIZED)
    EXPECT_LE(seconds, 10.0);
#endif
}

TEST(LaserSlab, RoundSlabsOfEqualAreaAreWithinAFifthOfAPercent) {
    // The corners of the square are moved onto a circle of the same area, four quarters of it; the next test says why
    // that may be done. 60 x 120 cells, steps to 0.002 K: every probe, the bottom too.
    expect_all_below(errors(round(true), linear, 4.0), "linear_", wanted);
    expect_all_below(errors(round(false), nonlinear, 4.0), "nonlinear_", wanted);
}

TEST(LaserSlab, PlaceOfTheRimHardlyMatters) {
    // The circle inside the square (30 mm) and the one through its corners (42.4 mm) hold the square between them. At
    // the probes they differ by less than a tenth of what the problem is judged by: sqrt(alpha t) of the tread is 12 mm
    // after 600 s, and the faces let go of heat on its way out.
    const support::History inscribed = support::record(round(true, 0.030));
    const support::History circumscribed = support::record(round(true, 0.030 * std::numbers::sqrt2));
    ASSERT_EQ(inscribed.time.size(), circumscribed.time.size());
    for (std::size_t i = 0; i < 2; ++i) {
        const double rise = inscribed.channels.back()[i] - laboratory_air;
        const double change = (inscribed.channels.back()[i] - circumscribed.channels.back()[i]) / rise;
        support::expect_below(i == 0 ? "top" : "bottom", change, 1e-3);
    }
}

}  // namespace
}  // namespace tiretherm
