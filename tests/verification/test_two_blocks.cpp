// SPDX-License-Identifier: BSD-3-Clause
// Two finely meshed blocks tend to the two-node model at first order in their thermal resistance.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/order.hpp"
#include "tests/support/two_node_case.hpp"

namespace tiretherm {
namespace {

/// 4000 N at 100 km/h with 2 degrees of slip angle, 23 C, ten minutes.
void drive(solver::Problem& problem) {
    support::hold(problem, "speed", 100.0 / 3.6);
    support::hold(problem, "vertical_load", 4000.0);
    support::hold(problem, "slip_angle", 0.035);
    support::hold(problem, "lateral_force", 2000.0);
    support::hold(problem, "air_temperature", 296.15);
    support::hold(problem, "road_temperature", 300.15);
    support::start_at(problem, 296.15);
    problem.settings.end = 600.0;
    problem.settings.fixed_step = 10.0;
    problem.settings.tolerance = 1e-9;
    problem.settings.output_interval = 60.0;
}

/// 15 % and 85 % of the band's thickness as blocks of `cells` cells that conduct with k, joined by dZ / k(T_bulk).
solver::Problem blocks(double k, int cells) {
    const support::TwoNodeThesis thesis;
    solver::Problem problem = support::two_node_problem(thesis);
    const double thickness = problem.tire.tread_thickness;
    problem.title = "two blocks";
    problem.mesh = mesh::build(
        mesh::Layers{.area = problem.tire.outer_area(),
                     .stack = {{"surface", 0.15 * thickness, cells, 1.0}, {"bulk", 0.85 * thickness, cells, 1.0}},
                     .link_below = 0,
                     .link_length = 0.010});
    problem.materials.assign(2, support::material(k, 1100.0, 1800.0));
    problem.effects.clear();
    problem.channels.clear();
    for (const std::string_view id :
         {"conduction", "strain_energy_loss", "sliding_friction", "air_convection", "road_contact"}) {
        support::switch_on(problem, id);
        if (id == "air_convection") {
            support::choose(problem, "exponential", 1);  // as the two nodes have it
        }
    }
    support::read(problem, "surface_temperature", mesh::over_cells(problem.mesh, 0));
    support::read(problem, "bulk_temperature", mesh::over_cells(problem.mesh, 1));
    drive(problem);
    return problem;
}

/// Largest difference of either block's mean from the two-node model, every minute. K
double difference(const solver::Problem& problem) {
    solver::Problem lumps = support::two_node_problem({});
    drive(lumps);
    const support::History a = support::record(problem);
    const support::History b = support::record(lumps);
    EXPECT_EQ(a.time, b.time);
    double worst = 0.0;
    for (std::size_t i = 0; i < std::min(a.channels.size(), b.channels.size()); ++i) {
        for (std::size_t c = 0; c < 2; ++c) {
            worst = std::max(worst, std::abs(a.channels[i][c] - b.channels[i][c]));
        }
    }
    return worst;
}

TEST(TwoBlocks, TendToTheTwoNodeModelAtFirstOrderInTheirResistance) {
    // A block of thickness d that conducts with k adds a resistance of order d/k to the path of its heat, beside the
    // link's dZ/k_link = 0.01/0.5 and the film's 1/70. The difference from lumps is c1/k + c2/k^2 + ...: order 1 within
    // 0.1 once d/k of the bulk, 0.0102/k, is a tenth of the link. Both models make the same steps, so that the steps'
    // error cancels up to its own share of 1/k. Biot number of the link against the film: h dZ/k_link = 70 * 0.01/0.5,
    // of order one.
    std::vector<double> differences;
    for (const double k : {8.0, 16.0, 32.0, 64.0, 128.0}) {
        differences.push_back(difference(blocks(k, 8)));
    }
    support::expect_order("in_1_over_k", differences, 0.9, 1.1);
}

TEST(TwoBlocks, EqualTheTwoNodeModelWhenTheyHardlyResist) {
    // The difference is 3.5 K W/mK / k by the test above: 3.5e-7 K at k = 1e7 W/mK. Round-off does not forbid it:
    // between cells joined by 2e10 W/K the sixteenth digit of 300 K moves kilowatts to and fro, but what the blocks
    // hold as a whole is the balance of the mesh, which must close to its last digits however small the scaled
    // residual is.
    support::expect_below("at_1e7", difference(blocks(1e7, 4)), 1e-6);
}

TEST(TwoBlocks, SteadyResistanceIsTheBlocksAndTheLinkInSeries) {
    // Uniform sources, steady, inside insulated: per area q_b is made in the bulk, d_b thick, q_s in the surface, d_s
    // thick. Integrating -k T'' = q/d twice, the mean of the bulk stands q_b d_b/(3k) above its outer face, the link
    // drops q_b dZ/k_link(T_bulk), and the mean of the surface stands q_b d_s/(2k) + q_s d_s/(6k) below its inner face.
    // With k = 2 W/mK the blocks are a tenth of it all. 32 cells a block: half cells at the ends of a parabola leave q
    // h^2/(8 d k), 4e-5 of it; a link without the half cells beside it would miss 4e-3.
    solver::Problem problem = blocks(2.0, 32);
    problem.settings.steady = true;
    const solver::MarchReport report = support::run_closed(problem);
    const double T_surface = report.channel_final[0];
    const double T_bulk = report.channel_final[1];
    const support::TwoNodeThesis thesis;
    const double area = problem.tire.outer_area();
    const double q_b = 0.85 * report.watts[1] / area;  // strain_energy_loss
    const double q_s = 0.15 * report.watts[1] / area;
    const double drop =
        q_b * (0.0102 / (3.0 * 2.0) + 0.010 / thesis.k(T_bulk) + 0.0018 / (2.0 * 2.0)) + q_s * 0.0018 / (6.0 * 2.0);
    support::expect_below("relative_error", (T_bulk - T_surface) / drop - 1.0, 1e-4);
}

}  // namespace
}  // namespace tiretherm
