// SPDX-License-Identifier: BSD-3-Clause
// A study that has been run as a report.
#pragma once

#include <filesystem>
#include <vector>

#include "diagnosis/study/study_record.hpp"
#include "post/report/report.hpp"

namespace tiretherm::post {

/// What a call did for a study; the results do not depend on it.
struct StudyCall {
    std::size_t kept = 0;      ///< runs that an earlier call had made
    std::size_t outdated = 0;  ///< runs of another build of the program that were made again
    std::size_t damaged = 0;   ///< lines of the journal that could not be read
    double seconds = 0.0;      ///< wall time of the runs that were made now
    double run_seconds = 0.0;  ///< sum of their own times
    unsigned threads = 1;
    std::vector<std::filesystem::path> files;
};

/// A study's page: hottest temperatures over the grid, the chance of passing the critical one, what drives it, extremes,
/// runs that failed, cost, files. Its data: temperatures in degC. Keys: title, case, version, runs, kept, made, seconds,
/// threads, critical, failed, hottest and coldest run, points (of samples), warnings, outputs.
[[nodiscard]] Report study_report(const diagnosis::StudyRecord& study, const StudyCall& call);

}  // namespace tiretherm::post
