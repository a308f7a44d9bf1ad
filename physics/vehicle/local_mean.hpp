// SPDX-License-Identifier: BSD-3-Clause
// Smoothing of a logged signal without a delay, and its slope: means over windows that lie evenly about each sample.
#pragma once

#include <vector>

namespace tiretherm::physics {

/// Mean under a triangle of this base about each sample: the local mean over half of it, taken twice, of the straight
/// lines between the samples. It has no phase, never overshoots, keeps straight lines and, but for the ends, the
/// integral. What oscillates with a period of half the window is gone; a period of five windows keeps 97 %. Towards the
/// ends the window shrinks so that it stays even.
/// @param time [n] s, ascending  @param value [n]  @param window s, >= 0; 0: as it is  @returns [n]
[[nodiscard]] std::vector<double> local_mean(const std::vector<double>& time, std::vector<double> value, double window);

/// Slope of the straight lines between the samples over this window about each of them, or between its neighbours where
/// these are further apart. @returns [n] per second
[[nodiscard]] std::vector<double> local_slope(const std::vector<double>& time, const std::vector<double>& value,
                                              double window);

}  // namespace tiretherm::physics
