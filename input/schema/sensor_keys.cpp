// SPDX-License-Identifier: BSD-3-Clause
// Keys of [[sensor]], [[camera]], [[instrument]] and [[measured]]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"
#include "physics/camera.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> sensor_tables() {
    return {
        {"sensor", TableForm::list,
         "A channel. `point`: the temperature at a point; `spot`: the mean over a disc about the centre of a block or a disc; `patch`, `layer`, `zone`, `region`: the mean over it; `strip`: the mean over the outer surface between two arc lengths, by area; `strips`: an array of strips, channels `name_1`, `name_2` ..., the first the outermost on the outboard side; `node`: the gas or the rim. `heat_flux`: heat out of the rubber through a patch, per area, positive outwards, not on two nodes. `drag_force`, `rolling_moment`: rolling resistance of all that deformation loses (thesis (50), (51)). `loaded_radius`. `gas_pressure`: heated at constant volume. `surface_at_entry`, `surface_at_exit`: the tread's surface where it meets and leaves the road in each revolution, with `resolved_contact` on. `contact_pressure_outside`, `contact_pressure_middle`, `contact_pressure_inside`: the contact pressure of outside shoulder, crown and inside shoulder over the mean of the tread, with `pressure_across_tread` on. `cornering_stiffness` (52), `bulk_temperature_factor` (60), `lateral_force` (59), `reference_lateral_force` (10), `longitudinal_force` (8): the last four need a `property_file`, `lateral_force` that or `[tire.lateral_peak]`. `grip` (30) and `peak_lateral_force` follow the surface's temperature by `[tire.grip]`, and with it `lateral_force`, too.", {
            name("name", "Name of the channel.").required(),
            choice("kind", {"point", "spot", "patch", "layer", "region", "zone", "node", "strip", "strips", "drag_force", "rolling_moment", "loaded_radius", "cornering_stiffness", "bulk_temperature_factor", "lateral_force", "reference_lateral_force", "longitudinal_force", "surface_at_entry", "surface_at_exit", "gas_pressure", "contact_pressure_outside", "contact_pressure_middle", "contact_pressure_inside", "heat_flux", "grip", "peak_lateral_force"}, "What it measures.").required(),
            text("meaning", "Says which temperature it is. Default: made from the place."),
            quantity_of_owner("standard_deviation", "Of one sample, as the data sheet says. Default: unknown."),
            quantity("depth", depth, "Below the outer surface.").required().kinds("point"),
            quantity("x", coordinate, "On a block. Default: 0.").kinds("point"),
            quantity("y", coordinate, "On a block. Default: 0.").kinds("point"),
            quantity("radius", depth, "On a disc: distance from the axis. Default: 0.").kinds("point"),
            quantity("radius", length, "Radius of the spot.").required().kinds("spot"),
            quantity("along", coordinate, "On a section: arc length from the centre plane. Default: 0.").kinds("point"),
            texts("zones", "On a section, in place of `along`: the middles of these zones, of several the mean.").kinds("point"),
            text("patch", "Name of the patch.").sometimes().kinds("heat_flux patch spot"),
            text("layer", "Name of the layer.").required().kinds("layer"),
            text("zone", "Name of the zone; of a `layer` on a section: the part of it in this zone.").required().kinds("zone"),
            text("region", "Name of the region.").required().kinds("region"),
            text("node", "`gas`, `rim` or `drum`.").required().kinds("node"),
            quantity("from", coordinate, "Arc length from the centre plane, negative outboard.").required().kinds("strip strips"),
            quantity("to", coordinate, "Arc length from the centre plane.").required().kinds("strip strips"),
            count("count", 2, 1000, "Number of strips side by side.").required().kinds("strips"),
            choice("first", {"outboard", "inboard"}, "On which side `NAME_1` lies. Default: outboard.").kinds("strips"),
            quantity("angle", {.unit = "radian", .low = -1000.0, .high = 1000.0}, "On a ring: one place of the turning rubber. Default: the mean around the circumference."),
            text("temperature_of", "A sensor above this one whose temperature the quantity follows. Default: the bulk; for `surface_at_entry`, `surface_at_exit`, `grip` and `peak_lateral_force` the region surface.").kinds("cornering_stiffness gas_pressure surface_at_entry surface_at_exit grip peak_lateral_force"),
        }},
        {"camera", TableForm::list,
         "A thermal camera whose frames are measured data, on a `block` or an `axisymmetric` mesh; one sensor, however many pixels. Sensor models take its name in `channels`. What a pixel shows: [Frames of a camera](../cases/README.md#frames-of-a-camera).", {
            name("name", "Name of the camera.").required(),
            choice("surface", {"top", "bottom"}, "The patch that it looks at. Default: top."),
            texts("pixel_size", "On the specimen; two for different sizes along a row and along a column. Default: that of the file."),
            quantity("x", {.unit = "m", .low = -0.1, .high = 0.1}, "Where the image's centre lies; columns run along x. Default: 0.").into<&physics::CameraPose::x>(),
            quantity("y", {.unit = "m", .low = -0.1, .high = 0.1}, "Where the image's centre lies; rows run along y. Default: 0.").into<&physics::CameraPose::y>(),
            quantity("rotation", {.unit = "rad", .low = -3.2, .high = 3.2}, "Of the image, from x towards y. Default: 0.").into<&physics::CameraPose::rotation>(),
            quantity("blur", {.unit = "m", .low = 0.0, .high = 0.1}, "Full width at half maximum of the optics' Gaussian blur. Default: 0, a pixel sees its square alone.").into<&physics::CameraPose::blur>(),
            quantity("emissivity", {.unit = "1", .low = 0.0, .high = 1.0, .above = true, .usual_low = 0.5}, "Of the surface. Default: 1."),
            quantity("reflected_temperature", temperature, "What a surface of lower emissivity mirrors. Default: the air's."),
            quantity("standard_deviation", tolerance, "Of one detector (NETD). Default: unknown."),
            value("rows", "The part that counts, first and last, from 0. Default: all."),
            value("columns", "The part that counts, first and last, from 0. Default: all."),
            count("bin", 1, 1000, "So many by so many detectors make a pixel. Default: 1."),
        }},
        {"instrument", TableForm::list,
         "A camera, an array, a logger or an amplifier that reads several sensors: what is wrong with it is wrong with all of them, and is one cause. Sensors of one quantity whose names differ in a number or a word for a place alone (`ir_1`, `ir_2`; `surface_inside`, `surface_outside`), and sensors of surfaces with one standard deviation, are assumed to be read by one where no `[[instrument]]` has them.", {
            text("name", "What results call it.").required(),
            texts("sensors", "Names of its sensors, two at least; `*` stands for any characters, `?` for one.").required(),
        }},
        {"measured", TableForm::list,
         "A number from a source, to stand beside the simulated one.", {
            text("channel", "A sensor.").required(),
            quantity("value", temperature, "The number, in any unit of what the channel measures.").sometimes(),
            texts("range", "Two ends, in place of `value`. A range adds its width as that of a flat distribution, width/sqrt(12), in quadrature."),
            quantity("uncertainty", {.unit = "K", .scale = Scale::difference, .low = 0.0, .above = true}, "Standard uncertainty. Default: none."),
            quantity("time", moment, "Default: the end."),
            text("source", "What to cite. Default: none."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
