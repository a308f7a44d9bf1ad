// SPDX-License-Identifier: BSD-3-Clause
// Puts the runs of a study's parts together.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "input/studies/study.hpp"
#include "post/study/study_journal.hpp"

namespace tiretherm::calls {

/// Takes the runs that the parts' folders inside a study's folder hold into the study's own journal.
/// @returns what keeps the study from being whole, a sentence each; empty when all runs are there
/// @errors FileError; StudyJournal::Busy while a part is under way
[[nodiscard]] std::vector<std::string> merge_parts(const input::Study& study, const std::filesystem::path& folder,
                                                   const std::string& build, post::StudyJournal& journal);

}  // namespace tiretherm::calls
