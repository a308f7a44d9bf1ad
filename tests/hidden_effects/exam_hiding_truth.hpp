#pragma once

#include "exam_paper_truth.hpp"

namespace hidden_effects {

/// Hides one cause of the catalogue in a paper, or two, as its kind says, at its size.
/// @returns false where this draw is given up: Paper::rejected says why
[[nodiscard]] bool hide_causes(Paper& paper, const Oracle& oracle, Random& random);

/// Hides heat that no effect of the catalogue explains, nor any one of them imitates. @returns like hide_causes
[[nodiscard]] bool hide_source(Paper& paper, Random& random);

}  // namespace hidden_effects
