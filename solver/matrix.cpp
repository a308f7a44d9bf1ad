#include "solver/matrix.hpp"

#include <algorithm>

namespace tiretherm::solver {

namespace {
std::size_t at(int i) { return static_cast<std::size_t>(i); }
}  // namespace

Pattern pattern_of(const mesh::Mesh& mesh) {
    std::vector<std::vector<int>> neighbours(at(mesh.n_nodes));
    for (int i = 0; i < mesh.n_nodes; ++i) {
        neighbours[at(i)].push_back(i);
    }
    for (const mesh::Face& face : mesh.faces) {
        neighbours[at(face.a)].push_back(face.b);
        neighbours[at(face.b)].push_back(face.a);
    }
    Pattern p;
    p.n = mesh.n_nodes;
    p.start.push_back(0);
    for (int i = 0; i < p.n; ++i) {
        std::vector<int>& row = neighbours[at(i)];
        std::sort(row.begin(), row.end());
        row.erase(std::unique(row.begin(), row.end()), row.end());
        const auto own = std::lower_bound(row.begin(), row.end(), i);
        p.diagonal.push_back(p.start.back() + static_cast<int>(own - row.begin()));
        p.column.insert(p.column.end(), row.begin(), row.end());
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
    const Pattern& p = *pattern;
    for (int i = 0; i < p.n; ++i) {
        double sum = 0.0;
        for (int e = p.start[at(i)]; e < p.start[at(i) + 1]; ++e) {
            sum += value[at(e)] * x[at(p.column[at(e)])];
        }
        y[at(i)] = sum;
    }
    for (const Outer& term : outer) {
        const double mean = term.scale * (*term.mean)(x);
        for (int i = 0; i < p.n; ++i) {
            y[at(i)] += term.row[at(i)] * mean;
        }
    }
}

}  // namespace tiretherm::solver
