// SPDX-License-Identifier: BSD-3-Clause
// A diagnosis of quoted numbers as a report and as its file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/quoted/quoted_diagnosis.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// What was asked and what came of it.
struct QuotedRecord {
    const diagnosis::quoted::QuotedDiagnosis& result;
    std::string title;
    std::filesystem::path table;
    std::string model;  ///< "two nodes"
    double seconds = 0.0;
    std::vector<std::string> warnings;
};

/// Sentences first, then the additions, the rows and what a measurement would settle.
/// @param files that were written
[[nodiscard]] Report quoted_report(const QuotedRecord& record, const std::vector<std::filesystem::path>& files);
/// The verdict in sentences for an engineer who does not know the method.
[[nodiscard]] std::vector<std::string> quoted_sentences(const QuotedRecord& record);
/// The tables of a page of the documentation: the additions, then the rows.
[[nodiscard]] std::string quoted_markdown(const QuotedRecord& record);
/// Names of the files that such a diagnosis leaves in a folder.
[[nodiscard]] std::vector<std::string> quoted_names();
/// diagnosis.json. @errors FileError  @returns its path
[[nodiscard]] std::vector<std::filesystem::path> write_quoted(const QuotedRecord& record,
                                                              const std::filesystem::path& directory);

}  // namespace tiretherm::post
