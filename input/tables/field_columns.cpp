// SPDX-License-Identifier: BSD-3-Clause
// Names, units and ranges of the columns: coordinates, area, pressure, sliding velocity, shear stress, friction power,
// loss density.

#include "input/tables/field_columns.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr std::array columns{
    FieldColumn{"time", {.unit = "s", .low = -1e10, .high = 1e10}, "s", Purpose::frame},
    FieldColumn{"wheel_angle", {.unit = "rad", .low = -1e3, .high = 1e3}, "deg", Purpose::frame},
    FieldColumn{"x", {.unit = "m", .low = -10.0, .high = 10.0}, "mm"},
    FieldColumn{"y", {.unit = "m", .low = -10.0, .high = 10.0}, "mm"},
    FieldColumn{"depth", {.unit = "m", .low = 0.0, .high = 10.0}, "mm"},
    FieldColumn{"cell", {.unit = "1", .low = 0.0, .high = 1e9}, "1"},
    FieldColumn{"area", {.unit = "m2", .low = 0.0, .high = 1e3, .above = true}, "mm2"},
    FieldColumn{"volume", {.unit = "m3", .low = 0.0, .high = 1e3, .above = true}, "mm3"},
    FieldColumn{"pressure", {.unit = "Pa", .low = 0.0, .high = 1e9}, "kPa"},
    FieldColumn{"sliding_velocity", {.unit = "m s-1", .low = -1e3, .high = 1e3}, "m/s"},
    FieldColumn{"shear_stress", {.unit = "Pa", .low = -1e9, .high = 1e9}, "kPa"},
    FieldColumn{"friction_power", {.unit = "W m-2", .low = 0.0, .high = 1e12}, "W/m2"},
    FieldColumn{"loss_density", {.unit = "W m-3", .low = 0.0, .high = 1e12}, "W/m3"},
};

}  // namespace

std::span<const FieldColumn> field_columns() { return columns; }

const FieldColumn& field_column(std::string_view name) { return *std::ranges::find(columns, name, &FieldColumn::name); }

std::string unit_remedy(const FieldColumn& column, bool in_text) {
    return in_text ? fmt::format("write \"{} [{}]\"", column.name, column.usual_unit)
                   : fmt::format("give the dataset an attribute units = \"{}\"", column.usual_unit);
}

}  // namespace tiretherm::input
