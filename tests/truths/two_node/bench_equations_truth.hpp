// SPDX-License-Identifier: BSD-3-Clause
// Right-hand side of the two-node bench and its sensors, independent of the program.
#pragma once

#include <array>
#include <vector>

#include "two_node/causes_truth.hpp"
#include "two_node/two_node_truth.hpp"

namespace hidden_effects {

enum BenchNode : std::size_t { surface, bulk, gas, pressure_gas, surface_sensor, bulk_sensor, n_bench_states };
using BenchState = std::array<double, n_bench_states>;  ///< K

/// The right-hand side of the bench, and what its sensors show. Bench and programme must outlive it.
class BenchEquations {
public:
    BenchEquations(const Bench& bench, const Programme& programme)
        : bench_(bench), programme_(programme), causes_(gather(bench.causes)) {}

    [[nodiscard]] BenchState start() const;
    /// dy/dt between sample i and the next. K/s
    [[nodiscard]] BenchState rate(std::size_t i, double t, const BenchState& y) const;
    /// When an input passes a switch between sample i and the next, with the end of the interval as the last. s
    [[nodiscard]] std::vector<double> stops(std::size_t i) const;
    /// What the sensors show at sample i. K
    [[nodiscard]] double surface_reading(std::size_t i, const BenchState& y) const;
    [[nodiscard]] double bulk_reading(const BenchState& y) const;

private:
    const Bench& bench_;
    const Programme& programme_;
    Causes causes_;
};

}  // namespace hidden_effects
