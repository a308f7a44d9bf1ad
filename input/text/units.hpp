// SPDX-License-Identifier: BSD-3-Clause
// Conversion of units with UDUNITS; distinguishes temperatures from temperature differences.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tiretherm::input {

/// What a number in degrees Celsius means.
enum class Scale : std::uint8_t {
    absolute,    ///< a temperature: 25 degC is 298.15 K
    difference,  ///< a difference of temperatures: 0.5 degC is 0.5 K
};

/// From a unit to the unit wanted: si = factor * written + offset.
struct Conversion {
    double factor = 1.0;
    double offset = 0.0;

    [[nodiscard]] double to_si(double written) const { return factor * written + offset; }
    [[nodiscard]] double from_si(double si) const { return (si - offset) / factor; }
};

/// Before the unit of a column whose numbers have the other sign: `-1 N`.
inline constexpr std::string_view turned_sign = "-1 ";

enum class UnitError : std::uint8_t { unknown, number_inside, other_dimension };

/// How to turn numbers of one unit into another. UDUNITS after the aliases below; units of angle are not pure numbers,
/// and reciprocal units (s and Hz) are not converted into each other.
/// Aliases of a whole unit: `deg` = degree, also in `deg/s`, `G` = standard gravity, `-` and empty = 1, `kph` = km/h, `mph` =
/// mile/h; after a power or an energy and a slash `mK`, `m2K`, `m3K`, `kgK` are products (W/mK, W/m2K, J/kgK); `mK` by
/// itself stays a millikelvin.
/// @param wanted SI unit with kelvin
/// @errors std::runtime_error when the units' data base cannot be read
[[nodiscard]] std::variant<Conversion, UnitError> conversion(std::string_view written, std::string_view wanted,
                                                             Scale scale);

/// The product of base units that tells the dimension: "m.s-1", "1", "rad". Empty for what is not a unit.
[[nodiscard]] std::string signature(std::string_view unit);

/// A dimension in words.
struct Dimension {
    std::string name;     ///< with article: "a length"
    std::string example;  ///< as a user writes it: "8 mm"; empty for a dimension without a name here
    std::string units{};  ///< usual ones, a blank apart: "mm cm m"
};
/// @param unit one that `signature` knows
[[nodiscard]] Dimension dimension(std::string_view unit, Scale scale);
/// All that have a name here.
[[nodiscard]] std::vector<Dimension> dimensions();

}  // namespace tiretherm::input
