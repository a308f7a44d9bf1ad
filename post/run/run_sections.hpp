// SPDX-License-Identifier: BSD-3-Clause
// Sections of a run's page that have a file each.
#pragma once

#include "post/run/run_report.hpp"

namespace tiretherm::post {

/// Watts at the end and kilojoules in all, effect by effect, their sum and what was stored; the energy closure.
[[nodiscard]] Section heat_budget_section(const RunRecord& run);

/// The channels against time, quantity by quantity, measured values beside them, the inputs below and steps as bands; hot
/// spots with the moments at which they pass their critical temperatures.
void add_channel_charts(Section& section, const RunRecord& run);

/// Watts of each effect at every row, and their sum. Nothing for a steady state.
void add_heat_course(Section& section, const RunRecord& run);

/// The heat of each effect as bars.
void add_heat_charts(Section& section, const RunRecord& run);

/// Mesh, steps, linear solver, wall time.
[[nodiscard]] Section cost_section(const RunRecord& run);

}  // namespace tiretherm::post
