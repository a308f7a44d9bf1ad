// SPDX-License-Identifier: BSD-3-Clause
// Hides causes or unknown heat sources in a data set at a given size in standard deviations.
#pragma once

#include "exam/exam_data_set_truth.hpp"

namespace hidden_effects {

/// Hides one cause of the catalogue in a data set, or two, as its kind says, at its size.
/// Takes data set.oracle_of_runs. @returns false where this draw is given up: ExamDataSet::rejected says why
[[nodiscard]] bool hide_causes(ExamDataSet& data_set, Random& random);

/// Hides heat that no effect of the catalogue explains, nor any one of them imitates. @returns like hide_causes
[[nodiscard]] bool hide_source(ExamDataSet& data_set, Random& random);

/// What a cause leaves behind in a data set's runs, a step from absent, with the critical speed of the hidden wave.
[[nodiscard]] Eigen::VectorXd left_beside(const ExamDataSet& data_set, const Variant& variant, double step);

/// How like what is hidden in a data set one cause is: at the size at which it shows as well or as large as it can be,
/// or on a costly bench at its typical size, for causes are nearly linear.
[[nodiscard]] Likeness likeness(const ExamDataSet& data_set, const Variant& variant);

}  // namespace hidden_effects
