// SPDX-License-Identifier: BSD-3-Clause
// What a [[sensor]] may be, for the reader and for `tiretherm help sensors`.
#pragma once

#include <string_view>
#include <vector>

namespace tiretherm::input {

struct SensorKind {
    std::string_view name;     ///< its key `kind`
    std::string_view meaning;  ///< of what it measures
    bool is_place = false;     ///< the temperature of a place; otherwise another quantity
};

/// All of them, places first.
[[nodiscard]] std::vector<SensorKind> sensor_kinds();

}  // namespace tiretherm::input
