// SPDX-License-Identifier: BSD-3-Clause
// Nodes of quadratic elements with geometric grading.

#include "numerics/quadratic_truth.hpp"

#include <cmath>

namespace hidden_effects::quadratic {

void append_elements(std::vector<double>& nodes, double to, int count, double ratio) {
    const double from = nodes.back();
    const double growth = count > 1 ? std::pow(ratio, 1.0 / (count - 1)) : 1.0;
    double total = 0.0;
    for (int i = 0; i < count; ++i) {
        total += std::pow(growth, i);
    }
    double reached = 0.0;
    for (int i = 0; i < count; ++i) {
        const double length = std::pow(growth, i) / total;
        nodes.push_back(from + (to - from) * (reached + 0.5 * length));
        reached += length;
        nodes.push_back(i + 1 == count ? to : from + (to - from) * reached);
    }
}

}  // namespace hidden_effects::quadratic
