// SPDX-License-Identifier: BSD-3-Clause
// A validation table as a report, as its file, and as Markdown.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/validation/validation_table.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// The verdict first, charts, then a line for each number beside those of the models, the figures of each model: over the numbers that all of them
/// give, then of one that gives more; and the inputs of the experiments with what they change. Keys of the data: title, numbers, summary, runs, seconds, energy_closure, warnings;
/// an open end of a measured range is null.
/// @param with_inputs the page has the inputs, too; the data always have them   @param files that were written
[[nodiscard]] Report validation_report(const diagnosis::ValidationRecord& record, bool with_inputs = false,
                                       const std::vector<std::filesystem::path>& files = {});
/// Names of the files that a validation leaves in a folder.
[[nodiscard]] std::vector<std::string> validation_names();
/// validation.json: all figures. @errors FileError   @returns its path
[[nodiscard]] std::vector<std::filesystem::path> write_validation(const diagnosis::ValidationRecord& record,
                                                                  const std::filesystem::path& directory);
/// The table and the figures under it for a README.
[[nodiscard]] std::string validation_markdown(const diagnosis::ValidationRecord& record);
/// All inputs with standing, value and range, and for each number what is known of its inputs and what they change.
[[nodiscard]] std::string validation_inputs_markdown(const diagnosis::ValidationRecord& record);

/// "within (0.7 u)", "3.1 u too hot", in total uncertainties; "holds" or "does not hold" of an open range; "not decidable
/// (ramp)" with the input that moves it most; "failed"; empty where nothing was measured.
[[nodiscard]] std::string verdict(const diagnosis::ValidationRow& row, std::size_t model);

}  // namespace tiretherm::post
