// SPDX-License-Identifier: BSD-3-Clause
// The summary of a study, as text for people and as JSON for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnosis/study/study_record.hpp"

namespace tiretherm::post {

/// What a call did for a study; the results do not depend on it.
struct StudyCall {
    std::size_t kept = 0;      ///< runs that an earlier call had made
    std::size_t outdated = 0;  ///< runs of another build of the program that were made again
    double seconds = 0.0;      ///< wall time of the runs that were made now
    double run_seconds = 0.0;  ///< sum of their own times
    unsigned threads = 1;
    std::vector<std::filesystem::path> files;
};

/// The summary of a study on a terminal: hottest temperatures over the grid, the chance of passing the critical one, runs
/// that failed.   @param bold headings
[[nodiscard]] std::string study_text(const diagnosis::StudyRecord& study, const StudyCall& call, bool bold);

/// The same as one JSON object.
[[nodiscard]] std::string study_json(const diagnosis::StudyRecord& study, const StudyCall& call);

}  // namespace tiretherm::post
