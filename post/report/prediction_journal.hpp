// SPDX-License-Identifier: BSD-3-Clause
// The simulations that a fit or a diagnosis has made, kept for the call that goes on after it was killed.
#pragma once

#include <chrono>
#include <map>
#include <mutex>

#include "post/report/output_folder.hpp"
#include "post/report/record_file.hpp"
#include "solver/sensitivity/kept_results.hpp"

namespace tiretherm::post {

/// Results of simulations in a file of the output folder. The first `checkpoint_interval()` keeps none, so that a short call
/// costs nothing; results that are large beside the time they took are not kept, nor more than a gigabyte in all, nor more
/// than half of the room that the disk has for them. Where the file cannot be written, the call goes on without it.
class PredictionJournal final : public solver::KeptResults {
public:
    /// @param identity of the call  @param fresh forget what an interrupted call has left
    /// @param name of the file: each command has its own
    PredictionJournal(OutputFolder& folder, const std::string& name, const solver::Digest::Value& identity, bool fresh);

    [[nodiscard]] bool is_active() override;
    [[nodiscard]] std::optional<std::vector<double>> find(const solver::Digest::Value& key) override;
    void add(const solver::Digest::Value& key, std::span<const double> result, double seconds) noexcept override;

    /// Keeps results from now on: the call has a limit, before which it may not come to `checkpoint_interval()`.
    void keep_at_once() { keeps_at_once_ = true; }

    /// Results of an interrupted call.
    [[nodiscard]] std::size_t found() const { return found_; }
    /// Whether something of an interrupted call was cut off or damaged; its simulations are made again.
    [[nodiscard]] bool is_damaged() const { return is_damaged_; }
    /// Whether results were not kept for want of room on the disk.
    [[nodiscard]] bool lacked_room() const { return lacked_room_; }
    /// Results that the next call would find.
    [[nodiscard]] std::size_t size() const { return places_.size(); }

private:
    [[nodiscard]] bool is_late() const;
    /// Whether the disk has as much room left as the file takes with so many bytes more.
    [[nodiscard]] bool has_room(std::uint64_t more) const;

    std::filesystem::path path_;
    std::mutex talk_;
    std::unique_ptr<RecordFile> file_;
    std::map<solver::Digest::Value, std::size_t> places_;  ///< records
    std::size_t found_ = 0;
    bool keeps_at_once_ = false;
    bool is_damaged_ = false;
    bool lacked_room_ = false;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

}  // namespace tiretherm::post
