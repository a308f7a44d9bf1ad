// SPDX-License-Identifier: BSD-3-Clause
// Keys of [tire]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> tire_tables() {
    return {
        {"tire", TableForm::table,
         "The tire. With this table the thesis's effects are on. Laws of the load are straight lines or powers, or measured tables `{ columns = [\"load [kN]\", \"length [mm]\"], rows = [[2, 60], [4, 97]] }`, straight between the rows and held beyond them. Their defaults are those of the thesis's 225/50 R17, with a warning for another size.", {
            text("size", "For example `225/50 R17`: gives width, section height and, unless given, the unloaded radius.").required(),
            quantity("width", {.unit = "m", .low = 0.005, .high = 3.0, .usual_low = 0.05, .usual_high = 1.0}, "Default: of the size."),
            quantity("section_height", {.unit = "m", .low = 0.005, .high = 3.0, .usual_low = 0.05, .usual_high = 1.0}, "Default: of the size."),
            quantity("unloaded_radius", {.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0}, "Default: half the rim's diameter and the section height."),
            quantity("tread_thickness", thickness, "Thickness of the crown. Default: 12 mm."),
            quantity("sidewall_thickness", thickness, "Default: 9 mm."),
            quantity("density", density, "Default: 1100 kg/m3; for `two_node` that of the material."),
            quantity("minimum_load", load, "Load below which the tire counts as not touching the road. Default: 1 N."),
            quantity("contact_length_limit", length, "Contact length at a load without end, of the law of the load."),
            quantity("contact_length_slope", {.unit = "kN-1", .low = 0.0, .high = 100.0, .above = true}, "How fast the contact length approaches its limit."),
            quantity("contact_area_at_zero", {.unit = "m2", .low = 0.0, .high = 1.0}, "Contact area at no load."),
            quantity("contact_area_slope", {.unit = "m2 N-1", .low = 0.0, .high = 0.001}, "Contact area for each newton of load."),
            quantity("loaded_radius_at_zero", {.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0}, "Default: the unloaded radius."),
            quantity("loaded_radius_slope", {.unit = "m N-1", .low = -0.001, .high = 0.0}, "Change of the loaded radius with the load."),
            quantity("rolling_radius_factor", {.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0}, "Factor of the power law of the rolling radius."),
            quantity("rolling_radius_exponent", {.unit = "1", .low = -1.0, .high = 1.0}, "Exponent of the power law of the rolling radius."),
            quantity("reference_pressure", {.unit = "Pa", .low = 1e4, .high = 2e6, .above = true}, "Inflation pressure above the atmosphere at which the laws of the load hold. Where `drive` gives `inflation_pressure`, contact and radii are those of the load times the ratio of the vertical stiffnesses at the two pressures (Rhyne, Tire Sci. Technol. 33(3), 2005). Default: 220 kPa."),
            quantity("pressure_exponent_of_loss", {.unit = "1", .low = 0.0, .high = 3.0}, "The strain-energy loss falls with this power of the inflation pressure over the reference (SAE J2452: 0.4 to 0.5). Default: 0.45."),
            subtable("contact_length", "Measured contact length against load, in place of the law."),
            subtable("contact_area", "Measured contact area against load, in place of the law."),
            subtable("loaded_radius", "Measured loaded radius against load, in place of the law."),
            subtable("rolling_radius", "Measured rolling radius against load, in place of the law."),
            subtable("modulus", "The moduli behind the cornering stiffness."),
            text("property_file", "A `.tir` file beside the case with coefficients of the Magic Formula (MF 5.2, 6.1). Default: none."),
        }},
        {"tire.modulus", TableForm::table,
         "The moduli behind the cornering stiffness, thesis (52), (69) to (71). The defaults are assumed for the thesis's tire; `physics/tire_laws/cornering_stiffness.hpp` says on what grounds.", {
            quantity("belt_maximum", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "Largest modulus of the belt."),
            quantity("belt_fall", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "How much of it a long contact takes away."),
            quantity("belt_slope", {.unit = "m-1", .low = -1e4, .high = 1e4}, "How fast it falls with the contact length."),
            quantity("belt_threshold", length, "Contact length at which half of the fall is reached."),
            quantity("tread_middle", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "Modulus of the tread at the transition temperature."),
            quantity("tread_fall", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "How much the modulus of the tread falls through the transition."),
            quantity("transition_temperature", temperature, "Temperature of the transition."),
            quantity("transition_width", {.unit = "K", .scale = Scale::difference, .low = 0.0, .high = 1e4, .above = true}, "Width of the transition."),
            quantity("lambda_CP", {.unit = "1", .low = 0.0, .high = 10.0}, "Scale of the cornering stiffness."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
