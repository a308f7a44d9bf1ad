// SPDX-License-Identifier: BSD-3-Clause
// A diagnosis as a report and its files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/assess/diagnosis.hpp"
#include "diagnosis/by_run/run_verdicts.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// What was asked, of which data, and what came of it: all that a report needs.
struct DiagnosisRecord {
    const input::Experiment& experiment;
    const diagnosis::Observations& observations;
    const diagnosis::Diagnosis& result;
    std::filesystem::path case_file;
    std::vector<std::filesystem::path> data;  ///< runs that were given beside the case
    std::vector<std::string> warnings;
    std::vector<std::string> findings;
    diagnosis::RunVerdicts by_run{};    ///< of several runs
    bool with_page = false;             ///< report.html and page.txt are written
    std::vector<std::string> inputs{};  ///< files that were read, for the foot of the page
};

/// A page for a thermal engineer, and all figures. @param files that were written
[[nodiscard]] Report diagnosis_report(const DiagnosisRecord& record, const std::vector<std::filesystem::path>& files);
/// Names of the files that a diagnosis leaves in a folder.
[[nodiscard]] std::vector<std::string> diagnosis_names();
/// extended.toml, where there is something to add: the case with the cause switched on at its fitted value.
/// residuals.csv: a row for each sample. missing_heat.csv: the missing heat, a row for each window and place.
/// diagnosis.json: all figures. report.html and page.txt, where they are wanted: the page.
/// A sentence is added to the record's warnings where the extended case cannot be run.
/// @param home where they will stand, if elsewhere: paths in them lead from there
/// @errors FileError  @returns their paths
[[nodiscard]] std::vector<std::filesystem::path> write_diagnosis(DiagnosisRecord& record,
                                                                 const std::filesystem::path& directory,
                                                                 const std::filesystem::path& home = {});

}  // namespace tiretherm::post
