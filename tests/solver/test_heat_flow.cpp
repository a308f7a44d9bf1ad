// SPDX-License-Identifier: BSD-3-Clause
// Heat flow into the nodes of a small and of a large mesh, which find it in two ways: beside the sum over their faces.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/parallel.hpp"
#include "solver/system.hpp"
#include "tests/support/problem.hpp"

namespace tiretherm::solver {
namespace {

/// A block of rubber with k(T), n cells a side.
Problem block(int n) {
    const std::vector<mesh::Segment> side{{.to = 0.030, .cells = n}};
    Problem problem;
    problem.mesh =
        mesh::build(mesh::Block{.x = side, .y = side, .stack = {{.name = "rubber", .thickness = 0.015, .cells = n}}});
    problem.materials = {support::material(physics::Curve::quadratic_about(293.15, 0.29, 0.0094, 0.0), 1100.0,
                                           physics::Curve::constant(1800.0))};
    support::switch_on(problem, "conduction");
    support::start_at(problem, 296.15);
    return problem;
}

// A node has at most six faces. Their sum in another order, and a product before it, differ by at most a dozen roundings
// of 1.1e-16 of the sum of the sizes: 2e-15 of it.
TEST(HeatFlow, OfSmallAndLargeMeshesIsTheSumOverTheirFaces) {
    for (const int n : {8, 17}) {
        const Problem problem = block(n);
        System system(problem);
        const auto nodes = static_cast<std::size_t>(problem.mesh.n_nodes);
        ASSERT_EQ(ranges_of(nodes) > 1, n == 17);  // the two ways
        std::vector<double> T(nodes);
        for (std::size_t i = 0; i < nodes; ++i) {
            T[i] = 320.0 + 15.0 * std::sin(0.7 * static_cast<double>(i));
        }
        system.evaluate(T, {});
        std::vector<double> sum(nodes, 0.0);
        std::vector<double> size(nodes, 0.0);
        for (std::size_t f = 0; f < problem.mesh.faces.size(); ++f) {
            const auto a = static_cast<std::size_t>(problem.mesh.faces[f].a);
            const auto b = static_cast<std::size_t>(problem.mesh.faces[f].b);
            const double flow = system.terms().face_G[f] * (T[b] - T[a]);
            sum[a] += flow;
            sum[b] -= flow;
            size[a] += std::abs(flow);
            size[b] += std::abs(flow);
        }
        for (std::size_t i = 0; i < nodes; ++i) {
            ASSERT_GT(size[i], 0.0) << i;
            ASSERT_NEAR(system.heat_flow()[i], sum[i], 2e-15 * size[i]) << i << " of " << n << " cells a side";
        }
    }
}

}  // namespace
}  // namespace tiretherm::solver
