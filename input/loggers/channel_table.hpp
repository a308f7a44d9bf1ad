// SPDX-License-Identifier: BSD-3-Clause
// Channels that were recorded at different rates, as a table on the union of their times.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "input/loggers/log_description.hpp"
#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// Channels with a rate each. The first column is `time`; a row is a time at which at least one of the chosen channels was
/// sampled. A channel's value stands in the row of its own time; elsewhere it is missing. Of channels that were not chosen a
/// row has the mean of the samples that are nearest to it.
class ChannelTable {
public:
    struct Channel {
        std::string name;
        std::string unit;
        double rate = 1.0;                               ///< Hz, > 0
        std::size_t count = 0;                           ///< samples; the k-th at k / rate
        std::function<std::vector<double>()> samples{};  ///< [count] in its unit
    };
    /// @param file number in the errors
    ChannelTable(std::vector<Channel> channels, LogDescription description, int file);

    [[nodiscard]] const std::vector<ColumnHead>& heads() const { return heads_; }
    [[nodiscard]] std::vector<ColumnHead>& heads() { return heads_; }
    [[nodiscard]] int number() const { return file_; }
    [[nodiscard]] const LogDescription& description() const { return description_; }
    [[nodiscard]] const std::vector<Channel>& channels() const { return channels_; }
    /// Chooses the columns whose times make the rows; all at first. With none of them: all.
    void choose(const std::vector<int>& columns);
    /// @returns the values of each request, all of one length; none after an error
    [[nodiscard]] std::vector<std::vector<double>> read(const std::vector<ColumnRequest>& requests,
                                                        InputErrors& errors) const;

private:
    [[nodiscard]] std::vector<double> in_rows(const Channel& channel) const;

    std::vector<Channel> channels_;
    LogDescription description_;
    int file_ = -1;
    std::vector<ColumnHead> heads_;
    std::vector<double> rows_;  ///< s, ascending
};

}  // namespace tiretherm::input
