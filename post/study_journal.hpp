#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "post/study_record.hpp"

namespace tiretherm::post {

/// What a run is told apart by: what it is made from, and for the human reader its varied values.
struct RunIdentity {
    std::string fingerprint;
    std::vector<std::string> values;  ///< "drive.speed = 80 km/h"

    friend auto operator<=>(const RunIdentity&, const RunIdentity&) = default;
};

/// The runs of a study that are done, a line of JSON each, written when they are: whatever ends the program, they stay. A
/// line that was cut off is dropped. Runs of another build of the program do not count: its results may differ.
class StudyJournal {
public:
    /// Opens the journal of a folder and keeps others from writing there meanwhile.
    /// @param build of the program   @param fresh forget what is done
    /// @errors FileError; StudyJournal::Busy when another call works in this folder
    StudyJournal(const std::filesystem::path& path, std::string build, bool fresh);
    ~StudyJournal();
    StudyJournal(const StudyJournal&) = delete;
    StudyJournal& operator=(const StudyJournal&) = delete;

    /// What a run came to, when it is done.
    [[nodiscard]] const StudyOutcome* find(const RunIdentity& run) const;
    /// Notes a run. @errors FileError
    void add(const RunIdentity& run, const StudyOutcome& outcome);
    /// Runs of another build that were found and left out.
    [[nodiscard]] std::size_t outdated() const { return outdated_; }

    class Busy : public std::runtime_error {
    public:
        using std::runtime_error::runtime_error;
    };

private:
    void read(const std::string& text);

    std::filesystem::path path_;
    std::string build_;
    std::map<RunIdentity, StudyOutcome> done_;
    std::size_t outdated_ = 0;
    struct Lines;  ///< the open file with its lock
    std::unique_ptr<Lines> lines_;
};

}  // namespace tiretherm::post
