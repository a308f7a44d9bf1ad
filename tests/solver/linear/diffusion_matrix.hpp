// SPDX-License-Identifier: BSD-3-Clause
// Matrices like those of a time step, and vectors, for the tests of the linear solvers.
#pragma once

#include <random>
#include <vector>

#include "mesh/builders.hpp"
#include "solver/linear/matrix.hpp"

namespace tiretherm::solver {

inline mesh::Mesh cube(int n) {
    const std::vector<mesh::Segment> side{{.to = 0.01, .cells = n}};
    return mesh::build(mesh::Block{.x = side, .y = side, .stack = {{.name = "a", .thickness = 0.01, .cells = n}}});
}

/// C + K with random conductances: symmetric positive definite while C > 0.
inline Matrix diffusion(const mesh::Mesh& mesh, const Pattern& pattern, double capacity) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> conductance(0.1, 10.0);
    Matrix matrix;
    matrix.pattern = &pattern;
    matrix.value.assign(pattern.nonzeros(), 0.0);
    for (int i = 0; i < pattern.n; ++i) {
        matrix.value[static_cast<std::size_t>(pattern.diagonal[static_cast<std::size_t>(i)])] = capacity;
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const double G = conductance(random);
        matrix.value[static_cast<std::size_t>(pattern.ab[f])] -= G;
        matrix.value[static_cast<std::size_t>(pattern.ba[f])] -= G;
        for (const int end : {mesh.faces[f].a, mesh.faces[f].b}) {
            matrix.value[static_cast<std::size_t>(pattern.diagonal[static_cast<std::size_t>(end)])] += G;
        }
    }
    return matrix;
}

inline std::vector<double> random_vector(int n) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::vector<double> v(static_cast<std::size_t>(n));
    for (double& x : v) {
        x = unit(random);
    }
    return v;
}

}  // namespace tiretherm::solver
