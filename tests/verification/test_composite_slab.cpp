// SPDX-License-Identifier: BSD-3-Clause
// Two-layer slab with k jumping by 12.7: second order against the exact series of layered_slab.hpp, cooling and heated
// by a flux.

#include <array>
#include <cmath>

#include "tests/support/layered_slab.hpp"
#include "tests/support/order.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm {
namespace {

// Two layers like those identified with the laser: 8 mm that conduct well on 4 mm that hardly do.
constexpr double air = 296.15;
constexpr double hot = 376.15;
constexpr double area = 0.01;

support::LayeredSlab exact_slab() {
    return {
        .layers = {{0.008, 0.95, 1100.0 * 1800.0}, {0.004, 0.075, 1250.0 * 1500.0}}, .h_top = 40.0, .h_bottom = 10.0};
}

solver::Problem slab(int refinement, double ratio) {
    solver::Problem problem;
    problem.title = "composite slab";
    problem.mesh = mesh::build(
        mesh::Layers{.area = area,
                     .stack = {{"tread", 0.008, 4 * refinement, ratio}, {"bulk", 0.004, 3 * refinement, 1.0 / ratio}}});
    problem.materials = {support::material(0.95, 1100.0, 1800.0), support::material(0.075, 1250.0, 1500.0)};
    support::switch_on(problem, "conduction");
    support::switch_on(problem, "still_air", {{"h", 40.0}}, {"outside"});
    support::switch_on(problem, "still_air", {{"h", 10.0}}, {"inside"});
    support::hold(problem, "air_temperature", air);
    problem.settings.end = 240.0;
    problem.settings.tolerance = 1e-8;
    problem.settings.output_interval = 240.0;
    const auto at = [&](double z) { return mesh::at_point(problem.mesh, {0.5 * area, 0.5, z}); };
    support::read(problem, "outside", at(0.0));
    support::read(problem, "inside", at(0.012));
    return problem;
}

TEST(CompositeSlab, ModesAreOrthogonalInEnergy) {
    // Eigenfunctions of a Sturm-Liouville problem are orthogonal with the weight C: the integral of C Z_i Z_j, here by
    // the midpoint rule on 40000 pieces, whose error is of the square of a piece's share of a wave: 1e-6 beside the
    // norm.
    const support::LayeredSlab exact = exact_slab();
    std::vector<support::LayeredSlab::Mode> modes(6);
    for (int j = 0; j < 6; ++j) {
        modes[static_cast<std::size_t>(j)] = exact.mode(j);
    }
    constexpr int pieces = 40000;
    for (std::size_t i = 0; i < modes.size(); ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = 0.0;
            for (int p = 0; p < pieces; ++p) {
                const double z = 0.012 * (p + 0.5) / pieces;
                const double capacity = exact.layers[z < 0.008 ? 0 : 1].capacity;
                sum += capacity * exact.value(modes[i], z) * exact.value(modes[j], z) * 0.012 / pieces;
            }
            const double scale = std::sqrt(modes[i].norm * modes[j].norm);
            EXPECT_NEAR(sum / scale, i == j ? 1.0 : 0.0, 1e-6) << i << ", " << j;
        }
    }
}

TEST(CompositeSlab, CoolsAtSecondOrderEverywhere) {
    // From 103 C everywhere into air of 23 C, 240 s: T = T_air + 80 K sum c_j Z_j(z) exp(-mu_j t) with the eigenvalues
    // of both layers together. Conductivities differ by 12.7 at the interface: a scheme that averages k instead of
    // adding half resistances falls to first order. Cells grade by 2 towards the faces, with a jump of width at the
    // interface. Looked at: both surfaces, the root mean square over all cells by volume, and the heat given off.
    const support::LayeredSlab exact = exact_slab();
    const auto modes = exact.modes(240.0);
    const double capacity = 0.008 * 1100.0 * 1800.0 + 0.004 * 1250.0 * 1500.0;  // J/(m2 K)
    std::vector<double> outside;
    std::vector<double> inside;
    std::vector<double> field;
    std::vector<double> stored;
    for (const int refinement : {2, 4, 8, 16}) {
        solver::Problem problem = slab(refinement, 2.0);
        support::start_at(problem, hot);
        std::vector<double> T;
        const solver::MarchReport report = support::run_closed(problem, [&](const solver::Snapshot& now) {
            T.assign(now.temperature.begin(), now.temperature.end());
            return true;
        });
        const auto truth = [&](double z) { return air + (hot - air) * exact.cooling(modes, z, 240.0); };
        double squares = 0.0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(problem.mesh.n_cells); ++i) {
            squares += problem.mesh.volume[i] * std::pow(T[i] - truth(problem.mesh.centre[i][2]), 2);
        }
        field.push_back(std::sqrt(squares / problem.mesh.total_volume()));
        outside.push_back(report.channel_final[0] - truth(0.0));
        inside.push_back(report.channel_final[1] - truth(0.012));
        stored.push_back(report.stored / area / capacity -
                         (hot - air) * (exact.cooling_store(modes, 240.0) / capacity - 1.0));
    }
    support::expect_order("outside", outside, 1.9, 2.1);
    support::expect_order("inside", inside, 1.9, 2.1);
    support::expect_order("field", field, 1.9, 2.1);
    support::expect_order("stored", stored, 1.9, 2.1);
}

TEST(CompositeSlab, HeatsUnderAFluxAtSecondOrder) {
    // 5 kW/m2 absorbed by the outer surface from 23 C: steady state by adding resistances, minus what the modes still
    // lack. 1/(h_top + 1/(0.008/0.95 + 0.004/0.075 + 1/10)) = 1/(40 + 6.183): 108.3 K at the surface in the end.
    const support::LayeredSlab exact = exact_slab();
    const auto modes = exact.modes(240.0);
    EXPECT_NEAR(5000.0 * exact.steady_heating().top, 108.27, 0.01);
    // Every mode together makes up the steady state: sum Z_j(0)^2/(mu_j norm_j) = S(0), with a tail of 1/j.
    EXPECT_NEAR(exact.heating_deficit(exact.modes(1.0, 4000), 0.0, 0.0) / exact.steady_heating().top, 1.0, 1e-4);
    std::array<std::vector<double>, 2> errors;
    for (const int refinement : {2, 4, 8, 16}) {
        solver::Problem problem = slab(refinement, 2.0);
        support::start_at(problem, air);
        // A strip has no disc: its one outer face takes all the power.
        support::switch_on(problem, "laser", {}, {"outside"});
        support::hold(problem, "laser_power", 5000.0 * area);
        const solver::MarchReport report = support::run_closed(problem);
        errors[0].push_back(report.channel_final[0] - air -
                            5000.0 * (exact.steady_heating().top - exact.heating_deficit(modes, 0.0, 240.0)));
        errors[1].push_back(report.channel_final[1] - air -
                            5000.0 * (exact.steady_heating().bottom - exact.heating_deficit(modes, 0.012, 240.0)));
    }
    support::expect_order("outside", errors[0], 1.9, 2.1);
    support::expect_order("inside", errors[1], 1.9, 2.1);
}

}  // namespace
}  // namespace tiretherm
