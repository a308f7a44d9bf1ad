// SPDX-License-Identifier: BSD-3-Clause
// Keys of [[parameter]], [identify], [diagnose], [[critical]] and [[uncertain]]: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> fit_tables() {
    return {
        {"parameter", TableForm::list,
         "A number of the case that a fit may change. Exactly one of `effect`, `source`, `exchange`, `material`, `camera`, `link` and `initial` says which. The value of the case, where a fit starts, must lie within the bounds.", {
            text("effect", "An effect that is on, or the name of a `[[source]]` or an `[[exchange]]`."),
            text("key", "Of `effect` and `camera`: which of its parameters.").sometimes(),
            text("patch", "Of `effect`: at one patch, where parameters may differ there. A parameter that is free everywhere as well needs a value of its own at the place (`..._by_patch`)."),
            value("layer", "Of `effect`: in one layer."),
            value("zone", "Of `effect`: in one zone."),
            text("channel", "Of `effect`: behind one sensor."),
            text("source", "A `[[source]]`: its watts."),
            text("exchange", "An `[[exchange]]`: its conductance."),
            text("material", "A material: one of its laws."),
            choice("law", {"conductivity", "heat_capacity"}, "Of `material`: which law.").required(),
            texts("at", "Of `material` and `link`: the law by its values at one, two or three temperatures, each a parameter. One scales the law, whatever its form; two tilt it and keep its curvature; three make it the parabola through them. A table can only be scaled.").required(),
            text("camera", "A camera: `x`, `y`, `rotation`, `blur`, and `emissivity` and `reflected_temperature` where the case states them."),
            choice("link", {"conductivity"}, "`conductivity`: of the link between two nodes."),
            choice("each", {"axle", "side", "corner"}, "`axle`, `side` or `corner`: a parameter of its own for each of them, named after it. Of values of `[effects]`. Default: one that all corners share."),
            texts("initial", "`temperature` (all of it, gas and rim too), a layer, `gas`, `rim`, or a list of them: a shift from what each run says of its start, a parameter for each word and run."),
            quantity_of_owner("expected", "What is expected before the data; a list where `at` has several temperatures. Default: the value of the case."),
            quantity_of_owner("standard_deviation", "Of what is expected. Default: nothing is known."),
            quantity_of_owner("low", "Lower bound. Default: that of the parameter; of a law a hundredth; none of a shift."),
            quantity_of_owner("high", "Upper bound. Default: that of the parameter; of a law a hundred times; none of a shift."),
        }},
        {"identify", TableForm::table,
         "How `identify` fits.", {
            choice("noise", {"automatic", "correlated", "white"}, "Correlated: white noise and a part that decays over seconds. Automatic: correlated, and where that is in doubt the one of the two that predicts data that were left out better. Default: automatic."),
            flag("robust", "Whether outliers count less. Default: false."),
        }},
        {"diagnose", TableForm::table,
         "What `diagnose` may name.", {
            texts("candidates", "Ids of effects, or `effect.key` for one parameter. An effect of the list that is on has its parameters doubted. Default: every parameter with an absent value of every effect that is off, whose inputs are given and whose place the mesh has."),
            texts("signals", "Columns of the files, not used by the model, that an unknown cause may follow: these and no others, whatever they are; `*` stands for any characters, `?` for one. Inputs are tried in any case. Default: the columns that drive the tire; its temperatures, copies, results and clocks are left out."),
            texts("ignore", "Columns that no cause may follow, in the same form. Default: none."),
            tables("possible", "Manoeuvres that can be run as the next experiment: of these the one is proposed that tells the explanations apart best. Default: those of [manoeuvres.toml](../cases/manoeuvres.toml)."),
        }},
        {"diagnose.possible", TableForm::list,
         "A manoeuvre: a name and what drives the tire while it lasts. Slips, forces and the laser that it does not give are zero; other inputs are what they are when the first run begins.", {
            text("name", "What it is called where it is proposed.").required(),
            value("drive", "Inputs as of the case's `[drive]`, with a `schedule`, or a `file` such as that of an earlier drive. A slip angle without `lateral_force` makes the force that it has made in the runs.").required(),
            texts("of_largest", "Inputs of it that are shares, 0 to 1, of the largest value that the runs have: `of_largest = [\"laser_power\"]`. Default: none."),
        }},
        {"critical", TableForm::list,
         "A temperature that a part of the tire should not pass. The part is where layers, zones and materials meet. `run` says where it is hottest, between the cells, when it passes the temperature and in which step, or how much is left ([page](../cases/durability/README.md)).", {
            name("name", "Name of the part.").required(),
            quantity("temperature", temperature, "The critical temperature.").required(),
            texts("layers", "Default: all."),
            texts("zones", "Default: all."),
            texts("materials", "Default: all."),
            text("surface", "The sensor that stands beside it. Default: the mean of the region surface."),
        }},
        {"uncertain", TableForm::list,
         "A value of the case that is known with a standard deviation only. With it and with every `[[parameter]]` that has a `standard_deviation`, `run` says what drives each hot spot, and how probable it is that it passes its critical temperature.", {
            text("key", "Path of the value, as in a study: `drive.air_temperature`.").sometimes(),
            quantity_of_owner("standard_deviation", "With its unit; of a temperature a difference.").sometimes(),
            text("alternative", "In the place of both: a file, from this one's folder, with tables that may hold as well as those of the case. Both are taken as equally likely: half of the difference is the standard deviation, and moves the mean."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
