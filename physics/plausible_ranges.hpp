// SPDX-License-Identifier: BSD-3-Clause
// Ranges in which a tire engineer expects the parameters of the catalogue, each with its source: narrower than what a
// case may say, and wide enough for any car tire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "physics/effect.hpp"

namespace tiretherm::physics {

/// What a sensor is, as far as a range depends on it.
enum class SensorKind : std::uint8_t {
    any,       ///< not known, or it makes no difference
    infrared,  ///< sees a surface from a distance
    probe,     ///< sits in the rubber
    gas        ///< sits in the gas of the cavity
};

/// Where a parameter is expected to lie. `source` is a measured range, a paper, a data sheet, "definition", or "recalled"
/// where it is engineering knowledge that was not looked up.
struct PlausibleRange {
    std::string_view effect;
    std::string_view parameter;  ///< "*": any of the effect's that has no range of its own
    double low;                  ///< in the unit of the parameter's ParameterSpec
    double high;
    std::string_view source;
    std::string_view why;  ///< what a value beyond it would mean
    SensorKind sensor = SensorKind::any;
};

/// All of them, in the order of the file plausible_ranges.list. Those of "conduction" are of material laws:
/// "conductivity" [W/(m K)], "heat_capacity" [J/(kg K)], and "link_conductivity" [W/(m K)] of links between lumps.
[[nodiscard]] std::span<const PlausibleRange> plausible_ranges();

/// The range of a parameter of an effect, whatever sensor it belongs to. @returns null where none is known
[[nodiscard]] const PlausibleRange* plausible_range(const Effect& effect, std::size_t parameter);
/// The range for this kind of sensor; where there is none for the kind, the one for any. @returns null where none is known
[[nodiscard]] const PlausibleRange* plausible_range(const Effect& effect, std::size_t parameter, SensorKind sensor);
/// The range of a material law: "conductivity", "heat_capacity" or "link_conductivity". @returns null for other words
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
