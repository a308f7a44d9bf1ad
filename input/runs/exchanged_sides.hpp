// SPDX-License-Identifier: BSD-3-Clause
// Whether left and right of a car are exchanged: by a wrong sign of its turns, or by the columns of its sensors.
#pragma once

#include <span>
#include <string>

#include "input/measurements/experiment.hpp"

namespace tiretherm::input {

/// What is known of the car's turns beside its tires.
struct TurnsKnown {
    bool by_vehicle = false;     ///< [vehicle] tells the loads, by signs of its log
    double course_agrees = 0.0;  ///< correlation with the turns over ground; 0: not known
};

/// Compares the measured temperature of each left tire less that of the right one with what loads, slips and forces do to the two,
/// remembered over the time that fits best. Where they go against each other beyond chance, left and right are exchanged.
/// @param corners runs of one recording, each of one corner  @returns a sentence; empty: nothing speaks for it
[[nodiscard]] std::string find_exchanged_sides(std::span<const MeasuredRun> corners, const TurnsKnown& turns);

}  // namespace tiretherm::input
