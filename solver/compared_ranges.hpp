// SPDX-License-Identifier: BSD-3-Clause
// Where a run is driven beyond the speeds, loads and other conditions at which the laws of its effects were compared with
// measurements, or are said to hold.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/problem.hpp"

namespace tiretherm::solver {

/// A law outside the range in which it was compared.
struct BeyondCompared {
    std::string_view effect;
    const physics::ComparedRange* range = nullptr;
    double highest = 0.0;  ///< in the range's unit, what the run goes up to: above its end, or below its start

    [[nodiscard]] bool is_above() const { return highest > range->high; }
    /// "compared up to 150 km/h, this test goes to 260"
    [[nodiscard]] std::string text() const;
};

/// All of them, by the highest value of each quantity over the run: what happens below it counts for less.
[[nodiscard]] std::vector<BeyondCompared> beyond_compared(const Problem& problem);

/// What several runs together are to be told of: the laws above their ranges, each by the run that goes furthest.
class Extrapolations {
public:
    void add(const Problem& problem);
    /// "strain energy loss compared up to 150 km/h, this test goes to 260; ..."; empty: there are none
    [[nodiscard]] std::string phrase() const;
    /// The same as a sentence of its own; none, or one.
    [[nodiscard]] std::vector<std::string> headline() const;
    /// A sentence for each: "strain_energy_loss was compared up to ...: beyond, its law is an extrapolation"
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    std::vector<BeyondCompared> laws_;
};

}  // namespace tiretherm::solver
