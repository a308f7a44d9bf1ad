// SPDX-License-Identifier: BSD-3-Clause
// Runs that are made because of what a diagnosis says, or blindly, and what the diagnosis says with them.
#pragma once

#include <string>
#include <vector>

#include "hidden_effects/exam/exam_marks.hpp"
#include "hidden_effects/exam/exam_table.hpp"
#include "input/measurements/experiment.hpp"

namespace hidden_effects {

/// Who says which manoeuvre is driven next.
enum class Choice : std::uint8_t {
    planned,  ///< the diagnosis: the first of Diagnosis::next
    blind     ///< the seed: any of those that are possible
};

/// A diagnosis, and the run that was made before it.
struct Stage {
    std::string manoeuvre{};  ///< empty: the data set as it was drawn, or no further run was made
    double promised = 0.0;    ///< standard deviations by which it was to tell the explanations apart; 0: blind
    std::vector<std::string> told_apart{};
    Mark mark;
};

/// What a manoeuvre asks of the bench, at every sample of its log. @param interval s
[[nodiscard]] Drive drive_of(const tiretherm::input::Manoeuvre& manoeuvre, double interval);

/// Diagnoses a data set of two nodes, has its truth drive a manoeuvre, diagnoses all runs again, and so on. It ends when
/// one explanation is left, or no manoeuvre is proposed: later stages are as the last one.
/// @returns [most + 1]
[[nodiscard]] std::vector<Stage> diagnose_with_further_runs(ExamDataSet data_set, Choice choice, int most);

/// Shares by the number of further runs. @param stages [n_data_sets][most + 1]
[[nodiscard]] std::vector<Row> rows_of(const std::vector<std::vector<Stage>>& stages, Choice choice);
/// A line a stage: seed, truth, manoeuvre, set.
[[nodiscard]] std::string course_of(const std::vector<Stage>& stages);

}  // namespace hidden_effects
