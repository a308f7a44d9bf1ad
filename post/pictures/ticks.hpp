// SPDX-License-Identifier: BSD-3-Clause
// Round values for axes and isotherms: multiples of 1, 2, 2.5 or 5 times a power of ten.
#pragma once

#include <string>
#include <vector>

namespace tiretherm::post {

/// Round values for an axis or for isotherms: multiples of 1, 2, 2.5 or 5 times a power of ten.
struct Ticks {
    std::vector<double> values;
    int decimals = 0;

    [[nodiscard]] std::string label(double value) const;
};

/// @param low, high ends of the axis, both kept  @param about how many are wanted
[[nodiscard]] Ticks ticks(double low, double high, int about);

}  // namespace tiretherm::post
