// SPDX-License-Identifier: BSD-3-Clause
// A run that `tiretherm run` makes into a folder: one tire's, or one of the tires of a car.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "calls/caller.hpp"
#include "diagnosis/study/what_if.hpp"
#include "input/runs/reader.hpp"
#include "input/studies/what_if.hpp"
#include "post/page/field_chart.hpp"
#include "post/report/history.hpp"
#include "post/report/output_folder.hpp"
#include "post/run/run_files.hpp"
#include "post/run/run_report.hpp"

namespace tiretherm::calls {

struct RunOptions {
    std::string case_file;
    std::string run;  ///< of the case's [[run]] tables; empty: the first
    std::string directory;
    double field_interval = 0.0;  ///< s; 0: as the case says
    bool in_memory = false;       ///< no folder and no files
    bool fresh = false;
    bool what_if = false;              ///< the standard changes
    std::vector<std::string> changes;  ///< "drive.camber=+0.5 deg"
    std::set<std::string> switched;    ///< formats that are refused or wanted, by name
    std::map<std::string, std::shared_ptr<const physics::OwnLaw>> laws{};  ///< of the case's [[source]] tables, by name
};

/// Rows of a run without files.
struct KeptRows {
    explicit KeptRows(const solver::Problem& problem) : fields(problem) {}

    post::History history{};
    post::FieldFrames fields;
};

/// A run with its files and what its page needs.
struct SimulatedRun {
    input::RunOfCase run;
    post::Provenance provenance{};
    std::unique_ptr<post::OutputFolder> folder{};
    std::optional<post::RunFiles> files{};
    std::optional<KeptRows> rows{};  ///< in the place of files
    solver::MarchReport report{};
    double seconds = 0.0;
    std::optional<diagnosis::HotSpots> hot_spots{};
    std::optional<diagnosis::WhatIf> what_if{};
    post::Report page{};

    /// @param reading of the case
    [[nodiscard]] post::RunRecord record(const input::Reading& reading) const;
};

/// Foot of the page of a run.
[[nodiscard]] post::PageOrigin page_origin(const input::Reading& reading, const RunOptions& options);

/// Simulates one run into a folder of its own, or in memory. @param changes to be tried besides, of a case with one tire
/// @returns whether its files could be written; says why not
[[nodiscard]] bool simulate(SimulatedRun& it, const std::filesystem::path& directory, const input::Reading& reading,
                            const std::vector<input::ChangedRuns>& changes, const RunOptions& options, Caller& caller);

}  // namespace tiretherm::calls
