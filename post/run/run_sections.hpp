// SPDX-License-Identifier: BSD-3-Clause
// Sections of a run's page that have a file each.
#pragma once

#include <optional>
#include <string>

#include "diagnosis/compare/stretch.hpp"
#include "diagnosis/study/what_if.hpp"
#include "post/laps/lap_rows.hpp"
#include "post/run/run_report.hpp"

namespace tiretherm::post {

/// Final, lowest and highest reading of each sensor beside measured values. @param data gets `channels` and `measured`
[[nodiscard]] DataTable readings(const RunRecord& run, Value& data);

/// Watts at the end and kilojoules in all, effect by effect, their sum and what was stored; the energy closure.
[[nodiscard]] ReportSection heat_budget_section(const RunRecord& run);

/// The channels against time, quantity by quantity, measured values beside them, the inputs below and laps or steps as bands;
/// hot spots with the moments at which they pass their critical temperatures. Of several tires all in one chart, without
/// inputs and hot spots.
void add_channel_charts(ReportSection& section, std::span<const RunRecord> runs);

/// Each channel in each lap as far as the run came, then over the whole run. By time, between the rows of output.
[[nodiscard]] std::vector<LapRow> lap_rows(const RunRecord& run);
/// What went into the tire up to each row, and the friction power.
[[nodiscard]] diagnosis::RunHeat heat_of(const RunRecord& run);

/// Watts of each effect at every row, and their sum. Nothing for a steady state.
void add_heat_course(ReportSection& section, const RunRecord& run);

/// The heat of each effect as bars.
void add_heat_charts(ReportSection& section, const RunRecord& run);

/// What changes of single values do: a row for each change and tire, and which values move nothing.
[[nodiscard]] ReportSection what_if_section(const diagnosis::WhatIf& what_if,
                                            const std::vector<solver::Channel>& channels);
[[nodiscard]] Value what_if_data(const diagnosis::WhatIf& what_if, const std::vector<solver::Channel>& channels);

/// The hot spot that is nearest to its critical temperature, or furthest beyond it.
struct NearestSpot {
    double below = 0.0;   ///< K, of its peak, in the mean over what is uncertain; negative beyond
    std::string verdict;  ///< "belt edge stays 3.0 K below its critical 120 degC", without a full stop
};
[[nodiscard]] std::optional<NearestSpot> nearest_spot(const RunRecord& run);

/// Mesh, steps, linear solver, wall time.
[[nodiscard]] ReportSection cost_section(const RunRecord& run);

}  // namespace tiretherm::post
