// SPDX-License-Identifier: BSD-3-Clause
// Terms add up sources and exchanges by effect, name a negative conductance, and give derivatives by differences.

#include "physics/terms.hpp"

#include <gtest/gtest.h>

#include "mesh/builders.hpp"

namespace tiretherm::physics {

namespace {

/// Three nodes in a row: outside surface, one cell, inside surface.
mesh::Mesh row() {
    return mesh::build(mesh::Layers{.area = 1.0, .stack = {{.name = "a", .thickness = 0.01, .cells = 1}}});
}

}  // namespace

TEST(Terms, AddUpTheVerbsAndBookThemToTheirEffect) {
    const mesh::Mesh mesh = row();
    const std::vector<double> T{300.0, 310.0, 290.0};
    Terms terms(mesh, 2);
    terms.begin(T);
    terms.attribute_to(0);
    terms.heat(0, 5.0);
    terms.exchange(1, 2.0, 300.0);  // 2 W/K * -10 K
    terms.attribute_to(1);
    terms.exchange(1, 1.0, 320.0);  // 1 W/K * +10 K
    EXPECT_EQ(terms.node_q, (std::vector<double>{5.0, -10.0, 0.0}));
    EXPECT_EQ(terms.node_G[1], 3.0);
    EXPECT_EQ(terms.watts, (std::vector<double>{-15.0, 10.0}));
    EXPECT_FALSE(terms.nonlinear);
}

TEST(Terms, BeginForgetsEverything) {
    const mesh::Mesh mesh = row();
    const std::vector<double> T{300.0, 310.0, 290.0};
    Terms terms(mesh, 1);
    terms.begin(T);
    terms.conduct(0, 2.0, 0.1, 0.2);
    terms.heat(0, 5.0, 1.0);
    terms.add_source_derivative(0, 1, 3.0);
    terms.exchange(1, -1.0, 300.0);
    EXPECT_TRUE(terms.nonlinear);
    terms.begin(T);
    EXPECT_FALSE(terms.nonlinear);
    EXPECT_LT(terms.negative_effect, 0);
    for (const std::vector<double>* values : {&terms.face_G, &terms.face_dq_dTa, &terms.face_dq_dTb, &terms.node_G,
                                              &terms.node_q, &terms.node_slope, &terms.region_slope, &terms.watts}) {
        for (const double value : *values) {
            EXPECT_EQ(value, 0.0);
        }
    }
}

TEST(Terms, SayWhichEffectGaveANegativeConductance) {
    const mesh::Mesh mesh = row();
    const std::vector<double> T{300.0, 310.0, 290.0};
    Terms terms(mesh, 3);
    terms.begin(T);
    terms.attribute_to(1);
    terms.conduct(1, -2.0);
    terms.attribute_to(2);
    terms.exchange(2, -1.0, 300.0);
    EXPECT_EQ(terms.negative_effect, 1);  // the first one
    EXPECT_EQ(terms.negative_node, mesh.faces[1].a);
}

TEST(Terms, DifferenceOfTwoStatesGivesTheSlopeOfALocalLaw) {
    // An exchange with G = 2 + 0.1 (T - 300), told twice 0.5 K apart. At 310 K: G = 3, drop -10, and the derivative of
    // G (T_env - T) is 0.1 * (-10) - 3 = -4; node_slope holds what is beyond -G: -1, here by a forward difference that
    // adds half a step of the curvature -0.2: -1 - 0.5 * 0.5 * 0.2 = -1.05.
    const mesh::Mesh mesh = row();
    const std::vector<double> here_T{300.0, 310.0, 300.0};
    const std::vector<double> there_T{300.5, 310.5, 300.5};
    Terms terms(mesh, 1);
    Terms here(mesh, 1);
    Terms there(mesh, 1);
    terms.begin(here_T);
    here.begin(here_T);
    there.begin(there_T);
    here.exchange(1, 3.0, 300.0);
    there.exchange(1, 3.05, 300.0);
    terms.add_difference(here, there, 0.5);
    EXPECT_NEAR(terms.node_slope[1], -1.05, 1e-12);
    EXPECT_EQ(terms.watts[0], -30.0);
    EXPECT_TRUE(terms.nonlinear);
}

}  // namespace tiretherm::physics
