#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cases/study.hpp"
#include "post/study_journal.hpp"

namespace tiretherm::app {

/// The runs of a study, made or taken from its journal.
struct StudyResults {
    std::vector<post::StudyOutcome> outcomes;  ///< [runs]; of a run that was not made, empty
    std::size_t kept = 0;
    std::size_t done = 0;               ///< kept or made
    double run_seconds = 0.0;           ///< of those that were made, summed
    std::vector<std::string> warnings;  ///< of the runs that were made, each once
    std::string error;                  ///< why not all could be made; empty otherwise
};

/// What a run of a study is made from, as its journal knows it.
[[nodiscard]] post::RunIdentity identity(const cases::Study& study, std::size_t run);

/// Makes the runs that the journal does not know, several at a time, each noted as soon as it is done. Their results do
/// not depend on how many are made at a time. Ends early where the user asks for it, or where a run cannot be noted.
/// @param threads 0: as many as the machine has   @param progress called with the number that are done
[[nodiscard]] StudyResults run_study(const cases::Study& study, post::StudyJournal& journal, unsigned threads,
                                     const std::function<void(std::size_t done)>& progress);

}  // namespace tiretherm::app
