// SPDX-License-Identifier: BSD-3-Clause
// Whether left and right of a car are exchanged: by a wrong sign of its turns, or by the columns of its sensors.
#pragma once

#include <span>
#include <string>

#include "input/measurements/experiment.hpp"

namespace tiretherm::input {

/// Compares the measured temperature of each left tire less that of the right one with what loads, slips and forces do to the two,
/// remembered over the time that fits best. Where they go against each other beyond chance, left and right are exchanged.
/// @param corners runs of one recording, each of one corner  @param by_vehicle [vehicle] tells the loads, by signs of its log
/// @returns a sentence; empty: nothing speaks for it
[[nodiscard]] std::string find_exchanged_sides(std::span<const MeasuredRun> corners, bool by_vehicle);

}  // namespace tiretherm::input
