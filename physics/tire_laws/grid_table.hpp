// SPDX-License-Identifier: BSD-3-Clause
// A quantity measured over a full grid of inputs and the bulk's temperature: multilinear between its points.
#pragma once

#include <vector>

#include "physics/signals.hpp"

namespace tiretherm::physics {

/// Measured over a full grid of what was varied; between its points every variable is interpolated straight (multilinear),
/// beyond its ends held.
struct GridTable {
    /// One variable of the grid.
    struct Axis {
        double Inputs::*input = nullptr;  ///< null: the bulk's mean temperature, K
        std::vector<double> at;           ///< SI, ascending

        friend bool operator==(const Axis&, const Axis&) = default;
    };
    std::vector<Axis> axes;
    std::vector<double> values;  ///< SI, the last axis fastest

    /// @param bulk K, looked at only where the bulk's temperature is an axis
    [[nodiscard]] double value(const Inputs& inputs, double bulk) const;
    /// The axis of an input, or of the bulk's temperature for null; null where it was not varied.
    [[nodiscard]] const Axis* find(double Inputs::*input) const;

    friend bool operator==(const GridTable&, const GridTable&) = default;
};

}  // namespace tiretherm::physics
