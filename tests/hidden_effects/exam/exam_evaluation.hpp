// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the diagnosis on simulated data sets with hidden effects: draws, diagnoses and marks each of them.
#pragma once

#include <functional>
#include <vector>

#include "hidden_effects/exam/exam_marks.hpp"
#include "input/measurements/experiment.hpp"

namespace hidden_effects {

/// A data set to be drawn.
struct DataSetSpec {
    Kind kind = Kind::nothing;
    double sigma = 10.0;
    std::uint64_t seed = 0;
    const Rig* rig = &two_node_rig();
};

/// `count` specs of consecutive seeds.
void add_specs(std::vector<DataSetSpec>& specs, Kind kind, double sigma, std::uint64_t first_seed, int count,
               const Rig& rig = two_node_rig());

/// What the program reads of a data set: the bench's case with the data set's logs. @param finer as of
/// input::read_experiment
[[nodiscard]] tiretherm::input::Experiment read_data_set(const ExamDataSet& data_set, int finer = 1);

/// The diagnosis of a data set as `tiretherm diagnose` makes it: a grid is compared with one of half the spacing.
[[nodiscard]] tiretherm::diagnosis::Diagnosis diagnose_data_set(const ExamDataSet& data_set,
                                                                tiretherm::diagnosis::DiagnosisOptions choice = {});

/// Draws every data set, diagnoses it and marks it. A data set that throws is marked as failed, with the reason as its
/// verdict.
/// @param threads data sets at a time; each diagnosis has threads of its own over its runs
/// @param interval s, of the samples; 0: each bench's own  @param on_marked called after each data set, one at a time
[[nodiscard]] std::vector<Mark> evaluate(const std::vector<DataSetSpec>& specs, int threads = 1, double interval = 0.0,
                                         const std::function<void(const Mark&)>& on_marked = {});

}  // namespace hidden_effects
