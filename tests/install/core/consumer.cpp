// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "mesh/builders.hpp"

/// A plate of 0.5 m2 and 12 mm in two layers holds 6 litres.
int main() {
    const auto plate = tiretherm::mesh::build(
        tiretherm::mesh::Layers{.area = 0.5, .stack = {{"tread", 0.008, 4}, {"carcass", 0.004, 2}}});
    return std::abs(plate.total_volume() - 0.006) < 1e-12 ? 0 : 1;
}
