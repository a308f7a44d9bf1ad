// SPDX-License-Identifier: BSD-3-Clause
// The units in which users see channels.
#pragma once

#include <cstdint>

namespace tiretherm::solver {

enum class Quantity : std::uint8_t;

/// How users see a channel's values.
struct ShownUnit {
    const char* name;
    double factor = 1.0;
    double zero = 0.0;  ///< SI value that is shown as 0

    [[nodiscard]] constexpr double value(double si) const { return factor * (si - zero); }
    /// Of a difference of two values.
    [[nodiscard]] constexpr double difference(double si) const { return factor * si; }
};

[[nodiscard]] ShownUnit shown_unit(Quantity quantity);

}  // namespace tiretherm::solver
