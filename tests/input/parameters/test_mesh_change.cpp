// SPDX-License-Identifier: BSD-3-Clause
// Two nodes as layers: mass, area and places stay; finer cells.

#include "input/parameters/mesh_change.hpp"

#include <numeric>

#include <gtest/gtest.h>

#include "input/runs/read_experiment.hpp"
#include "tests/support/written.hpp"

namespace tiretherm::input {
namespace {

const std::string practice = TIRETHERM_SOURCE_DIR "/cases/practice/";

double heat_capacity(const solver::Problem& problem) {
    double sum = 0.0;
    for (std::size_t n = 0; n < static_cast<std::size_t>(problem.mesh.n_nodes); ++n) {
        const physics::Material& material = problem.materials[static_cast<std::size_t>(problem.mesh.layer[n])];
        sum += material.density * material.heat_capacity.value(300.0) * problem.mesh.volume[n];
    }
    return sum;
}

TEST(MeshChange, LayersHaveTheMassOfTheTwoNodes) {
    const std::string file = practice + "two_node_bench.toml";
    const ExperimentReading lumps = read_experiment(file);
    ASSERT_TRUE(lumps.experiment);
    const solver::Problem& two = lumps.experiment->runs.front().problem;
    const std::optional<double> thickness = thickness_as_layers(two);
    ASSERT_TRUE(thickness);
    const ExperimentReading layers = read_experiment(file, {}, ReadMode::measured, {.layers = *thickness});
    ASSERT_TRUE(layers.experiment) << layers.errors.front().what;
    const solver::Problem& many = layers.experiment->runs.front().problem;
    EXPECT_GT(many.mesh.n_nodes, 20);
    EXPECT_EQ(many.mesh.layers, two.mesh.layers);
    EXPECT_NEAR(heat_capacity(many), heat_capacity(two), 1e-9 * heat_capacity(two));
    EXPECT_EQ(layers.experiment->parameters.size(), lumps.experiment->parameters.size());
    EXPECT_FALSE(thickness_as_layers(many));
}

TEST(MeshChange, MultipliesCells) {
    const std::string file = practice + "layers_bench.toml";
    const ExperimentReading one = read_experiment(file);
    const ExperimentReading three = read_experiment(file, {}, ReadMode::measured, {.finer = 3});
    ASSERT_TRUE(one.experiment && three.experiment);
    // 16 and 7 cells; nodes of faces and of gas are as many in both.
    EXPECT_EQ(three.experiment->runs.front().problem.mesh.n_nodes - one.experiment->runs.front().problem.mesh.n_nodes,
              2 * (16 + 7));
    EXPECT_FALSE(thickness_as_layers(one.experiment->runs.front().problem));
}

}  // namespace
}  // namespace tiretherm::input
