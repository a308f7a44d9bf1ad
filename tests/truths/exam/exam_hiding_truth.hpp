#pragma once

#include "exam/exam_paper_truth.hpp"

namespace hidden_effects {

/// Hides one cause of the catalogue in a paper, or two, as its kind says, at its size.
/// Takes paper.oracle_of_runs. @returns false where this draw is given up: Paper::rejected says why
[[nodiscard]] bool hide_causes(Paper& paper, Random& random);

/// Hides heat that no effect of the catalogue explains, nor any one of them imitates. @returns like hide_causes
[[nodiscard]] bool hide_source(Paper& paper, Random& random);

/// What a cause leaves behind in a paper's runs, a step from absent, with the critical speed of the hidden wave.
[[nodiscard]] Eigen::VectorXd left_beside(const Paper& paper, const Variant& variant, double step);

/// How like what is hidden in a paper one cause is: at the size at which it shows as well or as large as it can be, or on
/// a costly bench at its typical size, for causes are nearly linear.
[[nodiscard]] Likeness likeness(const Paper& paper, const Variant& variant);

}  // namespace hidden_effects
