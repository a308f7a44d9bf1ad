#pragma once

#include <string>

#include "post/run/summary.hpp"

namespace tiretherm::post {

/// Watts at the end and kilojoules in all, effect by effect, their sum and what was stored; the energy closure.
/// @returns lines, each ended by a newline
[[nodiscard]] std::string heat_budget_text(const RunRecord& run);

/// Mesh, steps, linear solver, wall time. @returns lines, each ended by a newline
[[nodiscard]] std::string cost_text(const RunRecord& run);

}  // namespace tiretherm::post
