// SPDX-License-Identifier: BSD-3-Clause
// What a run that is killed leaves to the next call: its rows, and the state from which it goes on to the same digits.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "post/report/output_folder.hpp"
#include "post/report/record_file.hpp"
#include "solver/time_integration/march.hpp"

namespace tiretherm::post {

/// The journal of a run. Rows wait in memory until a checkpoint is left, at most every `checkpoint_interval()` and so seldom
/// that it costs two hundredths of the time; a run of two seconds writes nothing. Where it cannot be written, the run
/// goes on without one.
class RunJournal {
public:
    /// @param identity of the call  @param fresh forget what an interrupted call has left
    RunJournal(OutputFolder& folder, const solver::Digest::Value& identity, const solver::Problem& problem, bool fresh);

    /// The state of an interrupted call, or null. Valid until `keep`.
    [[nodiscard]] const solver::Checkpoint* checkpoint() const { return kept_ ? &kept_->solver : nullptr; }
    /// Whether an interrupted call of the same has left a state that cannot be used: the run begins anew.
    [[nodiscard]] bool is_damaged() const { return is_damaged_; }
    /// Numbers that another follower of the rows left with it.
    [[nodiscard]] const std::vector<double>& follower() const { return kept_->follower; }
    [[nodiscard]] double time() const { return kept_->time; }        ///< s, up to which the run is kept
    [[nodiscard]] double seconds() const { return kept_->seconds; }  ///< that it took
    /// Gives the rows that the interrupted call had come to, in their order. @errors FileError
    void replay(const std::function<void(const solver::Snapshot&)>& take);

    void take(const solver::Snapshot& snapshot);
    [[nodiscard]] bool due() const;
    /// Leaves a checkpoint with the rows up to it.
    void keep(const solver::Checkpoint& checkpoint, const std::vector<double>& follower) noexcept;

private:
    using Clock = std::chrono::steady_clock;
    struct Kept {
        std::size_t rows = 0;
        double time = 0.0;
        double seconds = 0.0;
        solver::Checkpoint solver;
        std::vector<double> follower;
    };
    /// @returns whether what is there is whole, or nothing of this call
    [[nodiscard]] bool read();
    void give_up() noexcept;
    [[nodiscard]] std::size_t row_numbers() const;  ///< of a row without a field

    std::filesystem::path rows_path_;
    std::filesystem::path state_path_;
    std::filesystem::path draft_path_;
    solver::Digest::Value identity_;
    const solver::Problem* problem_;
    std::unique_ptr<RecordFile> rows_;
    std::optional<Kept> kept_;
    std::vector<double> waiting_;       ///< rows since the last checkpoint, one after the other
    std::vector<std::size_t> lengths_;  ///< of these
    double last_time_ = 0.0;
    Clock::time_point begin_;
    Clock::time_point last_;
    double cost_ = 0.0;  ///< s, of the last checkpoint
    double seconds_before_ = 0.0;
    bool works_ = true;
    bool is_damaged_ = false;
};

}  // namespace tiretherm::post
