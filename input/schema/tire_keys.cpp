// SPDX-License-Identifier: BSD-3-Clause
// Keys of [tire]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> tire_tables() {
    return {
        {"tire", TableForm::table,
         "The tire. With this table the thesis's effects are on. Laws of the load are straight lines or powers, or measured tables `{ columns = [\"load [kN]\", \"length [mm]\"], rows = [[2, 60], [4, 97]] }`, straight between the rows and held beyond them. Their defaults are those of the thesis's 225/50 R17, with a warning for another size.", {
            text("size", "For example `225/50 R17`: gives width, section height and, unless given, the unloaded radius.").required(),
            quantity("width", {.unit = "m", .low = 0.005, .high = 3.0, .usual_low = 0.05, .usual_high = 1.0}, "Default: of the size.").into<&physics::Tire::width>(),
            quantity("section_height", {.unit = "m", .low = 0.005, .high = 3.0, .usual_low = 0.05, .usual_high = 1.0}, "Default: of the size.").into<&physics::Tire::section_height>(),
            quantity("unloaded_radius", {.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0}, "Default: half the rim's diameter and the section height.").into<&physics::Tire::unloaded_radius>(),
            quantity("tread_thickness", thickness, "Thickness of the crown. Default: 12 mm.").into<&physics::Tire::tread_thickness>(),
            quantity("sidewall_thickness", thickness, "Default: 9 mm.").into<&physics::Tire::sidewall_thickness>(),
            quantity("density", density, "Default: 1100 kg/m3; for `two_node` that of the material.").into<&physics::Tire::density>(),
            quantity("minimum_load", load, "Load below which the tire counts as not touching the road. Default: 1 N.").into<&physics::Tire::minimum_load>(),
            quantity("contact_length_limit", length, "Contact length at a load without end, of the law of the load.").into<&physics::Tire::contact_length_limit>(),
            quantity("contact_length_slope", {.unit = "kN-1", .low = 0.0, .high = 100.0, .above = true}, "How fast the contact length approaches its limit.").into<&physics::Tire::contact_length_slope>(),
            quantity("contact_area_at_zero", {.unit = "m2", .low = 0.0, .high = 1.0}, "Contact area at no load.").into<&physics::Tire::contact_area_at_zero>(),
            quantity("contact_area_slope", {.unit = "m2 N-1", .low = 0.0, .high = 0.001}, "Contact area for each newton of load.").into<&physics::Tire::contact_area_slope>(),
            quantity("loaded_radius_at_zero", {.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0}, "Default: the unloaded radius.").into<&physics::Tire::loaded_radius_at_zero>(),
            quantity("loaded_radius_slope", {.unit = "m N-1", .low = -0.001, .high = 0.0}, "Change of the loaded radius with the load.").into<&physics::Tire::loaded_radius_slope>(),
            quantity("rolling_radius_factor", {.unit = "m", .low = 0.01, .high = 5.0, .usual_low = 0.1, .usual_high = 2.0}, "Factor of the power law of the rolling radius.").into<&physics::Tire::rolling_radius_factor>(),
            quantity("rolling_radius_exponent", {.unit = "1", .low = -1.0, .high = 1.0}, "Exponent of the power law of the rolling radius.").into<&physics::Tire::rolling_radius_exponent>(),
            quantity("reference_pressure", {.unit = "Pa", .low = 1e4, .high = 2e6, .above = true}, "Inflation pressure above the atmosphere at which the laws of the load hold. Where `drive` gives `inflation_pressure`, contact and radii are those of the load times the ratio of the vertical stiffnesses at the two pressures (Rhyne, Tire Sci. Technol. 33(3), 2005). Default: 220 kPa."),
            quantity("pressure_exponent_of_loss", {.unit = "1", .low = 0.0, .high = 3.0}, "The strain-energy loss falls with this power of the inflation pressure over the reference (SAE J2452: 0.4 to 0.5). Default: 0.45.").into<&physics::Tire::pressure_exponent_of_loss>(),
            quantity("loss_drum_diameter", {.unit = "m", .low = 0.1, .high = 100.0, .usual_low = 1.0, .usual_high = 3.5}, "Diameter of the drum on which the strain-energy loss, by its law or its `total`, was measured. The effect `drum_curvature` counts from there; without it the tire rolls on that drum. Default: measured on a flat road.").into<&physics::Tire::loss_drum_diameter>(),
            subtable("contact_length", "Measured contact length against load, in place of the law."),
            subtable("contact_area", "Measured contact area against load, in place of the law."),
            subtable("loaded_radius", "Measured loaded radius against load, in place of the law."),
            subtable("rolling_radius", "Measured rolling radius against load, in place of the law."),
            value("cornering_stiffness", "Measured cornering stiffness against load and temperature of the bulk, in the place of the moduli and of that of `property_file`: a file (CSV, HDF5) or a table `{ columns = [\"vertical_load [kN]\", \"bulk_temperature [degC]\", \"cornering_stiffness [kN/rad]\"], rows = [[2, 40, 69], ...] }` with one row for each combination of loads and temperatures; `inflation_pressure` may be a column, too. Straight between the rows, held beyond them. Default: the moduli."),
            subtable("modulus", "The moduli behind the cornering stiffness."),
            subtable("lateral_peak", "Peak of the lateral force, where there is no `property_file`."),
            subtable("grip", "How friction follows the temperature of the surface."),
            subtable("measured", "What was measured of this tire, to stand beside its laws."),
            text("property_file", "A `.tir` file beside the case with coefficients of the Magic Formula (MF 5.2, 6.1). Of TYRESIDE = 'LEFT' the mirror image counts, as inputs are those of a tire on the right. Terms of the pressure (MF 6.1) follow `inflation_pressure` of `drive`, without it INFLPRES. Default: none."),
        }},
        {"tire.modulus", TableForm::table,
         "The moduli behind the cornering stiffness, thesis (52), (69) to (71). Beside a `property_file` they say how its stiffness changes from `reference_temperature` on, in the ratio CP(load, bulk) / CP(load, reference_temperature). The defaults are assumed for the thesis's tire; `physics/tire_laws/cornering_stiffness.hpp` says on what grounds.", {
            quantity("belt_maximum", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "Largest modulus of the belt.").into<&physics::EquivalentModulus::E_max>(),
            text("belt_material", "A `[[material]]` of cords in rubber, whose modulus around the circumference (thesis (53) to (56), E_x of all its plies glued together) is the largest modulus of the belt, in the place of `belt_maximum`. `tiretherm check` prints it. Default: none."),
            quantity("belt_fall", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "How much of it a long contact takes away. Default: 310 MPa; with `belt_material` the same share of it, 31/33.").into<&physics::EquivalentModulus::dE>(),
            quantity("belt_slope", {.unit = "m-1", .low = -1e4, .high = 1e4}, "How fast it falls with the contact length.").into<&physics::EquivalentModulus::slope>(),
            quantity("belt_threshold", length, "Contact length at which half of the fall is reached.").into<&physics::EquivalentModulus::l_t>(),
            quantity("tread_middle", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "Modulus of the tread at the transition temperature.").into<&physics::EquivalentModulus::E_mid>(),
            quantity("tread_fall", {.unit = "Pa", .low = 0.0, .high = 1e12, .above = true}, "How much the modulus of the tread falls through the transition.").into<&physics::EquivalentModulus::dE_T>(),
            quantity("transition_temperature", temperature, "Temperature of the transition.").into<&physics::EquivalentModulus::T_g>(),
            quantity("transition_width", {.unit = "K", .scale = Scale::difference, .low = 0.0, .high = 1e4, .above = true}, "Width of the transition.").into<&physics::EquivalentModulus::dT>(),
            quantity("reference_temperature", temperature, "Temperature of the bulk at which the stiffness is that of `property_file`; a property file does not tell. Default: 70 degC, assumed: a tire on a Flat-Trac.").into<&physics::Handling::reference_temperature>(),
            flag("tuned", "The moduli were tuned to the tire of `property_file`: their stiffness CP replaces that of the file, thesis (59), (60). Default: false.").into<&physics::Handling::replaces_stiffness>(),
            quantity("lambda_CP", {.unit = "1", .low = 0.0, .high = 10.0}, "Scale of the cornering stiffness.").into<&physics::Handling::lambda_CP>(),
        }},
        {"tire.lateral_peak", TableForm::table,
         "The curve of the lateral force against the slip angle by three features, where there is no `property_file`: its slope is the cornering stiffness, and peak and what is left beyond it make the Magic Formula's C and E (thesis (6), (7)). Sensors `lateral_force` and `peak_lateral_force` read it.", {
            quantity("friction", {.unit = "1", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.2, .usual_high = 2.5}, "Largest lateral force over the load.").required().into<&physics::PeakCurve::friction>(),
            quantity("slip_angle", {.unit = "radian", .low = 0.0, .high = 1.5, .above = true, .usual_low = 0.02, .usual_high = 0.4}, "Where the force has its peak. Default: 7.5 degrees; 7 to 8 of the thesis's tire (II.2).").into<&physics::PeakCurve::peak_slip>(),
            quantity("asymptote", {.unit = "1", .low = 0.0, .high = 0.9999}, "Force far beyond the peak, over that of the peak. Default: 0.9, assumed.").into<&physics::PeakCurve::asymptote>(),
        }},
        {"tire.grip", TableForm::table,
         "How the friction of the tread follows the temperature of its surface, read by the sensors `grip`, `lateral_force` and `peak_lateral_force`: the sum of adhesion, hysteresis and wear (thesis (30)), over that at `reference_temperature`. The heat of sliding follows the forces of the drive and does not change.", {
            law("adhesion", {.unit = "1", .low = 0.0, .high = 10.0}, "Friction coefficient of adhesion, a law of temperature: measured, or a number. With `hysteresis` 0 it may be a measured friction as a whole. Default: 0."),
            quantity("hysteresis", {.unit = "1", .low = 0.0, .high = 10.0}, "Friction coefficient of hysteresis at the reference temperature; from there it follows the tread's loss tangent at `frequency`. Default: 0.").into<&physics::Grip::hysteresis>(),
            quantity("wear", {.unit = "1", .low = 0.0, .high = 10.0}, "Friction coefficient of wear, at any temperature; in the thesis at most 2 % of the whole. Default: 0.").into<&physics::Grip::wear>(),
            quantity("reference_temperature", temperature, "Of the tread's surface, where the friction is that of `property_file` or `lateral_peak`. Default: 40 degC, assumed.").into<&physics::Grip::reference_temperature>(),
            quantity("frequency", {.unit = "Hz", .low = 1e-3, .high = 1e9}, "Of the deformation by the road's asperities. Default: 1 kHz: sliding at 1 m/s over asperities 1 mm apart.").into<&physics::Grip::frequency>(),
        }},
        {"tire.measured", TableForm::table,
         "What footprints and a test of cornering gave, beside which page, JSON and `check` show the laws (thesis V.4.7 to V.4.9). Nothing computes with it; to do that, give the table in `[tire]`.", {
            subtable("contact_length", "Measured contact length against load."),
            subtable("contact_area", "Measured contact area against load."),
            subtable("loaded_radius", "Measured loaded radius against load."),
            subtable("rolling_radius", "Measured rolling radius against load."),
            value("cornering_stiffness", "Measured cornering stiffness: a file or a table with the columns `vertical_load`, `bulk_temperature` and `cornering_stiffness`, a row for each test."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
