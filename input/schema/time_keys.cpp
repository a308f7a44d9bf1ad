// SPDX-License-Identifier: BSD-3-Clause
// Keys of [initial], [limits] and [time]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"
#include "solver/problem.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> time_tables() {
    return {
        {"initial", TableForm::table,
         "The temperatures at the start. Beside `temperature` there may be a key for each layer, which wins, and for nodes of their own, `gas` and `rim` (default: the air's) and `drum` (the road's). Instead of a temperature each may be `\"air_temperature\"`, that of the air at the start, or the name of a sensor that the run measures: the mean of its readings (of all strips of an array) in the first second of the run.", {
            quantity("temperature", temperature, "Temperature everywhere; required unless each layer has its own.").required(),
        }, true},
        {"limits", TableForm::table,
         "What a run may come to. A larger one is refused before anything of its size is made, by `check` as well; `check` says how large a sound case is. Amounts of memory have the units B, kB, MB, GB and TB.", {
            quantity("cells", {.unit = "1", .low = 1.0, .high = 2e8}, "Cells of the mesh. Default: 5 million."),
            quantity("rows", {.unit = "1", .low = 1.0, .high = 1e15}, "Rows of the channels. Default: 10 million."),
            quantity("steps", {.unit = "1", .low = 1.0, .high = 1e15}, "Steps of a fixed length. Default: 1000 million."),
            text("output", "All files of a run, by estimate. Default: 20 GB."),
            text("memory", "Memory at the peak of a run, by estimate. Default: 8 GB, which is a mesh of about 4 million cells."),
        }},
        {"time", TableForm::table,
         "Duration, accuracy and output. Optional where the logs give the duration.", {
            quantity("start", moment, "Default: first time of the logs, else 0 s."),
            quantity("end", moment, "Default: last time of the logs.").sometimes(),
            flag("steady", "The steady state of the inputs at `end` in place of a run. Default: false.").into<&solver::Settings::steady>(),
            quantity("step", duration, "Fixed time step. Default: none, the error decides.").into<&solver::Settings::fixed_step>(),
            quantity("largest_step", duration, "No step is longer, however small its error: rows of every step lie no further apart. Default: none.").into<&solver::Settings::largest_step>(),
            quantity("tolerance", tolerance, "Largest local error of a step; the error at the end of a run may be a few times as large. `identify` and `diagnose` step with 0.001 K at most, but for camera frames. Default: 0.01 K.").into<&solver::Settings::tolerance>(),
            quantity("output", interval, "Interval of the rows of channels. Default: 0 s, every step.").into<&solver::Settings::output_interval>(),
            quantity("fields", interval, "Interval of the stored fields. Default: 0 s, the first and the last.").into<&solver::Settings::field_interval>(),
            choice("method", {"tr_bdf2", "backward_euler"}, "Time integration. Default: tr_bdf2.").into<&solver::Settings::method>(),
            choice("linear_solver", {"automatic", "cholesky", "conjugate_gradient"}, "Default: automatic, by the predicted fill.").into<&solver::Settings::linear_solver>(),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
