// SPDX-License-Identifier: BSD-3-Clause
// The benchmark "section", a heated rectangle: the printed reference against its double series, and the solver within
// 0.2 % of it.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "tests/support/heated_rectangle.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

// The problem "section" of performance.md, section 2.
constexpr double width = 0.225;
constexpr double depth = 0.015;
constexpr double section_conductivity = 0.25;
constexpr double capacity = 1100.0 * 1800.0;
constexpr double source = 1e5;
constexpr std::array<double, 4> times{60.0, 300.0, 600.0, 1200.0};

struct Row {
    double centre;
    double top;
    double bottom;
    double corner;
    double stored;  ///< J per metre of depth
};

/// The printed table, C and J/m.
constexpr std::array<Row, 4> table{{{26.0182, 24.9942, 25.7965, 24.7201, 19141.4},
                                    {36.2706, 29.8409, 35.4554, 28.0978, 80182.8},
                                    {45.1567, 33.6764, 44.3372, 30.2918, 132373.1},
                                    {55.1029, 37.9194, 54.3807, 32.3300, 189686.2}}};

support::HeatedRectangle exact_rectangle() {
    return {{.layers = {{width, section_conductivity, capacity}}, .h_top = 20.0, .h_bottom = 20.0},
            {.layers = {{depth, section_conductivity, capacity}}, .h_top = 60.0, .h_bottom = 10.0},
            source};
}

Row exact(const support::HeatedRectangle& series, double t) {
    return {.centre = 23.0 + series.at(0.5 * width, 0.5 * depth, t),
            .top = 23.0 + series.at(0.5 * width, 0.0, t),
            .bottom = 23.0 + series.at(0.5 * width, depth, t),
            .corner = 23.0 + series.at(0.0, 0.0, t),
            .stored = series.stored(t)};
}

/// The section as a block one cell long, 1 m, insulated in front and behind. Cells narrow towards the sides.
solver::Problem section(int nx, int nz) {
    solver::Problem problem;
    problem.title = "section";
    problem.mesh = mesh::build(mesh::Block{.x = {{-0.0875, nx, 4.0}, {0.0875, 3 * nx, 1.0}, {0.5 * width, nx, 0.25}},
                                           .y = {{0.5, 1, 1.0}},
                                           .stack = {{"rubber", depth, nz, 1.0}},
                                           .quarter = false,
                                           .side_patches = true});
    problem.materials = {support::material(section_conductivity, 1100.0, 1800.0)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "uniform_source", {{"power_density", source}});
    support::switch_on(problem, "still_air", {{"h", 60.0}}, {"top"});
    support::switch_on(problem, "still_air", {{"h", 10.0}}, {"bottom"});
    support::switch_on(problem, "still_air", {{"h", 20.0}}, {"left", "right"});
    support::hold(problem, "air_temperature", 296.15);
    support::start_at(problem, 296.15);
    support::read(problem, "centre", mesh::at_point(problem.mesh, {0.0, 0.0, 0.5 * depth}));
    support::read(problem, "top", mesh::at_point(problem.mesh, {0.0, 0.0, 0.0}));
    support::read(problem, "bottom", mesh::at_point(problem.mesh, {0.0, 0.0, depth}));
    support::read(problem, "corner", mesh::at_point(problem.mesh, {-0.5 * width, 0.0, 0.0}));
    problem.settings.end = 1200.0;
    problem.settings.output_interval = 60.0;
    return problem;
}

TEST(Section, TableIsItsDoubleSeries) {
    // Printed to four places and to 0.1 J: half a unit of the last, and as much for the table's own series, whose
    // corner is 7e-5 K short.
    const support::HeatedRectangle series = exact_rectangle();
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Row row = exact(series, times[i]);
        EXPECT_NEAR(row.centre, table[i].centre, 1e-4) << times[i];
        EXPECT_NEAR(row.top, table[i].top, 1e-4) << times[i];
        EXPECT_NEAR(row.bottom, table[i].bottom, 1e-4) << times[i];
        EXPECT_NEAR(row.corner, table[i].corner, 1e-4) << times[i];
        EXPECT_NEAR(row.stored, table[i].stored, 0.1) << times[i];
    }
}

