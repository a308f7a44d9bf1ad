// SPDX-License-Identifier: BSD-3-Clause
// Multilinear interpolation: the sum over the corners of the grid's cell, each with the product of its shares.

#include "physics/tire_laws/grid_table.hpp"

#include <algorithm>
#include <cstddef>

#include "physics/bracket.hpp"

namespace tiretherm::physics {

double GridTable::value(const Inputs& inputs, double bulk) const {
    double sum = 0.0;
    const std::size_t corners = std::size_t{1} << axes.size();
    for (std::size_t corner = 0; corner < corners; ++corner) {
        double weight = 1.0;
        std::size_t index = 0;
        for (std::size_t a = 0; a < axes.size(); ++a) {
            const Axis& axis = axes[a];
            const Bracket spot = bracket(axis.at, axis.input != nullptr ? inputs.*axis.input : bulk);
            const bool upper = (corner >> a & 1U) != 0;
            weight *= upper ? spot.share : 1.0 - spot.share;
            index = index * axis.at.size() + (upper ? spot.above : spot.below);
        }
        sum += weight > 0.0 ? weight * values[index] : 0.0;
    }
    return sum;
}

const GridTable::Axis* GridTable::find(double Inputs::*input) const {
    const auto found = std::ranges::find(axes, input, &Axis::input);
    return found == axes.end() ? nullptr : &*found;
}

}  // namespace tiretherm::physics
