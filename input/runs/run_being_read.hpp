// SPDX-License-Identifier: BSD-3-Clause
// A measured run while the runs of its case are read, and what only several of them together show.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "input/drive/run_table.hpp"
#include "input/measurements/experiment.hpp"
#include "input/runs/case_tables.hpp"

namespace tiretherm::input {

/// A run as it is being read.
struct RunBeingRead {
    RunTable table;
    TomlValue document;                 ///< of the case, with the tables of the run laid over it
    std::optional<RunInputs> inputs{};  ///< of a run that is measured
    CaseTables tables{};
    MeasuredRun run{};

    [[nodiscard]] bool has_readings() const {
        return !run.series.empty() || !run.numbers.empty() || !run.frames.empty();
    }
};
using RunsBeingRead = std::vector<std::unique_ptr<RunBeingRead>>;

/// A number of the case counts in each run that has none of its own; it was hardly measured in several.
void warn_of_shared_numbers(const TomlValue& document, const RunsBeingRead& runs, InputErrors& errors);

/// Corners of which a run measured nothing take no part in it; where none measured anything, it is an error.
void leave_out_idle_corners(RunsBeingRead& runs, InputErrors& errors);

/// Corners may differ in the values of effects, not in which effects there are: a parameter has one place for all.
void check_same_effects(const RunsBeingRead& runs, InputErrors& errors);

}  // namespace tiretherm::input
