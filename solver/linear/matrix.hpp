// SPDX-License-Identifier: BSD-3-Clause
// Sparse matrix on the pattern of a mesh, plus the few outer products row * mean' of laws that follow a region's mean
// temperature.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "solver/linear/panel.hpp"

namespace tiretherm::solver {

/// Where the matrix of a mesh may be nonzero: built once. Rows compressed, columns ascending, structurally symmetric.
struct Pattern {
    int n = 0;
    std::vector<int> start;     ///< [n + 1]
    std::vector<int> column;    ///< [n_nonzeros]
    std::vector<int> diagonal;  ///< [n] place of (i, i)
    std::vector<int> ab;        ///< [n_faces] place of (a, b) of each face
    std::vector<int> ba;        ///< [n_faces] place of (b, a)

    [[nodiscard]] std::size_t nonzeros() const { return column.size(); }
};

[[nodiscard]] Pattern pattern_of(const mesh::Mesh& mesh);

/// A matrix of K (or J) on the pattern, and the few outer products row * mean' that laws of region means add to it.
struct Matrix {
    const Pattern* pattern = nullptr;
    std::vector<double> value;  ///< [n_nonzeros]
    bool symmetric = true;
    bool transposed = false;  ///< stands for the transposed matrix in all products

    /// One law of a region's mean: adds scale * row * (weights of the mean)'.
    struct Outer {
        std::span<const double> row;  ///< [n]
        const mesh::Functional* mean = nullptr;
        double scale = 0.0;
    };
    std::vector<Outer> outer;

    /// y = M x. Allocates nothing.
    void multiply(std::span<const double> x, std::span<double> y) const;
    /// y = M' x. Allocates nothing.
    void multiply_transposed(std::span<const double> x, std::span<double> y) const;
    /// Y = M X for several columns, one after the other in memory. Allocates nothing. @param X, Y [n_columns][n]
    void multiply_block(std::span<const double> X, std::span<double> Y, std::size_t n_columns) const;
    /// R = B - M X. Allocates nothing.
    void find_residual(ConstPanel B, ConstPanel X, Panel R) const;
};

}  // namespace tiretherm::solver
