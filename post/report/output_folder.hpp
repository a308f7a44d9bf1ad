// SPDX-License-Identifier: BSD-3-Clause
// The folder that a command writes its files to: locked while the command works, files written to a stage inside and
// moved into place together at the end.
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace tiretherm::post {

/// Why a folder cannot be written to: another call works there, or an output would replace a file that the case reads.
class OutputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A folder of results. Opening it takes a lock; files are written to `stage()`, and `commit` moves them into place
/// together. Whatever ends the program before, the files of an earlier call stay as they are: a `commit` that was begun
/// is finished by the next call, unless its list was written for another folder or names a file that this call reads;
/// anything else in the stage is thrown away. Other files in the folder are left alone, and
/// a link in the place of a file is replaced, never written through.
///
/// All of it lives in the hidden folder `.tiretherm` inside, which is gone when the call has ended regularly and no other,
/// interrupted one has left a journal.
class OutputFolder {
public:
    /// Creates the folder with those above it, locks it and finishes what an earlier call has left half done.
    /// @param inputs files that the call reads: none of them is ever replaced
    /// @errors FileError; OutputError when another call works there, or a list of moves is somebody else's
    explicit OutputFolder(std::filesystem::path folder, std::vector<std::string> inputs = {});
    /// Removes the stage and, unless `keep_journals`, the journals of this call; those of others stay.
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return folder_; }
    /// Files that the call reads.
    [[nodiscard]] const std::vector<std::string>& inputs() const { return inputs_; }
    /// Where files are written before `commit`.
    [[nodiscard]] const std::filesystem::path& stage() const { return stage_; }
    /// A file beside the stage, which the next call finds when this one is killed; gone at the end of this one.
    [[nodiscard]] std::filesystem::path journal(const std::string& name);
    /// Whether a journal of this call holds anything.
    [[nodiscard]] bool has_journal() const;
    /// Where a file of the stage will stand.
    [[nodiscard]] std::filesystem::path home(const std::filesystem::path& staged) const;
    [[nodiscard]] std::vector<std::filesystem::path> homes(const std::vector<std::filesystem::path>& staged) const;
    /// A message about a file of the stage as one about the file in its place.
    [[nodiscard]] std::string in_place(std::string message) const;

    /// Refuses names of outputs that are files of the inputs, by whatever link or path. @errors OutputError
    void refuse_inputs(std::span<const std::string> names) const;

    /// Moves all files of the stage into place, those of an earlier call replaced.
    /// @param stale names of files of an earlier result that this one does away with
    /// @errors FileError; OutputError when an input would be replaced: then nothing has changed
    void commit(std::vector<std::string> stale = {});

    /// Journals stay for the next call.
    void keep_journals() { keep_journals_ = true; }

private:
    void lock();
    [[nodiscard]] bool try_lock();
    void roll_forward() const;
    void clear() const noexcept;

    std::filesystem::path folder_;
    std::filesystem::path hidden_;
    std::filesystem::path stage_;
    std::vector<std::string> inputs_;
    std::vector<std::string> journals_;
    bool created_ = false;  ///< the folder was not there before
    bool keep_journals_ = false;
    int lock_ = -1;
};

}  // namespace tiretherm::post
