// SPDX-License-Identifier: BSD-3-Clause
// A run that is over as a report.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "diagnosis/study/what_if.hpp"
#include "input/laps/laps.hpp"
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
    const solver::MarchReport& report;
    const History& history;
    const FieldFrames* fields = nullptr;  ///< stored fields for the page; null: none
    Provenance provenance;
    double seconds = 0.0;                            ///< wall time of the whole run
    std::vector<std::string> warnings;               ///< of the reader; the report brings its own
    std::vector<std::filesystem::path> files;        ///< written
    const diagnosis::HotSpots* hot_spots = nullptr;  ///< null where the case asks for none
    std::string run{};                               ///< which of the case's measured runs; empty: it has none
    std::vector<std::string> runs{};                 ///< names of all of them
    std::string corner{};                            ///< FL, FR, RL or RR; empty: the case has no [[corner]]
    std::vector<input::Lap> laps{};                  ///< of its log
    const diagnosis::WhatIf* what_if = nullptr;      ///< null where nothing was changed
};

/// A run's page: temperatures beside measured values, hottest and coldest place, heat budget, cost, warnings, what to
/// cite, files. Its data: temperatures in degC, heat of the whole specimen in W and J. Keys: case, cells, steps,
/// factorisations, seconds, simulated_seconds, energy_closure, channels, budget, hottest, outputs, and more; hot_spots
/// where the case has critical temperatures.
[[nodiscard]] Report run_report(const RunRecord& run);

/// The tires of a car on one page: sensors, laps, friction power and heat beside each other. Its data: `corners` has that
/// of each tire's own page. @param runs of one recording, a run for each corner  @param warnings of the reader
/// @param what_if null where nothing was changed
[[nodiscard]] Report car_report(std::span<const RunRecord> runs, const diagnosis::WhatIf* what_if,
                                std::vector<std::string> warnings, const std::vector<std::filesystem::path>& files);
/// channels.csv with a column for each sensor of each tire, laps.csv and heat.csv. Runs whose rows stand at other times are
/// straight lines between their rows. @errors FileError  @returns their paths
[[nodiscard]] std::vector<std::filesystem::path> write_car_tables(const std::filesystem::path& directory,
                                                                  std::span<const RunRecord> runs);

}  // namespace tiretherm::post
