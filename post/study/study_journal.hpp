// SPDX-License-Identifier: BSD-3-Clause
// Journal of a study's completed runs, one JSON line each, so that an interrupted study continues where it ended.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "diagnosis/study/study_runs.hpp"

namespace tiretherm::post {

/// The runs of a study that are done, a line of JSON each, written when they are: whatever ends the program, they stay. A
/// line that was cut off or damaged is dropped, and its run is made again. Runs of another build of the program do not
/// count: its results may differ.
class StudyJournal final : public diagnosis::CompletedRuns {
public:
    /// Opens the journal of a folder and keeps others from writing there meanwhile.
    /// @param channels of each run   @param build of the program   @param fresh forget what is done
    /// @errors FileError, also where a file of that name holds something else; StudyJournal::Busy when another call works in this folder
    StudyJournal(const std::filesystem::path& path, std::size_t channels, std::string build, bool fresh);
    ~StudyJournal() override;
    StudyJournal(const StudyJournal&) = delete;
    StudyJournal& operator=(const StudyJournal&) = delete;

    /// What a run came to, when it is done.
    [[nodiscard]] const diagnosis::StudyOutcome* find(const diagnosis::RunIdentity& run) const override;
    /// Notes a run. @errors FileError
    void add(const diagnosis::RunIdentity& run, const diagnosis::StudyOutcome& outcome) override;
    /// Runs of another build that were found and left out.
    [[nodiscard]] std::size_t outdated() const { return outdated_; }
    /// Lines that were none of ours, or damaged.
    [[nodiscard]] std::size_t damaged() const { return damaged_; }

    class Busy : public std::runtime_error {
    public:
        using std::runtime_error::runtime_error;
    };

private:
    /// @returns the lines that are damaged or none of ours
    [[nodiscard]] std::vector<std::string_view> read(std::string_view text);
    [[nodiscard]] bool take(std::string_view line);  ///< false: damaged

    std::filesystem::path path_;
    std::size_t channels_;
    std::string build_;
    std::map<diagnosis::RunIdentity, diagnosis::StudyOutcome> done_;
    std::size_t outdated_ = 0;
    std::size_t damaged_ = 0;
    struct Lines;  ///< the open file with its lock
    std::unique_ptr<Lines> lines_;
};

}  // namespace tiretherm::post
