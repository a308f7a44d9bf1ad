// SPDX-License-Identifier: BSD-3-Clause
// Keys of [[run]], [[corner]], [[pyrometer]] and [data]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"
#include "physics/vehicle/vehicle.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> run_tables() {
    return {
        {"run", TableForm::list,
         "A measured run: the case with the tables of the run laid over it. [Measured runs](../cases/README.md#measured-runs) describes the files and what is checked.", {
            name("name", "Default: the file's stem; required without a file.").sometimes(),
            text("file", "CSV or HDF5, beside the case."),
            subtable("frames", "File of a camera's frames, or `{ outside = \"outside.h5\" }` for several cameras."),
            subtable("columns", "The file's column to an input, a sensor or `time`: `{ V = \"speed\" }`. Default: their own names."),
            subtable("units", "Units of columns whose heading has none, or a wrong one: `{ V = \"km/h\" }`."),
            subtable("unit_names", "What units of headings are called in truth, for all columns at once: `{ \"V\" = \"km/h\" }`. C of a temperature is degC and g of an acceleration is 9.80665 m/s2 without it. `units` of a column wins."),
            texts("ignore", "Columns that shall not be used."),
            texts("hold", "Inputs that keep each value until the next sample, as switched ones do: `hold = [\"laser_power\"]`; others go straight from sample to sample. Two lines of a file at one time are a jump."),
            flag("keep_suspicious", "Samples of sensors that look stuck, clipped, dead or interpolated count all the same. They are reported in any case. Default: false, fits and diagnoses leave them out."),
            quantity("from", moment, "Start of the part of the file that is used. Default: its first time."),
            quantity("to", moment, "End of the part of the file that is used. Default: its last time."),
            text("laps", "The laps of the file that are used, in the place of `from` and `to`: `\"2\"`, `\"3-9\"` or `\"2, 4-6\"`; `tiretherm check LOG` lists them. The tire runs through the laps between them, but their readings do not count. Without `name` the run is called after the file and its laps. Default: the whole file."),
            count("repeat_first_lap", 0, 20, "How often the first of `laps` is driven before the run, from the initial temperatures on: for a log that starts when the tires are warm inside. 0 to 20. Default: 0."),
            value("start_line", "Where a lap begins: the two ends of a line across the track, latitude and longitude in degrees, `[[51.2077, -1.6089], [51.2078, -1.6086]]`; the file has columns of both. Default: the logger's marks, a column that counts laps, the logger's start line, or the place where the track closes."),
            value("drive", "Inputs of this run over those of the case."),
            value("initial", "Initial temperatures of this run over those of the case."),
            value("time", "Time settings of this run over those of the case."),
            value("vehicle", "Keys of the car for this run over those of the case: `{ corner = \"RL\" }`."),
            value("corner", "What differs at a corner in this run alone: `{ FL = { initial = { temperature = \"40 degC\" } } }`, with the keys `drive`, `initial`, `time` and `measured`. It is laid over what the corner and the run say."),
            value("measured", "Numbers of this run: `[{ channel, value, uncertainty }]`."),
        }},
        {"corner", TableForm::list,
         "A wheel of a car. Each run then counts once for each corner, under the name `RUN_CORNER`: with the tire, the mesh and the sensors of the case, and the columns, the inputs and the values of the corner. A corner at which a run measures nothing is left out.", {
            choice("name", {physics::corner_names.begin(), physics::corner_names.end()}, "`FL`, `FR`, `RL` or `RR`: front or rear, left or right.").required(),
            subtable("columns", "The file's columns of this corner: `{ \"IR FL 1\" = \"surface_temperature\" }`. What a `[[run]]` says of a column wins, then the corner, then `[data]`."),
            subtable("units", "As of `[[run]]`."),
            subtable("unit_names", "As of `[[run]]`."),
            texts("ignore", "As of `[[run]]`."),
            texts("hold", "As of `[[run]]`."),
            flag("keep_suspicious", "As of `[[run]]`."),
            value("drive", "Inputs of this corner over those of the case, such as `camber` and `inflation_pressure`. A column of a run's file wins."),
            value("initial", "Initial temperatures of this corner over those of the case."),
            value("measured", "Numbers of this corner: `[{ channel, value, uncertainty }]`."),
            value("effects", "Values of effects at this corner: `{ air_convection = { lambda_h = 0.9 } }`. Which effects there are is the same for all."),
        }},
        {"pyrometer", TableForm::list,
         "A stop at which tires were measured by hand, usually inner, centre and outer of each. It gives numbers to a run, as `[[measured]]` does.", {
            texts("sensors", "The sensors that the readings are those of, in their order: three places of a section. With one sensor, such as the bulk of two nodes, several readings are averaged.").required(),
            texts("FL", "Readings at this corner: `[\"81 degC\", \"78 degC\", \"74 degC\"]`."),
            value("FR", "As `FL`."),
            value("RL", "As `FL`."),
            value("RR", "As `FL`."),
            value("readings", "The same of a case without `[[corner]]`."),
            quantity("uncertainty", {.unit = "K", .scale = Scale::difference, .low = 0.0, .above = true}, "Standard uncertainty of a reading, and of a mean of several: what is wrong with the instrument is wrong with all of them.").required(),
            text("run", "The run after or in which it was measured. Default: the only one."),
            quantity("time", moment, "When, on the run's clock. Default: at its end."),
            count("lap", 0, 1000000, "The same by the end of a lap: 8."),
            quantity("after", interval, "How long after the end of `lap`. The log goes on as long: the tire cools while it stands."),
            text("source", "What stands beside the number. Default: pyrometer."),
        }},
        {"data", TableForm::table,
         "How measured files are read: said once for all `[[run]]`, and for files given with `--data`, which take the place of the runs. What a `[[run]]` says itself wins: column by column, and its `ignore` and `hold` as a whole.", {
            subtable("columns", "As of `[[run]]`."),
            subtable("units", "As of `[[run]]`."),
            subtable("unit_names", "As of `[[run]]`."),
            texts("ignore", "As of `[[run]]`."),
            texts("hold", "As of `[[run]]`."),
            flag("keep_suspicious", "As of `[[run]]`."),
            quantity("from", moment, "As of `[[run]]`, of files given with `--data` alone."),
            text("laps", "As of `[[run]]`, of files given with `--data` alone."),
            count("repeat_first_lap", 0, 20, "As of `[[run]]`, of files given with `--data` alone."),
            value("start_line", "As of `[[run]]`, of files given with `--data` alone."),
            quantity("to", moment, "As of `[[run]]`, of files given with `--data` alone."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
