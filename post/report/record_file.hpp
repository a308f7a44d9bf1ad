// SPDX-License-Identifier: BSD-3-Clause
// A binary file of records of numbers that only grows: what a process that was killed has kept, bit by bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solver/digest.hpp"

namespace tiretherm::post {

/// Records of numbers, each with a checksum, behind the identity of what they belong to. A record that was cut off or
/// damaged ends the file; records of another identity are forgotten.
class RecordFile {
public:
    /// @param identity of the call: program, files that it reads, options  @errors FileError
    RecordFile(std::filesystem::path path, const solver::Digest::Value& identity);
    ~RecordFile();
    RecordFile(const RecordFile&) = delete;
    RecordFile& operator=(const RecordFile&) = delete;

    [[nodiscard]] std::size_t size() const { return records_.size(); }  ///< records
    /// Numbers of a record.
    [[nodiscard]] std::size_t count(std::size_t record) const { return records_[record].count; }
    /// Bytes found behind the last whole record, cut off or damaged; none of a file of another identity.
    [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
    [[nodiscard]] std::uint64_t bytes() const { return end_; }
    /// @errors FileError
    [[nodiscard]] std::vector<double> read(std::size_t record) const;
    /// Forgets all records from this one on. @errors FileError
    void truncate(std::size_t records);
    /// Adds a record; several parts follow one another. Whatever ends the program, all of it is there or nothing.
    /// @errors FileError
    void append(std::initializer_list<std::span<const double>> parts);
    void append(std::span<const double> numbers) { append({numbers}); }

private:
    struct Place {
        std::uint64_t at = 0;  ///< of the numbers, bytes
        std::size_t count = 0;
    };
    void find_records();
    [[noreturn]] void fail(const char* doing) const;

    std::filesystem::path path_;
    solver::Digest::Value identity_;
    int file_ = -1;
    std::uint64_t end_ = 0;
    std::uint64_t dropped_ = 0;
    std::vector<Place> records_;
};

/// Seconds between two checkpoints, and before the first: 2, or what TIRETHERM_CHECKPOINT_SECONDS says.
[[nodiscard]] double checkpoint_interval();

/// Hash of the files that a call reads, by names and bytes. A file that cannot be read counts by its name.
void add_files(solver::Digest& digest, const std::vector<std::string>& files);

}  // namespace tiretherm::post
