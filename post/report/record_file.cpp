// SPDX-License-Identifier: BSD-3-Clause
// Layout: magic, identity (two words), then records of count, checksum (one word each) and numbers.

#include "post/report/record_file.hpp"

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

using Word = std::uint64_t;

constexpr Word magic = 0x31306B6365687474U;  // "ttheck01"
constexpr std::uint64_t head_bytes = 3 * sizeof(Word);
constexpr std::uint64_t record_head_bytes = 2 * sizeof(Word);

Word checksum_of(std::initializer_list<std::span<const double>> parts) {
    solver::Digest digest;
    for (const std::span<const double> part : parts) {
        for (const double number : part) {
            digest.add(number);
        }
    }
    return digest.value()[0];
}

bool read_at(int file, std::uint64_t at, void* into, std::size_t bytes) {
    auto* to = static_cast<char*>(into);
    while (bytes > 0) {
        const ssize_t n = pread(file, to, bytes, static_cast<off_t>(at));
        if (n <= 0) {
            return false;
        }
        to += n;
        at += static_cast<std::uint64_t>(n);
        bytes -= static_cast<std::size_t>(n);
    }
    return true;
}

}  // namespace

RecordFile::RecordFile(std::filesystem::path path, const solver::Digest::Value& identity)
    : path_(std::move(path)), identity_(identity) {
    file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) {
        fail("create");
    }
    find_records();
}

RecordFile::~RecordFile() { close(file_); }

void RecordFile::fail(const char* doing) const { throw FileError(doing, path_, system_reason(errno)); }

void RecordFile::find_records() {
    std::array<Word, 3> head{};
    const std::array<Word, 3> wanted{magic, identity_[0], identity_[1]};
    const off_t found = lseek(file_, 0, SEEK_END);
    const bool has_head = read_at(file_, 0, head.data(), head_bytes);
    const bool is_ours = !has_head || (head[1] == wanted[1] && head[2] == wanted[2]);
    if (!has_head || head != wanted) {
        if (ftruncate(file_, 0) != 0 ||
            pwrite(file_, wanted.data(), head_bytes, 0) != static_cast<ssize_t>(head_bytes)) {
            fail("write");
        }
    }
    end_ = head_bytes;
    const off_t size = lseek(file_, 0, SEEK_END);
    std::vector<double> numbers;
    std::array<Word, 2> record{};
    while (read_at(file_, end_, record.data(), record_head_bytes)) {
        const std::uint64_t first = end_ + record_head_bytes;
        if (record[0] > (static_cast<std::uint64_t>(size) - first) / sizeof(double)) {
            break;
        }
        numbers.resize(record[0]);
        if (!read_at(file_, first, numbers.data(), numbers.size() * sizeof(double)) ||
            checksum_of({numbers}) != record[1]) {
            break;
        }
        records_.push_back({.at = first, .count = numbers.size()});
        end_ = first + numbers.size() * sizeof(double);
    }
    if (ftruncate(file_, static_cast<off_t>(end_)) != 0) {
        fail("write");
    }
    const auto bytes = static_cast<std::uint64_t>(std::max<off_t>(found, 0));
    dropped_ = is_ours && bytes > 0 ? bytes - std::min(bytes, has_head && head == wanted ? end_ : 0) : 0;
}

std::vector<double> RecordFile::read(std::size_t record) const {
    std::vector<double> numbers(records_[record].count);
    if (!read_at(file_, records_[record].at, numbers.data(), numbers.size() * sizeof(double))) {
        fail("read");
    }
    return numbers;
}

void RecordFile::truncate(std::size_t records) {
    if (records < records_.size()) {
        end_ = records_[records].at - record_head_bytes;
        records_.resize(records);
        if (ftruncate(file_, static_cast<off_t>(end_)) != 0) {
            fail("write");
        }
    }
}

void RecordFile::append(std::initializer_list<std::span<const double>> parts) {
    std::size_t count = 0;
    for (const std::span<const double> part : parts) {
        count += part.size();
    }
    std::array<Word, 2> head{count, checksum_of(parts)};
    const std::size_t bytes = record_head_bytes + count * sizeof(double);
    std::vector<iovec> pieces{{head.data(), record_head_bytes}};
    for (const std::span<const double> part : parts) {
        pieces.push_back({const_cast<double*>(part.data()), part.size_bytes()});  // NOLINT: the call reads them
    }
    if (pwritev(file_, pieces.data(), static_cast<int>(pieces.size()), static_cast<off_t>(end_)) !=
        static_cast<ssize_t>(bytes)) {
        const int reason = errno;
        static_cast<void>(ftruncate(file_, static_cast<off_t>(end_)));  // a full disk gets the torn piece back
        errno = reason;
        fail("write");
    }
    records_.push_back({.at = end_ + record_head_bytes, .count = count});
    end_ += bytes;
}

double checkpoint_interval() {
    constexpr double usual = 2.0;
    const char* text = std::getenv("TIRETHERM_CHECKPOINT_SECONDS");
    char* end = nullptr;
    const double seconds = text != nullptr ? std::strtod(text, &end) : usual;
    return text != nullptr && end != text && *end == '\0' && seconds >= 0.0 ? seconds : usual;
}

void add_files(solver::Digest& digest, const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        digest.add(std::string_view(file));
        std::error_code error;
        if (std::filesystem::is_regular_file(file, error)) {
            digest.add(std::string_view(read_text(file)));
        }
    }
}

}  // namespace tiretherm::post
