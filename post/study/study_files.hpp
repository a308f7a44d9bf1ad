// SPDX-License-Identifier: BSD-3-Clause
// The folder of a study's results and the files in it.
#pragma once

#include <filesystem>
#include <vector>

#include "diagnosis/study/study_record.hpp"
#include "input/studies/study.hpp"

namespace tiretherm::post {

/// The folder of a study's results.
class StudyFiles {
public:
    /// Creates the folder. @errors FileError
    StudyFiles(std::filesystem::path directory, bool pictures);

    [[nodiscard]] std::filesystem::path journal() const { return directory_ / "runs.jsonl"; }
    /// Takes away the tables and the picture of an earlier study, which the runs that follow would belie.
    void remove_old() const;
    /// Writes the tables and the picture; those of an earlier study are replaced.
    /// @returns what was written   @errors FileError
    std::vector<std::filesystem::path> write(const diagnosis::StudyRecord& study) const;

private:
    std::filesystem::path directory_;
    bool pictures_;
};

/// A study with its outcomes, as it is written and drawn. @param outcomes [runs]
[[nodiscard]] diagnosis::StudyRecord study_record(const input::Study& study,
                                                  std::vector<diagnosis::StudyOutcome> outcomes);

/// How many runs are made at a time. @param asked 0: as many as the machine has
[[nodiscard]] unsigned threads_used(unsigned asked, std::size_t runs);

}  // namespace tiretherm::post
