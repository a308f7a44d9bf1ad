// SPDX-License-Identifier: BSD-3-Clause
// Keys of [vehicle]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input::schema {

// clang-format off
std::vector<TableKeys> vehicle_tables() {
    return {
        {"vehicle", TableForm::table,
         "The car whose log drives the tire: loads, forces and slips of the wheel `corner` follow from its speed, accelerations and yaw rate ([vehicle.md](vehicle.md)). The log's columns are `speed`, `lateral_acceleration`, `longitudinal_acceleration`, `yaw_rate`, `steering_wheel_angle`, `brake_pressure`, and of roads that are not level `vertical_acceleration` or `bank` and `slope`. What the case or a log gives as an input of the tire wins over what would be computed. A `[run.vehicle]` changes keys for one run.", {
            choice("corner", {physics::corner_names.begin(), physics::corner_names.end()}, "Which wheel the case's tire is.").required(),
            quantity("mass", {.unit = "kg", .low = 0.0, .high = 1e5, .above = true, .usual_low = 150.0, .usual_high = 4e4}, "Of the car as it was driven, with driver and fuel.").required(),
            quantity("wheelbase", {.unit = "m", .low = 0.0, .high = 20.0, .above = true, .usual_low = 1.2, .usual_high = 7.0}, "Distance of the axles.").required(),
            quantity("front_track", {.unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.9, .usual_high = 2.6}, "Distance of the contact centres of the front wheels.").required(),
            quantity("rear_track", {.unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.9, .usual_high = 2.6}, "Default: `front_track`."),
            quantity("centre_of_gravity_height", {.unit = "m", .low = 0.0, .high = 5.0, .above = true, .usual_low = 0.2, .usual_high = 2.0}, "Above the road.").required(),
            quantity("front_weight_share", {.unit = "1", .low = 0.0, .high = 1.0}, "Static load of the front axle over the weight: where the centre of gravity is along the car.").sometimes(),
            quantity("centre_of_gravity_behind_front_axle", {.unit = "m", .low = 0.0, .high = 20.0, .above = true}, "The same as a distance, in the place of `front_weight_share`."),
            quantity("yaw_inertia", {.unit = "kg m2", .low = 0.0, .high = 1e6, .above = true, .usual_low = 50.0, .usual_high = 1e5}, "About the vertical axis. Default: mass times the distances of both axles from the centre of gravity."),
            quantity("front_roll_stiffness_share", {.unit = "1", .low = 0.0, .high = 1.0}, "Roll stiffness of the front axle (springs, anti-roll bar) over that of both: it decides which axle transfers more load in a turn.").required(),
            quantity("front_roll_centre_height", {.unit = "m", .low = -1.0, .high = 2.0, .usual_low = -0.2, .usual_high = 0.8}, "Above the road. Default: 0."),
            quantity("rear_roll_centre_height", {.unit = "m", .low = -1.0, .high = 2.0, .usual_low = -0.2, .usual_high = 0.8}, "Above the road. Default: 0."),
            quantity("drag_area", {.unit = "m2", .low = 0.0, .high = 20.0, .usual_low = 0.0, .usual_high = 8.0}, "C_D A. Default: 0, no drag."),
            quantity("downforce_area", {.unit = "m2", .low = -20.0, .high = 20.0, .usual_low = -2.0, .usual_high = 8.0}, "-C_L A of both axles; negative where the air lifts the car. Default: 0."),
            quantity("front_downforce_share", {.unit = "1", .low = -2.0, .high = 3.0, .usual_low = 0.0, .usual_high = 1.0}, "Share of the front axle in it, the moment of the drag included, as a wind tunnel gives it.").sometimes(),
            quantity("air_density", {.unit = "kg/m3", .low = 0.0, .high = 3.0, .above = true, .usual_low = 0.8, .usual_high = 1.5}, "Default: 1.2 kg/m3."),
            choice("driven_axle", {"front", "rear", "all"}, "Which wheels drive the car.").required(),
            quantity("front_drive_share", {.unit = "1", .low = 0.0, .high = 1.0}, "Share of the front axle in the driving force, where all wheels drive.").sometimes(),
            quantity("front_brake_share", {.unit = "1", .low = 0.0, .high = 1.0}, "Share of the front axle in the braking force.").required(),
            quantity("brake_heat_capacity", {.unit = "J/K", .low = 0.0, .high = 1e6, .above = true, .usual_low = 500.0, .usual_high = 3e4}, "Of the disc and caliper of one wheel, whose temperature follows from the power of braking. Default: 5000 J/K, 10 kg of iron."),
            quantity("brake_cooling", {.unit = "W/K", .low = 0.0, .high = 1e4, .usual_low = 1.0, .usual_high = 300.0}, "Of one disc to the air. Default: 40 W/K, as on a track."),
            quantity("front_toe_in", {.unit = "radian", .low = -0.1, .high = 0.1, .usual_low = -0.01, .usual_high = 0.01}, "Of each front wheel; negative: toe-out. Default: 0."),
            quantity("rear_toe_in", {.unit = "radian", .low = -0.1, .high = 0.1, .usual_low = -0.01, .usual_high = 0.01}, "Of each rear wheel; negative: toe-out. Default: 0."),
            text("rear_property_file", "The same of the rear tires, where they are others. Default: `property_file`."),
            text("property_file", "A `.tir` file beside the case, of the side that its TYRESIDE says (otherwise the right); on the other one its mirror image counts. Default: that of `[tire]`."),
            quantity("friction_scale", {.unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.5, .usual_high = 1.5}, "Factor on the friction of the property file. Default: 1."),
            quantity("stiffness_scale", {.unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.5, .usual_high = 1.5}, "Factor on its cornering and slip stiffness. Default: 1."),
            quantity("front_cornering_stiffness", {.unit = "N/rad", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5000.0, .usual_high = 1e6}, "Without a property file: of one front tire at its static load; in proportion to the load.").required(),
            quantity("rear_cornering_stiffness", {.unit = "N/rad", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5000.0, .usual_high = 1e6}, "The same of a rear tire.").required(),
            quantity("front_slip_stiffness", {.unit = "N", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5000.0, .usual_high = 1e6}, "Force per slip ratio of one front tire at its static load.").required(),
            quantity("rear_slip_stiffness", {.unit = "N", .low = 0.0, .high = 1e7, .above = true, .usual_low = 5000.0, .usual_high = 1e6}, "The same of a rear tire.").required(),
            quantity("friction", {.unit = "1", .low = 0.0, .high = 10.0, .above = true, .usual_low = 0.2, .usual_high = 2.5}, "Friction coefficient beside stiffnesses: forces against slip are then those of a brush. Default: none, forces are linear in the slip."),
            quantity("steering_ratio", {.unit = "1", .low = 0.0, .high = 100.0, .above = true, .usual_low = 1.0, .usual_high = 30.0}, "Angle of the steering wheel over that of the front wheels. Needed where the steering alone says how the car turns."),
            quantity("smoothing", {.unit = "s", .low = 0.0, .high = 10.0, .usual_low = 0.0, .usual_high = 1.0}, "Base of the triangle under which the signals of the car are averaged, without a delay; 0: as logged. Default: 0.2 s, which keeps 97 % of 1 Hz and removes 10 Hz."),
            choice("lateral_acceleration_sign", {"left", "right", "automatic"}, "In which turn the column is positive; `automatic`: as the yaw rate says, without one as a GPS heading or positions say, and without these `left` (ISO 8855). Default: `automatic`."),
            choice("yaw_rate_sign", {"left", "right", "automatic"}, "In which turn the column is positive; `automatic`: as a GPS heading or positions in the file say, and without them `left` (ISO 8855). Default: `automatic`."),
            choice("steering_sign", {"left", "right", "automatic"}, "To which side the column is positive; `automatic` is `left` (ISO 8855). Default: `automatic`."),
            quantity("bank", {.unit = "radian", .low = -1.2, .high = 1.2, .usual_low = -0.7, .usual_high = 0.7}, "Of the road across the car, where the log has no column `bank`; positive where it helps in left turns. Default: 0."),
            quantity("slope", {.unit = "radian", .low = -0.6, .high = 0.6, .usual_low = -0.25, .usual_high = 0.25}, "Of the road along the car, where the log has no column `slope`; positive uphill. Default: 0."),
            choice("bank_sign", {"left", "right", "automatic"}, "In which turns the column `bank` is positive where the bank helps; `automatic`: in those that the log shows, without them `left`. Default: `automatic`."),
            flag("vertical_acceleration_has_gravity", "Whether the column contains gravity: about 1 g where the car goes straight, otherwise about 0. Default: as the column shows."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
