// SPDX-License-Identifier: BSD-3-Clause
// A record is a key of two words and the numbers of a result.

#include "post/report/prediction_journal.hpp"

#include <array>
#include <bit>
#include <system_error>

#include "post/report/file.hpp"

namespace tiretherm::post {

namespace {

constexpr std::uint64_t most_bytes = 1'000'000'000;
/// A result is worth its place when it took a second for so many bytes: writing it is then below a fiftieth of that.
constexpr double bytes_a_second = 10e6;

}  // namespace

PredictionJournal::PredictionJournal(OutputFolder& folder, const std::string& name,
                                     const solver::Digest::Value& identity, bool fresh)
    : path_(folder.journal(name)) {
    std::error_code ignored;
    if (fresh) {
        std::filesystem::remove(path_, ignored);
    }
    try {
        file_ = std::make_unique<RecordFile>(path_, identity);
        is_damaged_ = file_->dropped() > 0;
        for (std::size_t r = 0; r < file_->size(); ++r) {
            if (const std::vector<double> numbers = file_->read(r); numbers.size() > 2) {
                places_[{std::bit_cast<std::uint64_t>(numbers[0]), std::bit_cast<std::uint64_t>(numbers[1])}] = r;
            }
        }
    } catch (const std::exception&) {
        file_.reset();
        places_.clear();
    }
    found_ = places_.size();
}

bool PredictionJournal::is_late() const {
    return keeps_at_once_ ||
           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count() >= checkpoint_interval();
}

bool PredictionJournal::has_room(std::uint64_t more) const {
    std::error_code error;
    const std::filesystem::space_info disk = std::filesystem::space(path_.parent_path(), error);
    return error || disk.available >= file_->bytes() + 2 * more;
}

bool PredictionJournal::is_active() { return found_ > 0 || is_late(); }

std::optional<std::vector<double>> PredictionJournal::find(const solver::Digest::Value& key) {
    const std::lock_guard lock(talk_);
    const auto place = places_.find(key);
    if (!file_ || place == places_.end()) {
        return std::nullopt;
    }
    try {
        std::vector<double> numbers = file_->read(place->second);
        numbers.erase(numbers.begin(), numbers.begin() + 2);
        return numbers;
    } catch (const FileError&) {
        return std::nullopt;
    }
}

void PredictionJournal::add(const solver::Digest::Value& key, std::span<const double> result, double seconds) noexcept {
    try {
        const std::lock_guard lock(talk_);
        const bool worth = static_cast<double>(result.size_bytes()) <= bytes_a_second * seconds;
        const bool room = file_ && !lacked_room_ && file_->bytes() + result.size_bytes() <= most_bytes;
        if (!is_late() || (checkpoint_interval() > 0.0 && !worth) || !room || places_.contains(key)) {
            return;
        }
        if (!has_room(result.size_bytes())) {
            lacked_room_ = true;
            return;
        }
        const std::array<double, 2> head{std::bit_cast<double>(key[0]), std::bit_cast<double>(key[1])};
        file_->append({head, result});
        places_[key] = file_->size() - 1;
    } catch (const std::exception&) {
        lacked_room_ = true;  // what it has is still read
    }
}

}  // namespace tiretherm::post
