// SPDX-License-Identifier: BSD-3-Clause
// Keys of tables at the top of a case: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"

namespace tiretherm::input::schema {

// clang-format off
std::vector<TableKeys> case_tables() {
    return {
        {"", TableForm::table,
         "At the top of a case file. Included files are merged in order, then the file itself over them: tables key by key; lists and tables in braces are values and are replaced as a whole; `[[material]]`, `[[sensor]]`, `[[source]]`, `[[exchange]]`, `[[critical]]` and `[[run]]` are merged by `name`; a table that changes its `kind` is replaced. Errors are reported in the file where the value stands. The name of a case is its path below `cases/` without `.toml`.", {
            text("title", "Heading of the results. Default: the name of the case."),
            texts("sources", "What to cite; printed after a run. Default: none."),
            value("include", "Case files that this one is laid over, relative to it. Default: none."),
            value("unset", "Keys of the included files that do not count here, as paths: `unset = [\"drive.air_temperature\"]`, and by name in lists: `sensor.spot`. Default: none."),
            value("set", "Values of the included files that are others here, by their paths, also within lists: `set = { \"mesh.layer.tread.thickness\" = \"7 mm\" }`. Default: none."),
            subtable("limits", "How large a run may become."),
            subtable("tire", "The tire."),
            subtable("mesh", "Where the temperatures are.").required(),
            tables("material", "What the layers are made of.").required(),
            subtable("effects", "The physical effects that act."),
            tables("source", "A heat source of the case's own."),
            tables("exchange", "A heat transfer of the case's own."),
            subtable("drive", "The inputs."),
            subtable("vehicle", "The car, whose log drives the tire."),
            subtable("initial", "The temperatures at the start.").required(),
            subtable("time", "Duration, accuracy and output.").sometimes(),
            tables("sensor", "The channels."),
            tables("camera", "Thermal cameras whose frames are measured data."),
            tables("measured", "Numbers from a source, to stand beside the simulated ones."),
            tables("run", "Measured runs."),
            tables("corner", "The wheels of a car, each with its tire."),
            subtable("data", "How measured files are read."),
            tables("parameter", "Numbers that `identify` and `diagnose` may change."),
            tables("pyrometer", "Readings by hand when the tires have stopped."),
            subtable("identify", "How `identify` fits."),
            subtable("diagnose", "What `diagnose` may name."),
            tables("instrument", "Sensors that one device reads."),
            tables("critical", "Temperatures that parts of the tire should not pass."),
            tables("uncertain", "Values of the case that are known with a standard deviation only."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
