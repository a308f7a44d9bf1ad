// SPDX-License-Identifier: BSD-3-Clause
// Where a run is driven beyond the speeds and loads at which the laws of its effects were compared with measurements.
#pragma once

#include <string>
#include <vector>

#include "solver/problem.hpp"

namespace tiretherm::solver {

/// A law outside the inputs at which it was compared.
struct BeyondCompared {
    std::string_view effect;
    const physics::Signal* signal = nullptr;
    double low = 0.0;      ///< SI, compared from
    double high = 0.0;     ///< SI, compared up to
    double highest = 0.0;  ///< SI, what the run goes up to: above `high`, or below `low`

    /// "compared up to 150 km/h, this test goes to 260"
    [[nodiscard]] std::string text() const;
};

/// All of them, by the highest value of each input over the run: what happens below it counts for less.
[[nodiscard]] std::vector<BeyondCompared> beyond_compared(const Problem& problem);

}  // namespace tiretherm::solver
