// SPDX-License-Identifier: BSD-3-Clause
// Jacobi iteration over the rows of the surfaces.

#include "solver/sensitivity/surfaces.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/index.hpp"

namespace tiretherm::solver {

namespace {

double entry_of(const Matrix& J, int row, int column) {
    const Pattern& p = *J.pattern;
    const auto begin = p.column.begin();
    const auto place = std::lower_bound(begin + p.start[at(row)], begin + p.start[at(row) + 1], column);
    return J.value[static_cast<std::size_t>(place - begin)];
}

}  // namespace

SurfaceSettling::SurfaceSettling(const System& system) : residual_(at(system.size())) {
    for (std::size_t i = 0; i < residual_.size(); ++i) {
        (system.has_capacity(i) ? cells_ : surfaces_).push_back(i);
    }
}

void SurfaceSettling::find_rows(const Matrix& J) {
    const Pattern& p = *J.pattern;
    entries_.clear();
    first_.assign(1, 0);
    diagonal_.clear();
    for (const std::size_t i : surfaces_) {
        for (int e = p.start[i]; e < p.start[i + 1]; ++e) {
            const int j = p.column[at(e)];
            const double value = J.transposed ? entry_of(J, j, static_cast<int>(i)) : J.value[at(e)];
            entries_.push_back({.column = at(j), .value = value});
        }
        first_.push_back(entries_.size());
        diagonal_.push_back(J.value[at(p.diagonal[i])]);
    }
}

void SurfaceSettling::find_residual(const Matrix& J, std::span<const double> right, double scale,
                                    std::span<const double> x) {
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
        double residual = scale * right[surfaces_[s]];
        for (std::size_t e = first_[s]; e < first_[s + 1]; ++e) {
            residual -= entries_[e].value * x[entries_[e].column];
        }
        residual_[surfaces_[s]] = residual;
    }
    for (const Matrix::Outer& term : J.outer) {
        if (J.transposed) {
            double sum = 0.0;
            for (std::size_t i = 0; i < x.size(); ++i) {
                sum += term.row[i] * x[i];
            }
            for (std::size_t i = 0; i < term.mean->nodes.size(); ++i) {
                residual_[at(term.mean->nodes[i])] -= term.scale * sum * term.mean->weights[i];
            }
            continue;
        }
        const double mean = term.scale * (*term.mean)(x);
        for (const std::size_t i : surfaces_) {
            residual_[i] -= term.row[i] * mean;
        }
    }
}

Status SurfaceSettling::settle(const Matrix& J, std::span<const double> right, double scale, double tolerance,
                               std::span<double> x) {
    constexpr int most_iterations = 60;  // round-off is reached in 10 to 20
    constexpr double enough = 1e-9;
    const Status apart{Outcome::not_converged, "the sensitivities of the surfaces did not converge"};
    const std::size_t n = residual_.size();
    find_rows(J);
    for (std::size_t first = 0; first < x.size(); first += n) {
        const std::span<double> column = x.subspan(first, n);
        double largest_cell = 0.0;
        for (const std::size_t i : cells_) {
            largest_cell = std::max(largest_cell, std::abs(column[i]));
        }
        double error = 0.0;
        for (int iteration = 0; iteration < most_iterations; ++iteration) {
            find_residual(J, right.subspan(first, n), scale, column);
            double change = 0.0;
            double largest = largest_cell;
            for (std::size_t s = 0; s < surfaces_.size(); ++s) {
                const double by = residual_[surfaces_[s]] / diagonal_[s];
                if (!std::isfinite(by)) {  // which no maximum would show
                    return apart;
                }
                column[surfaces_[s]] += by;
                change = std::max(change, std::abs(by));
                largest = std::max(largest, std::abs(column[surfaces_[s]]));
            }
            error = largest > 0.0 ? change / largest : 0.0;
            if (error <= tolerance) {
                break;
            }
        }
        if (error > std::max(tolerance, enough)) {
            return apart;
        }
    }
    return {};
}

}  // namespace tiretherm::solver
