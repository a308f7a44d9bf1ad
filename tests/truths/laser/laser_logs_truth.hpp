// SPDX-License-Identifier: BSD-3-Clause
// The made-up logs of the laser bench that come with the cases.
#pragma once

#include <vector>

#include "laser/laser_bench_truth.hpp"
#include "numerics/table_truth.hpp"
#include "two_node/shipped_truth.hpp"

namespace hidden_effects {

/// Standard deviations of the sensors' noise, in the order of laser_channels. K
inline constexpr std::array<double, laser_channels.size()> laser_noise{0.5, 0.5, 0.3};

/// A run of the laser's bench: what was logged of its inputs and what its sensors gave.
[[nodiscard]] std::vector<Column> laser_columns(const LaserProgramme& programme, const LaserBenchTrace& trace);

/// What the user of the bench does not know, of the runs that come with it.
[[nodiscard]] LaserBench shipped_laser_bench();
/// The bench of a laser, cases/practice: three runs with nothing hidden.
[[nodiscard]] std::vector<ShippedLog> laser_bench_logs();

}  // namespace hidden_effects
