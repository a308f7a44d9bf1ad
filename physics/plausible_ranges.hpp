// SPDX-License-Identifier: BSD-3-Clause
// Look-ups in the ranges in which the parameters of effects are expected.
#pragma once

#include <cstddef>
#include <string_view>

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// The range of a parameter of an effect for this kind of sensor; where there is none for the kind, the one for any.
/// @returns null where none is known
[[nodiscard]] const PlausibleRange* plausible_range(const Effect& effect, std::size_t parameter,
                                                    SensorKind sensor = SensorKind::any);
/// The range of a material law: "conductivity" [W/(m K)], "heat_capacity" [J/(kg K)], or "link_conductivity" [W/(m K)] of
/// links between lumps. @returns null for other words
[[nodiscard]] const PlausibleRange* plausible_range_of_law(std::string_view law);

/// Whether the range holds the value. @param value in the parameter's unit
[[nodiscard]] constexpr bool is_plausible(const PlausibleRange& range, double value) {
    return range.low <= value && value <= range.high;
}
/// Whether a value of a parameter is plausible; true where no range is known.
[[nodiscard]] bool is_plausible(const Effect& effect, std::size_t parameter, double value,
                                SensorKind sensor = SensorKind::any);

/// "infrared sensor", "probe in rubber", "sensor in the gas"; empty for any.
[[nodiscard]] std::string_view name_of(SensorKind sensor);

}  // namespace tiretherm::physics
