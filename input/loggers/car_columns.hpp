// SPDX-License-Identifier: BSD-3-Clause
// What a column of a car's log is by the words of its heading: how the car moves, its surroundings, or a tire's reading.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "input/tables/columns.hpp"

namespace tiretherm::input {

/// A thing that a column may be.
struct CarColumn {
    std::string name;             ///< an input, a signal of [vehicle] or a sensor
    std::string corner;           ///< FL, FR, RL, RR; empty: of the whole car
    int rank = 0;                 ///< the lower, the surer: of two columns for one thing that one is taken
    std::optional<int> place{};   ///< number of a reading in an array across the tread
    std::string_view question{};  ///< what the heading leaves open, so that the user must say; empty: nothing
};

/// What loggers mean by a name such as "G Force Lat", "GPS Speed" or "TyreTemp_FL2 inner", in English.
/// @param heading without its unit  @returns the likeliest first; empty: nothing that a tire's temperature follows from
[[nodiscard]] std::vector<CarColumn> car_columns(std::string_view heading);
/// The same, where the unit may say what the name leaves out: "Tyre FL [degC]", "Ambient [degF]", "Tyre RR [psi]".
[[nodiscard]] std::vector<CarColumn> car_columns(const Heading& heading);

/// The corner that a heading names as FL, LF, "front left" ...; empty: none.
[[nodiscard]] std::string corner_of(std::string_view heading);

/// Whether it is a signal that says how the car moves, speed aside.
[[nodiscard]] bool is_motion(std::string_view name);
/// Whether a heading has the letter of an axis, as that of an acceleration: AccX, "Accel Y".
[[nodiscard]] bool names_an_axis(std::string_view heading);

}  // namespace tiretherm::input
