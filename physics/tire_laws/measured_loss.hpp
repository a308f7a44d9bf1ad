// SPDX-License-Identifier: BSD-3-Clause
// Strain-energy loss from a measured rolling resistance, P = F |V|: a table of a drum test or coast-down coefficients
// (SAE J2452).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/tire_laws/grid_table.hpp"
#include "physics/tire_laws/rolling_resistance.hpp"

namespace tiretherm::physics {

/// Coast-down coefficients with the units in which they were fitted, in SI.                              SAE J2452
struct CoastdownFit {
    CoastdownLaw law;
    double pressure_unit = 1e3;     ///< Pa
    double load_unit = 1.0;         ///< N
    double speed_unit = 1.0 / 3.6;  ///< m/s
    double force_unit = 1.0;        ///< N
};

/// Temperatures of the bulk for which one table may hold a column.
inline constexpr int most_temperatures = 32;

/// The total of the strain-energy loss as a machine measured it: P = F |V|, none without contact.
struct MeasuredLoss {
    std::optional<CoastdownFit> coastdown{};  ///< otherwise the table
    GridTable table{};                        ///< of the force on a drum, N
    std::vector<double> bulk_temperatures{};  ///< K, the table's axis of that name; empty where it has none

    /// @param bulk K  @returns W >= 0
    [[nodiscard]] double power(const Inputs& inputs, double bulk) const;
};

}  // namespace tiretherm::physics
