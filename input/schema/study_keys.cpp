// SPDX-License-Identifier: BSD-3-Clause
// Keys of a study: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> study_tables() {
    return {
        {"study:", TableForm::table,
         "At the top of a study, for `tiretherm study`. A key is a path into the case: `drive.speed`, `effects.air_convection.lambda_h`, and by name in lists: `mesh.layer.tread.thickness`, `material.tread rubber.density`. An effect that is named is on. The case must have no `[[run]]`.", {
            text("title", "Default: the name of the study."),
            text("case", "The case, from the study's folder.").required(),
            quantity("critical", temperature, "A temperature that the hottest place should not pass. Default: none."),
            value("include", "As in a case."),
            value("unset", "As in a case."),
            value("set", "As in a case."),
            subtable("sample", "How many samples are drawn."),
            tables("vary", "A side of the grid."),
            tables("draw", "A value that is drawn at each point of the grid."),
        }},
        {"sample", TableForm::table,
         "How many samples are drawn at each point of the grid. With five for each drawn value and one more, the study also says what drives the hottest temperature: a straight line of all of them, with its R2 and with a 95 % interval for each.", {
            count("count", 1, 100000, "Number of samples.").required(),
            count("seed", 0, 2000000000, "Of the random numbers. Default: 1."),
        }},
        {"vary", TableForm::list,
         "A side of the grid.", {
            text("key", "Path into the case.").required(),
            value("values", "A list of values or words."),
            quantity_of_owner("from", "First value, in place of `values`.").sometimes(),
            quantity_of_owner("to", "Last value.").sometimes(),
            count("count", 2, 10000, "Number of values from `from` to `to`, equally spaced.").sometimes(),
        }},
        {"draw", TableForm::list,
         "A value that is drawn at random at each point of the grid.", {
            text("key", "Path into the case.").required(),
            choice("distribution", {"normal", "lognormal", "uniform"}, "Normal and lognormal by mean and standard deviation of the quantity itself; uniform by its ends.").required(),
            quantity_of_owner("mean", "Of normal and lognormal.").sometimes(),
            quantity_of_owner("standard_deviation", "Of normal and lognormal.").sometimes(),
            quantity_of_owner("from", "Lower end of uniform.").sometimes(),
            quantity_of_owner("to", "Upper end of uniform.").sometimes(),
            quantity_of_owner("low", "The distribution is cut off below. Default: nowhere."),
            quantity_of_owner("high", "The distribution is cut off above. Default: nowhere."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
