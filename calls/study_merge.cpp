// SPDX-License-Identifier: BSD-3-Clause
// Reads the journals of part_K_of_N; runs that no part has are told by the part that should have made them.

#include "calls/study_merge.hpp"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "diagnosis/study/study_part.hpp"
#include "diagnosis/study/study_runs.hpp"

namespace tiretherm::calls {

namespace {

using diagnosis::StudyPart;

/// The parts that have a folder, in order.
std::set<StudyPart> parts_in(const std::filesystem::path& folder) {
    std::set<StudyPart> parts;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        if (const auto part = StudyPart::from_folder(entry.path().filename().string())) {
            parts.insert(*part);
        }
    }
    return parts;
}

}  // namespace

std::vector<std::string> merge_parts(const input::Study& study, const std::filesystem::path& folder,
                                     const std::string& build, post::StudyJournal& journal) {
    const std::set<StudyPart> parts = parts_in(folder);
    if (parts.empty()) {
        return {
            fmt::format("{} holds no part of the study (part_1_of_4 and the like); make the parts with --part, or copy "
                        "their folders there",
                        folder.string())};
    }
    std::vector<std::string> problems;
    std::set<std::size_t> counts;
    std::map<std::size_t, diagnosis::StudyOutcome>
        outcomes;  // noted in the order of the runs, whatever that of the parts
    for (const StudyPart& part : parts) {
        counts.insert(part.count);
        const std::filesystem::path file = folder / part.folder() / "runs.jsonl";
        if (!std::filesystem::exists(file)) {
            continue;  // its runs are missing below
        }
        const post::StudyJournal theirs(file, study.channels.size(), build, false);
        std::size_t found = 0;
        for (std::size_t run = 0; run < study.runs.size(); ++run) {
            if (const diagnosis::StudyOutcome* outcome = theirs.find(diagnosis::identity(study, run))) {
                ++found;
                outcomes.emplace(run, *outcome);
            }
        }
        if (theirs.outdated() > 0) {
            problems.push_back(
                fmt::format("part {}: {} runs are of another build of the program", part.text(), theirs.outdated()));
        } else if (found == 0 && part.size(study.runs.size()) > 0) {
            problems.push_back(
                fmt::format("part {}: none of its runs is of this study as its files are now", part.text()));
        }
    }
    for (const auto& [run, outcome] : outcomes) {
        if (const diagnosis::RunIdentity identity = diagnosis::identity(study, run);
            journal.find(identity) == nullptr) {
            journal.add(identity, outcome);
        }
    }
    std::vector<std::size_t> missing;
    for (std::size_t run = 0; run < study.runs.size(); ++run) {
        if (journal.find(diagnosis::identity(study, run)) == nullptr) {
            missing.push_back(run);
        }
    }
    if (missing.empty()) {
        return {};
    }
    if (counts.size() > 1) {
        problems.push_back(fmt::format("{} of {} runs are missing; the parts there are of divisions by {}",
                                       missing.size(), study.runs.size(), fmt::join(counts, " and by ")));
        return problems;
    }
    for (std::size_t k = 1; k <= *counts.begin(); ++k) {
        const StudyPart part{.index = k, .count = *counts.begin()};
        const auto lost = std::ranges::count_if(missing, [&](std::size_t run) { return part.has(run); });
        if (lost > 0) {
            problems.push_back(fmt::format("part {}: {} of {} runs are missing; --part {} makes them", part.text(),
                                           lost, part.size(study.runs.size()), part.text()));
        }
    }
    return problems;
}

}  // namespace tiretherm::calls
