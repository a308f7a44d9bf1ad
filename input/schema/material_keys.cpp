// SPDX-License-Identifier: BSD-3-Clause
// Keys of [[material]] and the laws of temperature: form, unit and range, need and meaning, a line each.
#include <numbers>

#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// The 90 degrees of a circumferential cord may come a last digit above the right angle when degrees are converted.
constexpr double right_angle = std::numbers::pi / 2.0 + 1e-12;

// clang-format off
std::vector<TableKeys> material_tables() {
    return {
        {"material", TableForm::list,
         "A material. The heat capacity and the conductivities are laws of temperature. A law must be positive from the coldest to the hottest temperature that the case gives; if it would fail on the way up to 150 °C, there is a warning.", {
            name("name", "Name of the material.").required(),
            quantity("density", density, "Density. With `cord_rubber`: not given, or together with `heat_capacity`.").sometimes(),
            law("heat_capacity", heat_capacity, "Specific heat capacity, a law of temperature. With `cord_rubber`: not given, or together with `density`.").sometimes(),
            law("conductivity", conductivity, "Conductivity through the thickness, a law of temperature. With `cord_rubber`: not given.").sometimes(),
            quantity("conductivity_meridian", conductivity, "Conductivity along the meridian. Default: as through the thickness."),
            quantity("conductivity_circumference", conductivity, "Conductivity around the circumference. Default: as through the thickness."),
            subtable("cord_rubber", "Cords in rubber, from which the conductivities follow."),
        }},
        {"material.cord_rubber", TableForm::table,
         "Plies of parallel cords in rubber: a belt, a carcass. The conductivities follow from cords and rubber. V is the cords' share of the volume, `ends` times the cord's section over `thickness` (thesis (53)). Along the cords k1 = V kc + (1 - V) kr; across them and through the ply the rule of Halpin and Tsai with the shape factor 1, k2 = kr (kc + kr + (kc - kr) V) / (kc + kr - (kc - kr) V): within 5 % of a resolved row of steel cords up to 0.6 of their spacing and of the ply's thickness; of thicker ones in a row it may miss 20 %. With the cords at the angle psi to the circumference, k1 cos^2 psi + k2 sin^2 psi acts around the circumference, k1 sin^2 psi + k2 cos^2 psi along the meridian, k2 through. Neighbouring plies lie at +psi and -psi: in pairs the heat that each conducts obliquely cancels. An odd number of oblique plies is refused where a mesh resolves both directions (a ring, a block). `tiretherm check` prints the result.", {
            text("rubber", "Name of the `[[material]]` between the cords: its conductivity through the thickness, a law of temperature, its density and its heat capacity.").required(),
            quantity("cord_diameter", thickness, "Diameter of a cord, at most `thickness`.").required(),
            quantity("ends", {.unit = "m-1", .low = 0.0, .high = 1e6, .above = true}, "Cords per length across them, in one ply; `cord_diameter` times `ends` is at most 1.").required(),
            quantity("thickness", thickness, "Thickness of one ply, with the rubber above and below its cords.").required(),
            // A right angle converted from degrees may end one digit beyond pi/2.
            quantity("angle", {.unit = "radian", .low = -right_angle, .high = right_angle}, "Of the cords to the circumference: 0 around the tire, 90 degrees along the meridian (a radial carcass).").required(),
            count("plies", 1, 100, "Plies in the layer, at +angle and -angle in turn. Default: 2."),
            quantity("cord_conductivity", conductivity, "Conductivity along a cord.").required(),
            quantity("cord_conductivity_across", conductivity, "Conductivity across a cord. Default: as along it."),
            quantity("cord_density", density, "Density of a cord. The density is then V times it and 1 - V times the rubber's.").sometimes(),
            quantity("cord_heat_capacity", heat_capacity, "Specific heat capacity of a cord. The heat capacity is then that of cords and rubber together.").sometimes(),
            quantity("cord_modulus", {.unit = "Pa", .low = 0.0, .high = 1e13, .above = true}, "Young's modulus of a cord. The four moduli and ratios are given together; `check` prints what follows from them for a ply and for all plies of the layer (thesis (54)-(56)); the belt's modulus follows them where `belt_material` of `[tire.modulus]` names this material.").sometimes(),
            quantity("cord_poisson", {.unit = "1", .low = 0.0, .high = 0.5}, "Poisson's ratio of a cord.").sometimes(),
            quantity("rubber_modulus", {.unit = "Pa", .low = 0.0, .high = 1e13, .above = true}, "Young's modulus of the rubber.").sometimes(),
            quantity("rubber_poisson", {.unit = "1", .low = 0.0, .high = 0.5}, "Poisson's ratio of the rubber.").sometimes(),
        }},
        {"law", TableForm::table,
         "A law of temperature: a constant (`\"0.25 W/mK\"`), a parabola about a point (`at`, `value`, `slope`, `curvature`), a parabola through two or three points (`through = [[\"20 degC\", \"0.29 W/mK\"], [\"90 degC\", \"0.95 W/mK\"]]`), or a table (`columns`, `rows`), straight between the rows.", {
            quantity("at", temperature, "Temperature of the point.").sometimes(),
            quantity_of_owner("value", "Value at the point.").required(),
            quantity_of_owner("slope", "Slope at the point. Default: 0."),
            quantity_of_owner("curvature", "Coefficient of the square of the difference. Default: 0."),
            value("range", "Two temperatures between which the parabola holds, `range = [\"20 degC\", \"120 degC\"]`; beyond them it keeps its end values. Default: no range."),
            value("through", "Two or three pairs of temperature and value."),
            texts("columns", "Headings with units: temperature and value.").required(),
            value("rows", "Rows of the table; temperatures ascending.").required(),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
