// SPDX-License-Identifier: BSD-3-Clause
// Stretches in which a channel of a logger says nothing: the value of a reset, of a broken wire, of a receiver that has lost its
// satellites.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "input/measurements/data_warnings.hpp"

namespace tiretherm::input {

/// Whether something happens between two times, s, that may make a signal jump.
using Happens = std::function<bool(double from, double to)>;
[[nodiscard]] inline bool nothing_happens(double, double) { return false; }

/// Stretches of a temperature or a speed that stand still and are reached or left by a jump that nothing measured makes: in one
/// sample, without an aftermath, and in the middle of a record back to where it was. A record that jumps all the time, or
/// stands still beside the jump as well, has none: it may be a schedule; but a temperature that stands for 100 samples or more is
/// the air's. Of a speed there are none at the ends, nor any longer than 30 s.
/// @param time [n] s, ascending  @param value [n] SI, finite  @param si "K" or "m s-1"; of other units there are none
/// @param happens between the two samples of a jump: then the signal may have made it
[[nodiscard]] std::vector<Stretch> dead_stretches(const std::vector<double>& time, const std::vector<double>& value,
                                                  std::string_view si, const Happens& happens = nothing_happens);

/// What is to be said of them, without the name of the column: "stands at -1 degC from 0 s to 4.9 s ...". @param dead at least one
[[nodiscard]] std::string sentence_of_dead(const std::vector<Stretch>& dead, const std::vector<double>& time,
                                           const std::vector<double>& value, std::string_view si);

/// Makes the samples missing (NaN) that dead_stretches finds among those with a value. @returns the sentence; empty: none
std::string remove_dead(const std::vector<double>& time, std::vector<double>& value, std::string_view si,
                        const Happens& happens = nothing_happens);

}  // namespace tiretherm::input
