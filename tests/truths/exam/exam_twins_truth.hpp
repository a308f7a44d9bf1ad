#pragma once

#include <optional>

#include "exam/exam_paper_truth.hpp"

namespace hidden_effects {

/// The explanation that comes nearest to what a paper hides without being it: one cause of the catalogue, or two, with
/// physical signs and at the sizes that suit it best. What it misses is what data can hold against it: on average half its
/// square in log likelihood, with a standard deviation of itself.
/// @returns nothing where no cause shows
[[nodiscard]] std::optional<Twin> nearest_twin(const Paper& paper);

}  // namespace hidden_effects
