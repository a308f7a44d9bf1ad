// SPDX-License-Identifier: BSD-3-Clause
// Merges the times of channels and puts their samples into the rows.

#include "input/loggers/channel_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

namespace tiretherm::input {

namespace {

constexpr double same_time = 1e-7;  ///< s; the times of 200 Hz and of 3 Hz are farther apart or the same

constexpr std::size_t most_values = 300'000'000;  ///< 2.4 GB

}  // namespace

ChannelTable::ChannelTable(std::vector<Channel> channels, LogDescription description, int file)
    : channels_(std::move(channels)), description_(std::move(description)), file_(file) {
    const SourceLocation place{.file = file};
    heads_.push_back({.heading = {"time", "s"}, .place = place});
    for (const Channel& channel : channels_) {
        heads_.push_back({.heading = {channel.name, channel.unit.empty() ? std::nullopt : std::optional(channel.unit)},
                          .place = place});
    }
    choose({});
}

void ChannelTable::choose(const std::vector<int>& columns) {
    std::set<std::pair<double, std::size_t>> clocks;  // rate and count, each once
    for (const int column : columns) {
        if (column > 0) {
            const Channel& channel = channels_[static_cast<std::size_t>(column) - 1];
            clocks.emplace(channel.rate, channel.count);
        }
    }
    if (clocks.empty()) {
        for (const Channel& channel : channels_) {
            clocks.emplace(channel.rate, channel.count);
        }
    }
    rows_.clear();
    for (const auto& [rate, count] : clocks) {
        for (std::size_t k = 0; k < count; ++k) {
            rows_.push_back(static_cast<double>(k) / rate);
        }
    }
    std::ranges::sort(rows_);
    rows_.erase(std::unique(rows_.begin(), rows_.end(), [](double a, double b) { return b - a < same_time; }),
                rows_.end());
}

std::vector<double> ChannelTable::in_rows(const Channel& channel) const {
    const std::vector<double> samples = channel.samples();
    std::vector<double> sums(rows_.size(), 0.0);
    std::vector<int> counts(rows_.size(), 0);
    std::size_t row = 0;
    for (std::size_t k = 0; k < samples.size() && !rows_.empty(); ++k) {
        const double time = static_cast<double>(k) / channel.rate;
        while (row + 1 < rows_.size() && std::abs(rows_[row + 1] - time) <= std::abs(rows_[row] - time)) {
            ++row;
        }
        // Before the first and behind the last row there is none to belong to.
        const bool beside = (row + 1 == rows_.size() || row == 0) && std::abs(rows_[row] - time) > 1.0 / channel.rate;
        if (!beside && std::isfinite(samples[k])) {
            sums[row] += samples[k];
            ++counts[row];
        }
    }
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        sums[i] = counts[i] == 0 ? std::numeric_limits<double>::quiet_NaN() : sums[i] / counts[i];
    }
    return sums;
}

std::vector<std::vector<double>> ChannelTable::read(const std::vector<ColumnRequest>& requests,
                                                    InputErrors& errors) const {
    const std::size_t before = errors.count();
    if (requests.size() > most_values / std::max<std::size_t>(rows_.size(), 1)) {
        errors.add({.file = file_},
                   fmt::format("{} channels at {} times are more values than are read at once ({:.0e})",
                               requests.size(), rows_.size(), static_cast<double>(most_values)),
                   "export a part of the session, or fewer channels");
        return {};
    }
    std::vector<std::vector<double>> values;
    for (const ColumnRequest& request : requests) {
        const ColumnHead& head = heads_[static_cast<std::size_t>(request.column)];
        ColumnReader reader(head, request, errors);
        reader.values.reserve(rows_.size());
        const std::vector<double> written =
            request.column == 0 ? rows_ : in_rows(channels_[static_cast<std::size_t>(request.column) - 1]);
        for (std::size_t i = 0; i < written.size(); ++i) {
            reader.take(written[i], true, [&] {
                return ColumnReader::FieldLocation{head.place, fmt::format(" (at {:.6g} s)", rows_[i])};
            });
        }
        reader.close();
        values.push_back(std::move(reader.values));
    }
    return errors.count() == before ? values : std::vector<std::vector<double>>{};
}

}  // namespace tiretherm::input
