// SPDX-License-Identifier: BSD-3-Clause
// A row for each unused column, and a sentence on what was done with them.

#include "post/diagnosis/unused_columns.hpp"

#include <string>
#include <utility>

#include "input/columns/column_kinds.hpp"

namespace tiretherm::post {

DataTable unused_columns_table(const input::Experiment& experiment) {
    DataTable table;
    for (const input::ColumnSummary& column : input::unused_columns(experiment.runs)) {
        const Cell kind(std::string(input::word_of(column.kind)), std::string(input::text_of(column.kind)), false);
        const Cell tried(column.may_be_cause, column.may_be_cause ? "yes" : "no", false);
        table.add({{"column", "name", column.name},
                   {"kind", "kind", kind},
                   {"tried", "tried", tried},
                   {"because", "reason", column.reason}});
    }
    return table;
}

ReportSection unused_columns_section(const input::Experiment& experiment) {
    ReportSection section("Columns that the model does not use");
    DataTable table = unused_columns_table(experiment);
    if (!table.empty()) {
        section.add(std::move(table));
        section.say(
            "Unknown heat and errors of sensors may follow the inputs and the columns that were tried. A temperature "
            "of the tire, a copy, a result or a clock is no cause. [diagnose] signals and ignore change that.");
    }
    return section;
}

}  // namespace tiretherm::post
