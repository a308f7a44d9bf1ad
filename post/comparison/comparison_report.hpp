// SPDX-License-Identifier: BSD-3-Clause
// A comparison of measured with simulated as a report, and its files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/compare/comparison.hpp"
#include "post/laps/computed_inputs.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// "simulated 1.9 +- 0.3 K too hot on the whole; ..." The channel in sentences.
[[nodiscard]] std::vector<std::string> sentences(const diagnosis::ComparedChannel& channel);
/// A page for a thermal engineer, and all figures. @param files that were written
[[nodiscard]] Report comparison_report(const diagnosis::Comparison& comparison,
                                       const std::vector<std::filesystem::path>& files);
/// Names of the files that a comparison leaves in a folder.
[[nodiscard]] std::vector<std::string> comparison_names();
/// compare.csv: a row for each sample. compare_statistics.csv: a row for each channel, run, phase and bin. Of cameras
/// compare_pixels.csv, a row for each pixel of each run.
/// @errors FileError  @returns their paths
[[nodiscard]] std::vector<std::filesystem::path> write_comparison(const diagnosis::Comparison& comparison,
                                                                  const std::vector<DrivenRun>& driven,
                                                                  const std::filesystem::path& directory);

/// Tables and sentences of all cameras. @param runs names  @param data of each camera, to be filled
[[nodiscard]] ReportSection cameras_section(const std::vector<diagnosis::ComparedImages>& images,
                                            const std::vector<std::string>& runs, Value& data);

}  // namespace tiretherm::post
