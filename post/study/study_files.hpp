// SPDX-License-Identifier: BSD-3-Clause
// The folder of a study's results and the files in it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnosis/study/study_record.hpp"
#include "input/studies/study.hpp"
#include "post/report/output_folder.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// The folder of a study's results.
class StudyFiles {
public:
    /// @param folder must outlive this  @errors FileError
    explicit StudyFiles(OutputFolder& folder, bool page = true);

    /// Names of the files that a study leaves in a folder.
    [[nodiscard]] static std::vector<std::string> names();
    [[nodiscard]] std::filesystem::path journal() const { return folder_.path() / "runs.jsonl"; }
    /// Writes the tables and the page; those of an earlier study are replaced, all at once.
    /// @param report the page, of all files in their place; it is written, too, unless it is refused
    /// @errors FileError
    void write(const diagnosis::StudyRecord& study,
               const std::function<Report(const std::vector<std::filesystem::path>&)>& report) const;

private:
    OutputFolder& folder_;
    bool page_;
};

/// A study with its outcomes, as it is written and drawn. @param outcomes [runs]
[[nodiscard]] diagnosis::StudyRecord study_record(const input::Study& study,
                                                  std::vector<diagnosis::StudyOutcome> outcomes);

/// How many runs are made at a time. @param asked 0: as many as the machine has
[[nodiscard]] unsigned threads_used(unsigned asked, std::size_t runs);

}  // namespace tiretherm::post
