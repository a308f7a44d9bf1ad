// SPDX-License-Identifier: BSD-3-Clause
// A fit of a case's parameters to measured runs as a report, and its files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/fit/identification.hpp"
#include "input/measurements/experiment.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// What was fitted, to what, and what came of it: all that a report needs.
struct IdentificationRecord {
    const input::Experiment& experiment;
    const diagnosis::Observations& observations;
    const diagnosis::Identification& result;
    std::filesystem::path case_file;
    std::vector<std::filesystem::path> data;  ///< runs that were given beside the case
    std::vector<std::string> warnings;
    std::vector<std::string> findings;
    bool planned = false;  ///< nothing was measured: the intervals are predicted
};

/// A page for a thermal engineer, and all figures. @param files that were written
[[nodiscard]] Report identification_report(const IdentificationRecord& record,
                                           const std::vector<std::filesystem::path>& files);
/// Names of the files that a fit leaves in a folder.
[[nodiscard]] std::vector<std::string> identification_names();
/// The same of a plan.
[[nodiscard]] std::vector<std::string> plan_names();
/// identified.toml: the case with the fitted values, which runs as it is. identify.csv: a row for each sample. parameters.csv: a
/// row for each parameter. laws.csv, where a law was fitted: a row for each temperature. Of a plan plan.json. @param home where they will stand, if elsewhere: paths in them lead from there
/// @errors FileError  @returns their paths
[[nodiscard]] std::vector<std::filesystem::path> write_identification(const IdentificationRecord& record,
                                                                      const std::filesystem::path& directory,
                                                                      const std::filesystem::path& home = {});

/// A direction as a sentence: "laser.absorptivity +0.031 with K1.conductivity at 90 degC +0.02 W/(m K)", its largest
/// parts.
[[nodiscard]] std::string describe(const diagnosis::Direction& direction, const input::Experiment& experiment,
                                   const Eigen::VectorXd& values);

}  // namespace tiretherm::post
