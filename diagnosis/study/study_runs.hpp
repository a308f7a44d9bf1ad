// SPDX-License-Identifier: BSD-3-Clause
// Execution of a study: makes the runs that are not stored yet and returns the outcomes in order, independent of the
// number of threads.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/study/study_part.hpp"
#include "diagnosis/study/study_record.hpp"
#include "input/studies/study.hpp"

namespace tiretherm::diagnosis {

/// What a run is distinguished by: what it is made from, and for the human reader its varied values.
struct RunIdentity {
    std::string fingerprint;
    std::vector<std::string> values;  ///< "drive.speed = 80 km/h"

    friend auto operator<=>(const RunIdentity&, const RunIdentity&) = default;
};

/// Runs that are done already, and where those to come are kept. Its owner sees to it that what it gives back is what
/// the program of today would compute.
class CompletedRuns {
public:
    CompletedRuns() = default;
    CompletedRuns(const CompletedRuns&) = delete;
    CompletedRuns& operator=(const CompletedRuns&) = delete;
    virtual ~CompletedRuns() = default;

    /// What a run came to, null when it is not done.
    [[nodiscard]] virtual const StudyOutcome* find(const RunIdentity& run) const = 0;
    /// Keeps a run. @errors any exception: the study then ends with its text
    virtual void add(const RunIdentity& run, const StudyOutcome& outcome) = 0;
};

/// The runs of a study, made or taken from its journal.
struct StudyResults {
    std::vector<StudyOutcome> outcomes;  ///< [runs]; of a run that was not made, empty
    std::size_t kept = 0;
    std::size_t done = 0;      ///< kept or made
    double run_seconds = 0.0;  ///< of those that were made, summed
    std::string error;         ///< why not all could be made; empty otherwise
};

/// What a run of a study is made from, as its journal knows it.
[[nodiscard]] RunIdentity identity(const input::Study& study, std::size_t run);

/// Makes the runs that the journal does not know, several at a time, each noted as soon as it is done. Their results do
/// not depend on how many are made at a time. Ends early where the user asks for it, or where a run cannot be noted.
/// @param threads 0: as many as the machine has   @param progress called with the number that are done
/// @param part the runs that this call is for; the others are neither made nor counted
[[nodiscard]] StudyResults run_study(const input::Study& study, CompletedRuns& journal, unsigned threads,
                                     const std::function<void(std::size_t done)>& progress, const StudyPart& part = {});

}  // namespace tiretherm::diagnosis
