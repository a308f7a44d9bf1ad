// SPDX-License-Identifier: BSD-3-Clause
// Builds the compressed-row pattern from the faces of a mesh; products with the matrix, its transpose and panels
// of columns.

#include "solver/linear/matrix.hpp"

#include <algorithm>

#include "mesh/index.hpp"
#include "mesh/parallel.hpp"

namespace tiretherm::solver {

Pattern pattern_of(const mesh::Mesh& mesh) {
    // All neighbours of a node side by side, with itself; a pair of nodes may be joined by several faces.
    std::vector<int> begin(at(mesh.n_nodes) + 1, 0);
    for (const mesh::Face& face : mesh.faces) {
        ++begin[at(face.a) + 1];
        ++begin[at(face.b) + 1];
    }
    for (std::size_t i = 0; i + 1 < begin.size(); ++i) {
        begin[i + 1] += begin[i] + 1;
    }
    std::vector<int> neighbours(at(begin.back()));
    std::vector<int> filled(begin.begin(), begin.end() - 1);
    for (int i = 0; i < mesh.n_nodes; ++i) {
        neighbours[at(filled[at(i)]++)] = i;
    }
    for (const mesh::Face& face : mesh.faces) {
        neighbours[at(filled[at(face.a)]++)] = face.b;
        neighbours[at(filled[at(face.b)]++)] = face.a;
    }
    Pattern p;
    p.n = mesh.n_nodes;
    p.column.reserve(neighbours.size());
    p.start.push_back(0);
    for (int i = 0; i < p.n; ++i) {
        const auto row = neighbours.begin() + begin[at(i)];
        const auto all = neighbours.begin() + begin[at(i) + 1];
        std::sort(row, all);
        const auto end = std::unique(row, all);
        const auto own = std::lower_bound(row, end, i);
        p.diagonal.push_back(p.start.back() + static_cast<int>(own - row));
        p.column.insert(p.column.end(), row, end);
        p.start.push_back(static_cast<int>(p.column.size()));
    }
    const auto place = [&](int row, int column) {
        const auto first = p.column.begin() + p.start[at(row)];
        const auto last = p.column.begin() + p.start[at(row) + 1];
        return static_cast<int>(std::lower_bound(first, last, column) - p.column.begin());
    };
    for (const mesh::Face& face : mesh.faces) {
        p.ab.push_back(place(face.a, face.b));
        p.ba.push_back(place(face.b, face.a));
    }
    return p;
}

void Matrix::multiply(std::span<const double> x, std::span<double> y) const {
    if (transposed) {
        multiply_transposed(x, y);
        return;
    }
    const Pattern& p = *pattern;
    over_nodes(at(p.n), [&](std::size_t i) {
        double sum = 0.0;
        for (std::size_t e = at(p.start[i]); e < at(p.start[i + 1]); ++e) {
            sum += value[e] * x[at(p.column[e])];
        }
        y[i] = sum;
    });
    for (const Outer& term : outer) {
        const double mean = term.scale * (*term.mean)(x);
        over_nodes(at(p.n), [&](std::size_t i) { y[i] += term.row[i] * mean; });
    }
}

void Matrix::multiply_transposed(std::span<const double> x, std::span<double> y) const {
    const Pattern& p = *pattern;
    std::fill(y.begin(), y.end(), 0.0);
    for (int i = 0; i < p.n; ++i) {
        for (int e = p.start[at(i)]; e < p.start[at(i) + 1]; ++e) {
            y[at(p.column[at(e)])] += value[at(e)] * x[at(i)];
        }
    }
    for (const Outer& term : outer) {
        double sum = 0.0;
        for (int i = 0; i < p.n; ++i) {
            sum += term.row[at(i)] * x[at(i)];
        }
        for (std::size_t i = 0; i < term.mean->nodes.size(); ++i) {
            y[at(term.mean->nodes[i])] += term.scale * sum * term.mean->weights[i];
        }
    }
}

void Matrix::multiply_block(std::span<const double> X, std::span<double> Y, std::size_t n_columns) const {
    const std::size_t n = at(pattern->n);
    for (std::size_t first = 0; first < n_columns * n; first += n) {
        multiply(X.subspan(first, n), Y.subspan(first, n));
    }
}

namespace {

/// R -= scale * left * (right' X) of an outer product, whose weights of the mean stand at some nodes.
void subtract_outer(const Matrix::Outer& term, bool transposed, ConstPanel X, Panel R) {
    const auto& nodes = term.mean->nodes;
    const auto& weights = term.mean->weights;
    PanelRow sum{};
    if (transposed) {
        for (std::size_t i = 0; i < X.size(); ++i) {
            sum += term.row[i] * X[i];
        }
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            R[at(nodes[i])] -= term.scale * weights[i] * sum;
        }
        return;
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        sum += term.scale * weights[i] * X[at(nodes[i])];
    }
    for (std::size_t i = 0; i < R.size(); ++i) {
        R[i] -= term.row[i] * sum;
    }
}

}  // namespace

void Matrix::find_residual(ConstPanel B, ConstPanel X, Panel R) const {
    const Pattern& p = *pattern;
    in_wide_vectors([&] {
        if (transposed) {
            std::ranges::copy(B, R.begin());
        }
        for (std::size_t i = 0; i < X.size(); ++i) {
            if (transposed) {
                const PanelRow here = X[i];
                for (std::size_t e = at(p.start[i]); e < at(p.start[i + 1]); ++e) {
                    R[at(p.column[e])] -= value[e] * here;
                }
                continue;
            }
            PanelRow here = B[i];
            for (std::size_t e = at(p.start[i]); e < at(p.start[i + 1]); ++e) {
                here -= value[e] * X[at(p.column[e])];
            }
            R[i] = here;
        }
        for (const Outer& term : outer) {
            subtract_outer(term, transposed, X, R);
        }
    });
}

}  // namespace tiretherm::solver
