// SPDX-License-Identifier: BSD-3-Clause
// The table [drive] on its way, while constants, schedules and logs of it may still give one signal twice.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "input/drive/drive.hpp"
#include "input/drive/run_columns.hpp"

namespace tiretherm::input {

class DriveReader {
public:
    /// @param run that is measured, null: none  @param followed names that user effects and [vehicle] refer to
    DriveReader(int case_file, const RunInputs* run, const std::vector<std::string>& followed)
        : case_file_(case_file), run_(run), followed_(followed) {}

    /// All of [drive], and what the run's file gives in the place of it.
    [[nodiscard]] DriveTable read(TomlTable& drive) &&;

private:
    void read_schedule(TomlTable& table);
    /// One [[drive.file]]: a logger's file.
    void read_log(TomlTable& table);
    /// Takes away columns that the case does not take from this file.
    /// @returns whether a measured run's file or a constant of the case gives an input instead
    bool leave_out_outranked(const TomlTable& table, const DataFile& file, RunColumns& columns);
    void add(const MeasuredInput& input);
    /// The inputs that a measured run's file gives.
    void add_measured(InputErrors& errors);
    /// Whether the measured run's file gives a signal that stands in [drive] at this key.
    [[nodiscard]] bool overridden(std::string_view key, std::string_view signal) const {
        return run_ != nullptr && run_->overrides(key, signal);
    }
    /// Whether a signal counts. Of a constant and a series of different files that of the case itself counts, otherwise the
    /// series; any other second one is an error at `place`.
    /// @param mentioned in the case; that is `place` unless it is in a log
    bool register_signal(std::string_view name, const SourceLocation& place, const SourceLocation& mentioned,
                         InputErrors& errors);
    void take_driven(const std::vector<double>& time);

    int case_file_;  ///< number of the case's own file, among those that it includes
    const RunInputs* run_;
    const std::vector<std::string>& followed_;
    std::vector<std::string> constants_{};  ///< signals that [drive] gives as constants and that count
    DriveTable read_{};
};

}  // namespace tiretherm::input
