// SPDX-License-Identifier: BSD-3-Clause
// A run that is over as a report.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "post/hot_spot/hot_spots_report.hpp"
#include "post/page/field_chart.hpp"
#include "post/report/history.hpp"
#include "post/report/provenance.hpp"
#include "post/report/report.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// A run that is over, as the summary needs it.
struct RunRecord {
    const solver::Problem& problem;
    const solver::Report& report;
    const History& history;
    const FieldFrames* fields = nullptr;  ///< stored fields for the page; null: none
    Provenance provenance;
    double seconds = 0.0;                            ///< wall time of the whole run
    std::vector<std::string> warnings;               ///< of the reader; the report brings its own
    std::vector<std::filesystem::path> files;        ///< written
    const diagnosis::HotSpots* hot_spots = nullptr;  ///< null where the case asks for none
    std::string run{};                               ///< which of the case's measured runs; empty: it has none
    std::vector<std::string> runs{};                 ///< names of all of them
};

/// A run's page: temperatures beside measured values, hottest and coldest place, heat budget, cost, warnings, what to
/// cite, files. Its data: temperatures in degC, heat of the whole specimen in W and J. Keys: case, cells, steps,
/// factorisations, seconds, simulated_seconds, energy_closure, channels, budget, hottest, outputs, and more; hot_spots
/// where the case has critical temperatures.
[[nodiscard]] Report run_report(const RunRecord& run);

}  // namespace tiretherm::post
