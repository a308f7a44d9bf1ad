// SPDX-License-Identifier: BSD-3-Clause
// The made-up logs that come with the cases of the two-node bench and of the laser's specimen.
#pragma once

#include <string>
#include <vector>

#include "laser/laser_truth.hpp"
#include "numerics/table_truth.hpp"

namespace hidden_effects {

/// A made-up log that the cases come with.
struct ShippedLog {
    std::string file;  ///< below cases/
    std::vector<Column> columns;
};

/// The bench of two nodes, cases/practice: three runs with nothing hidden, and three with something.
[[nodiscard]] std::vector<ShippedLog> bench_logs();
/// The laser's specimen at three powers, cases/laser.
[[nodiscard]] std::vector<ShippedLog> laser_logs();
/// The specimen behind them, at a power of 1 W, starting at the air's temperature.
[[nodiscard]] LaserSpecimen shipped_specimen();

}  // namespace hidden_effects
