// SPDX-License-Identifier: BSD-3-Clause
// Keys of [drive]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"

namespace tiretherm::input::schema {

// clang-format off
std::vector<TableKeys> drive_tables() {
    return {
        {"drive", TableForm::table,
         "The inputs, each with one origin: a constant here, a schedule, or a log. [Measured runs](../cases/README.md#measured-runs) describes the files.", {
            signal("speed", "Speed of the wheel's centre."),
            signal("vertical_load", "Load on the tire."),
            signal("slip_angle", "Slip angle; with `lateral_force` it gives heat of sliding in the contact."),
            signal("slip_ratio", "Longitudinal slip."),
            signal("slip_speed", "Longitudinal slip as a speed, Omega R_R - V, in the place of slip_ratio: a wheel that spins on the spot heats up."),
            signal("lateral_force", "Lateral force, of either sign."),
            signal("longitudinal_force", "Longitudinal force."),
            signal("camber", "Camber angle; negative where the top leans inboard, which loads the inside shoulder more."),
            signal("inflation_pressure", "Inflation pressure above the atmosphere."),
            signal("air_temperature", "Temperature of the air around the tire."),
            signal("road_temperature", "Temperature of the road or the drum."),
            signal("wet", "How wet the road is, 0 to 1."),
            signal("laser_power", "Power of the laser's light on the spot."),
            signal("brake_temperature", "Temperature of the brake disc, which `brake_heat` follows."),
            signal("wheel_angle", "Angle of the wheel. Default: follows from speed and load where an effect needs it."),
            tables("schedule", "Inputs as straight lines between points."),
            tables("file", "Inputs from a logger's file."),
        }},
        {"drive.schedule", TableForm::list,
         "Straight lines between the rows; two rows at one time are a jump.", {
            texts("columns", "Headings with units; one of them is `time`.").required(),
            value("rows", "The points.").required(),
        }},
        {"drive.file", TableForm::list,
         "A logger's file, in any format of `file` of `[[run]]`. Short gaps of an input are bridged as there. Columns that are no inputs are not read, except those that a `[[source]]` or an `[[exchange]]` follows.", {
            text("path", "The file, beside the case.").required(),
            subtable("columns", "Other names of columns: `{ Fz = \"vertical_load\" }`. Default: their own."),
            subtable("units", "As of `[[run]]`."),
            subtable("unit_names", "As of `[[run]]`."),
            texts("ignore", "Columns that are inputs but shall not be used."),
            texts("hold", "As of `[[run]]`."),
            flag("keep_suspicious", "Samples that look dead count all the same. Default: false."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
