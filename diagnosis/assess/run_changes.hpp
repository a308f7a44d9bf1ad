// SPDX-License-Identifier: BSD-3-Clause
// Numbers that are others in one run than in the rest, or that change from run to run: another compound, pressure or wear, an
// instrument that was replaced.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/detect/score_test_data.hpp"
#include "diagnosis/fit/linearised_model.hpp"

namespace tiretherm::diagnosis {

/// A free number of the case, or the number of a cause that only some runs have, with values of its own in some runs.
struct RunChange {
    std::size_t number = 0;                ///< index into Experiment::parameters
    std::optional<Candidate> candidate{};  ///< instead of a number of the case
    std::vector<std::size_t> runs{};       ///< with values of their own
    bool is_trend = false;                 ///< from run to run; the last run has the value that the case goes on with

    /// "strain_energy_loss.tan_delta_a", "sensor_offset of bulk_temperature"
    [[nodiscard]] std::string name(const input::Experiment& experiment) const;
};

/// A change as a column of the linearised model.
struct RunColumn {
    RunChange change;
    Eigen::VectorXd raw;  ///< [n_rows] SI per unit (of a number of the case: of its scale in the fit)
    double size = 0.0;    ///< least change, in that unit, that is worth a word
};

/// Every change that is looked for: of each shared number of the case, of each sensor and of the tread's wear, in each run and from
/// run to run. Empty with one run, or where several runs are of one car.
[[nodiscard]] std::vector<RunColumn> run_columns(const ScoreTestData& score_data);

/// Standard deviations of a change from none, beside all numbers of a model: its scatter is that between blocks of time within the
/// runs (White 1980; Liang and Zeger 1986), and its Student's t is turned into a normal number
/// (Wallace, Ann. Math. Statist. 30 (1959) 1124).
struct RunChangeTest {
    double amplitude = 0.0;  ///< in the unit of the column
    double z = 0.0;
};
/// @param white [n_rows][m] whitened columns
[[nodiscard]] std::vector<RunChangeTest> test_run_changes(const LinearisedModel& model, const Eigen::MatrixXd& white,
                                                          const Observations& observations);

/// From how many standard deviations on the largest of some changes is beyond chance: twice in a thousand times at most.
[[nodiscard]] double least_of_run_changes(std::size_t n);

/// Changes of runs that are beyond the scatter within the runs, of a size that matters, and by which blocks of all runs that were left out
/// are predicted better than by any cause that all runs have; of three runs and more the other runs have to be predicted better
/// without what that run says of the number, too. From the linearised model alone: nothing is simulated.
[[nodiscard]] std::vector<RunChange> find_run_changes(const ScoreTestData& score_data);

/// The experiment with a free number more for each run that has a value of its own, after all others.
[[nodiscard]] input::Experiment with_run_changes(input::Experiment experiment, const std::vector<RunChange>& changes);
/// The same without them: what the other runs have, for a new run. @param values in, out: [n_parameters]
[[nodiscard]] input::Experiment without_run_changes(input::Experiment experiment, const input::Experiment& original,
                                                    const std::vector<RunChange>& changes, Eigen::VectorXd& values);

struct DiagnosisState;
/// Looks for changes of runs. Where there are any, all that follows is beside them, on the other meshes, too.
/// @returns the options with those meshes
[[nodiscard]] DiagnosisOptions take_run_changes(DiagnosisState& state, const DiagnosisOptions& choice);
/// Adds them to what was found: as causes of every hypothesis, with a remark each, and the case without them as the one to go on with.
void report_run_changes(const DiagnosisState& state, Diagnosis& into);

}  // namespace tiretherm::diagnosis
