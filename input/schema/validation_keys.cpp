// SPDX-License-Identifier: BSD-3-Clause
// Keys of a table of measured numbers: form, unit and range, need and meaning, a line each.
#include "input/schema/all_tables.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input::schema {

using namespace quantity_specs;

// clang-format off
std::vector<TableKeys> validation_tables() {
    return {
        {"table:", TableForm::table,
         "At the top of a table of measured numbers, for `tiretherm validate`.", {
            text("title", "Heading of the results. Default: Validation."),
            value("include", "As in a case."),
            value("unset", "As in a case."),
            value("set", "As in a case."),
            tables("number", "The numbers.").required(),
            tables("input", "The inputs of the experiments."),
            tables("model", "The models that are judged. Default: `two_node` and `section`."),
        }},
        {"number", TableForm::list,
         "A measured number and how it is read from a simulation: `at` a time or `\"end\"`; `take` over a span; or `time_to`. With none of them it is the value at the end. A number without a measured value is shown, not judged. A model is within a number up to twice its standard uncertainty; an order holds or does not. Where that depends on an input that is not printed, the number is not decidable.", {
            text("id", "Of the experiment; `--only M12` runs these alone.").required(),
            text("what", "What is measured.").required(),
            text("case", "From the table's folder; `_` and the key of each model, `.toml`, are added: `_two_node.toml`."),
            subtable("files", "By the keys of the models, `{ two_node = \"...\", section = \"...\" }` in place of `case`."),
            texts("models", "Models that are judged. Default: all that have a file."),
            text("channel", "A sensor of the case.").sometimes(),
            quantity("at", moment, "A time, or `\"end\"`."),
            choice("take", {"mean", "max", "min"}, "What is taken between `from` and `to`."),
            quantity("time_to", {.unit = "1", .low = 0.0, .high = 1.0, .above = true}, "The time after `from` until this share of the change up to `to` has been reached."),
            quantity("from", moment, "Default: the start."),
            quantity("to", moment, "Default: the end."),
            subtable("minus", "A value that is subtracted. What it leaves out it takes over from the number."),
            subtable("over", "A value that it is divided by; may have a `minus` of its own."),
            quantity_of_owner("value", "The measured value: °C of a temperature, K of a difference of two."),
            value("range", "Two ends, in place of `value`."),
            quantity_of_owner("above", "Where only an order or a sign is known."),
            quantity_of_owner("below", "Where only an order or a sign is known."),
            quantity_of_owner("uncertainty", "Standard: `\"3.6 K\"`, or independent parts by name: `{ sensor = \"2 K\", ramp = \"3 K\" }`.").sometimes(),
            text("source", "What to cite.").required(),
            flag("about_the_model", "The source says this of its own model, not of the tire: `validate` judges it, `diagnose` leaves it out. Default: false."),
            texts("inputs", "Names of the `[[input]]` that it depends on. Default: none."),
            texts("inferred_from_it", "Names of those that were inferred from this very number: it is not decidable. Default: none."),
        }},
        {"model", TableForm::list, "A model that is judged.", {
            text("key", "How its cases end, and its key in `files` and `models`.").required(),
            text("name", "As the page calls it. Default: the key."),
            text("of", "Key of a model above whose cases it takes, with the file `with` over each. A case of its own wins."),
            text("with", "File in the folder of each case of that model. Its values win over those of the case."),
        }},
        {"number.minus", TableForm::table,
         "A value that is subtracted, or by which the number is divided (`over`): keys as of `[[number]]`, and what is left out is that of the number.", {
            text("case", "As of `[[number]]`."),
            subtable("files", "As of `[[number]]`."),
            text("channel", "As of `[[number]]`."),
            quantity("at", moment, "As of `[[number]]`."),
            choice("take", {"mean", "max", "min"}, "As of `[[number]]`."),
            quantity("time_to", {.unit = "1", .low = 0.0, .high = 1.0, .above = true}, "As of `[[number]]`."),
            quantity("from", moment, "As of `[[number]]`."),
            quantity("to", moment, "As of `[[number]]`."),
            subtable("minus", "Of `over` alone: a value that is subtracted from it."),
        }},
        {"input", TableForm::list,
         "An input of an experiment: printed in the source, or unknown within a range. `validate` runs each number at both ends of the range of each of its unknown inputs, one by one. One of `keys`, `signal`, `between` and `reads` says what the input changes; a printed one may leave it out.", {
            text("name", "For `inputs` and `inferred_from_it` of a number.").required(),
            text("meaning", "What it is, and on what grounds its range stands.").required(),
            choice("standing", {"printed", "inferred", "assumed"}, "Where its value comes from: the source, other numbers of the source, or nowhere.").required(),
            value("value", "As the cases have it, which is checked.").sometimes(),
            value("range", "Two ends, with the value between them; of `reads` what else may be read: sensors or cases. Needed unless the input is printed.").sometimes(),
            texts("keys", "Paths into the case that have the value: `[\"drive.air_temperature\"]`. A case that gives none of them is not changed."),
            flag("adds_keys", "The keys are also written into cases that do not give them; the value is then the default. Default: false."),
            text("signal", "A column of `[[drive.schedule]]`: entries that have the value are changed."),
            value("between", "Parts of `[[drive.schedule]]` as pairs of times, each as long as the value: they are stretched, and all later times of the case and of the number move."),
            choice("reads", {"channel", "case", "time_to"}, "What the number is read from: another sensor, another case (without model and ending), or another share of `time_to`."),
            texts("cases", "Cases that it changes, without model and ending. Default: all of the number."),
        }},
    };
}
// clang-format on

}  // namespace tiretherm::input::schema
