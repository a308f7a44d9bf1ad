// SPDX-License-Identifier: BSD-3-Clause
// Channels of a car's log to which no sensor is connected.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/tables/data_file.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

/// A signal that says nothing, and why: "stands at 0 in all its samples while the car moves".
struct DeadChannel {
    std::string_view name;
    std::string why;
};

/// Signals that are constant while the car's speed changes, or move by no more than the noise of a converter while others say
/// that the car turns, speeds up or brakes. A constant brake pressure is dead where the car slows by more than coasting does.
/// A log of a car that stands has none.
[[nodiscard]] std::vector<DeadChannel> dead_channels(const VehicleLog& log);

/// Stretches of accelerations and of the yaw rate that stand at one value for 3 s or more while another signal says that the car
/// turns, speeds up or brakes: a sentence for each signal that lives otherwise, with the longest.
[[nodiscard]] std::vector<DeadChannel> dead_for_a_while(const VehicleLog& log);

/// Whether a signal moves by no more than the noise of a converter, whatever the others say: another column of the same thing
/// is to be preferred.
[[nodiscard]] bool moves_like_noise(std::string_view name, const solver::SignalHistory& signal);

/// Another column of the same file that is called like a signal of a car and moves, where the one that is used does not.
/// @param used its index  @param column what it says  @param time [n] s, of all rows  @param errors of the file so far, to which
/// nothing is added  @returns its heading without the unit; empty: none
[[nodiscard]] std::string live_column_beside(const DataFile& file, int used, const UserColumn& column,
                                             const std::vector<double>& time, const InputErrors& errors);

}  // namespace tiretherm::input
