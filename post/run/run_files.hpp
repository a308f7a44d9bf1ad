// SPDX-License-Identifier: BSD-3-Clause
// The files of a run in one directory, in every format that was chosen.
#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "post/fields/output_format.hpp"
#include "post/hot_spot/hot_spots_report.hpp"
#include "post/page/field_chart.hpp"
#include "post/page/html_page.hpp"
#include "post/report/history.hpp"
#include "post/run/run_report.hpp"

namespace tiretherm::post {

/// The files of a run. They replace those of an earlier run there; other files are left alone.
class RunFiles {
public:
    /// Creates the directory and opens the files, so that whatever is wrong with them shows before the run.
    /// @param problem, provenance must outlive this
    /// @param switched names of formats that are refused although usual, or wanted although not; "report" refuses the files of the page
    /// @errors FileError
    RunFiles(std::filesystem::path directory, const solver::Problem& problem, const Provenance& provenance,
             const std::set<std::string>& switched);
    /// Names of all files that a run may leave in a folder, as many of a series as are there.
    [[nodiscard]] static std::vector<std::string> names_in(const std::filesystem::path& directory);
    RunFiles(const RunFiles&) = delete;
    RunFiles& operator=(const RunFiles&) = delete;

    /// @errors FileError
    void take(const solver::Snapshot& snapshot);
    /// Stores the field at the hottest step, completes the files and draws the pictures. @errors FileError
    void finish(const solver::MarchReport& report);

    /// The courses of the hot spots as hot_spots.csv. @errors FileError
    void write_hot_spots(const diagnosis::HotSpots& hot_spots);

    /// laps.csv and heat.csv of a run with laps, inputs.csv of a tire of a car, cornering_stiffness.csv where the case has
    /// one. @errors FileError
    void write_tables(const RunRecord& run);

    /// The files of the page, where they were not refused (--no-report). @errors FileError
    void write_page(const Report& report, const PageOrigin& origin);

    [[nodiscard]] const History& history() const { return history_; }
    [[nodiscard]] const FieldFrames& fields() const { return fields_; }
    /// All files written so far, by their use: results, channels, fields, pictures.
    [[nodiscard]] std::vector<std::filesystem::path> written() const;

private:
    std::filesystem::path directory_;
    const solver::Problem& problem_;
    bool with_page_;
    History history_;
    FieldFrames fields_;
    std::vector<std::unique_ptr<RunOutput>> outputs_;
    std::vector<std::filesystem::path> tables_;  ///< of hot spots and laps
    std::vector<std::filesystem::path> page_;
};

}  // namespace tiretherm::post