TEST(Section, ProbesAndStoredHeatAreWithinAFifthOfAPercent) {
    // 150 x 60 cells, steps to 0.002 K, against the series: every probe of its own rise, and the heat, at all four
    // times, on which steps end as on points of a schedule. The corner has no node: it is extrapolated along the top,
    // and at 60 s its own rise is 1.7 K.
    solver::Problem problem = section(30, 60);
    problem.settings.tolerance = 0.002;
    support::schedule(problem, "road_temperature", {0.0, 60.0, 300.0, 600.0}, {296.15, 296.15, 296.15, 296.15});
    const support::History history = support::record(problem);
    const support::HeatedRectangle series = exact_rectangle();
    for (std::size_t i = 0; i < times.size(); ++i) {
        const auto row = static_cast<std::size_t>(std::lround(times[i] / 60.0));
        ASSERT_LT(row, history.time.size());
        ASSERT_NEAR(history.time[row], times[i], 1e-6);
        const Row wanted = exact(series, times[i]);
        const std::string at = "_at_" + std::to_string(static_cast<int>(times[i]));
        const std::array<std::pair<std::string, double>, 4> probes{
            {{"centre", wanted.centre}, {"top", wanted.top}, {"bottom", wanted.bottom}, {"corner", wanted.corner}}};
        for (std::size_t c = 0; c < probes.size(); ++c) {
            const double rise = probes[c].second - 23.0;
            support::expect_below(probes[c].first + at, (history.channels[row][c] - 273.15 - probes[c].second) / rise,
                                  2e-3);
        }
        support::expect_below("stored" + at, history.stored[row] / wanted.stored - 1.0, 2e-3);
    }
}

TEST(Section, HeatBetweenStepsIsAsGoodAsTheTemperatures) {
    // The steps grow to minutes, and rows every 20 s lie inside them. The heat reported there, as kelvin of the whole
    // section (6683 J/K per metre), may miss the series by no more than the temperatures may: three tolerances.
    solver::Problem problem = section(10, 30);
    problem.settings.output_interval = 20.0;
    problem.settings.tolerance = 0.02;
    const support::History history = support::record(problem);
    const support::HeatedRectangle series = exact_rectangle();
    double worst = 0.0;
    for (std::size_t row = 1; row < history.time.size(); ++row) {
        worst = std::max(worst,
                         std::abs(history.stored[row] - series.stored(history.time[row])) / (capacity * width * depth));
    }
    EXPECT_LT(history.report.steps, 60);  // rows do lie inside steps
    support::expect_below("mean_temperature", worst, 3.0 * problem.settings.tolerance);
}

TEST(Section, ProbesConvergeAtSecondOrder) {
    // All sides exchange, corners included: order 2 in the cells, steps kept far finer. The centre of an even number of
    // cells lies on an edge between them; the corner is extrapolated from two faces, second order as well.
    const support::HeatedRectangle series = exact_rectangle();
    const Row wanted = exact(series, 300.0);
    std::array<std::vector<double>, 4> errors;
    for (const int n : {1, 2, 4}) {
        solver::Problem problem = section(12 * n, 8 * n);
        problem.settings.end = 300.0;
        problem.settings.tolerance = 1e-5;
        const solver::MarchReport report = support::run_closed(problem);
        const std::array<double, 4> truth{wanted.centre, wanted.top, wanted.bottom, wanted.corner};
        for (std::size_t c = 0; c < 4; ++c) {
            errors[c].push_back(report.channel_final[c] - 273.15 - truth[c]);
        }
    }
    support::expect_order("centre", errors[0], 1.9, 2.1);
    support::expect_order("top", errors[1], 1.9, 2.1);
    support::expect_order("bottom", errors[2], 1.9, 2.1);
    support::expect_order("corner", errors[3], 1.8, 2.2);
}

}  // namespace
}  // namespace tiretherm
