// SPDX-License-Identifier: BSD-3-Clause
// Sections of a run's page that have a file each.
#pragma once

#include "post/run/run_report.hpp"

namespace tiretherm::post {

/// Watts at the end and kilojoules in all, effect by effect, their sum and what was stored; the energy closure.
[[nodiscard]] Section heat_budget_section(const RunRecord& run);

/// Mesh, steps, linear solver, wall time.
[[nodiscard]] Section cost_section(const RunRecord& run);

}  // namespace tiretherm::post
