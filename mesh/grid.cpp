// SPDX-License-Identifier: BSD-3-Clause
// Cell edges with geometric grading, w_i = w_1 q^(i-1) with q^(n-1) = ratio, and the look-up of surface nodes of a
// tensor-product mesh.

#include "mesh/grid.hpp"

#include <cmath>

namespace tiretherm::mesh {

std::vector<double> edges(double from, const std::vector<Segment>& segments) {
    std::vector<double> result{from};
    for (const Segment& segment : segments) {
        const double start = result.back();
        const double length = segment.to - start;
        const int n = segment.cells;
        // Widths w, w q, w q^2 ... with q^(n-1) = ratio.
        const double q = n > 1 ? std::pow(segment.ratio, 1.0 / (n - 1)) : 1.0;
        double sum = 0.0;
        double power = 1.0;
        std::vector<double> partial;
        for (int i = 0; i < n; ++i) {
            sum += power;
            power *= q;
            partial.push_back(sum);
        }
        for (int i = 0; i + 1 < n; ++i) {
            result.push_back(start + length * partial[static_cast<std::size_t>(i)] / sum);
        }
        result.push_back(segment.to);
    }
    return result;
}

int Grid::surface_node(Side side, int i, int j, int k) const {
    const std::vector<int>& nodes = surface[static_cast<std::size_t>(side)];
    if (nodes.empty()) {
        return -1;
    }
    switch (side) {
        case Side::x_min:
        case Side::x_max:
            return nodes[static_cast<std::size_t>(j + size(1) * k)];
        case Side::y_min:
        case Side::y_max:
            return nodes[static_cast<std::size_t>(i + size(0) * k)];
        case Side::z_min:
        case Side::z_max:
            return nodes[static_cast<std::size_t>(i + size(0) * j)];
    }
    return -1;
}

}  // namespace tiretherm::mesh
