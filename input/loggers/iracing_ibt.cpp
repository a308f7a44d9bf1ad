// SPDX-License-Identifier: BSD-3-Clause
// Files .ibt of the simulator iRacing: a head, descriptions of the channels, rows of all channels at one rate. Layout by the
// simulator's published interface (irsdk_header, irsdk_diskSubHeader, irsdk_varHeader): version at byte 0, rows per second at 8,
// length and address of the session's description (YAML) at 16 and 20, number and address of the channels' descriptions at 24 and
// 28, length of a row at 36, address of the rows at 52; a description of 144 bytes has type, place in the row and count at 0, 4
// and 8, name, text and unit at 16, 48 and 112. Numbers in % are shares of 1 in the file. Bits, letters and lists (of all cars, or of
// times within a row) are no channels. Every address and count of the file is compared with its size before it is used.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "input/loggers/binary_logs.hpp"
#include "input/loggers/binary_numbers.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t ibt_head_size = 144;         ///< of both heads
constexpr std::size_t ibt_description_size = 144;  ///< of a channel
constexpr std::size_t most_ibt_channels = 10000;
constexpr std::uint32_t highest_ibt_rate = 1000;  ///< Hz

/// Where the rows of a file stand.
struct IbtRows {
    std::size_t first = 0;  ///< address
    std::size_t length = 0;
    std::size_t count = 0;
    double rate = 60.0;  ///< Hz
};

/// A type of numbers; nothing for letters and bits.
std::optional<SampleType> ibt_type_of(std::uint32_t number) {
    constexpr std::array<std::optional<SampleType>, 6> types{std::nullopt, SampleType::uint8,   SampleType::int32,
                                                             std::nullopt, SampleType::float32, SampleType::float64};
    return number < types.size() ? types[number] : std::nullopt;
}

/// The value of a key in the session's description, such as "TrackDisplayName: Road Atlanta".
std::string value_of_key(std::string_view yaml, std::string_view key) {
    const std::size_t at = yaml.find(key);
    if (at == std::string_view::npos) {
        return {};
    }
    const std::string_view rest = yaml.substr(at + key.size());
    return printable(trim(rest.substr(0, rest.find('\n'))));
}

LogDescription describe_session(std::string_view yaml) {
    LogDescription description{.format = "iRacing .ibt"};
    for (const auto& [name, key] : {std::pair{"Track", "TrackDisplayName:"}, std::pair{"Vehicle", "CarScreenName:"}}) {
        if (std::string value = value_of_key(yaml, key); !value.empty()) {
            description.details.push_back({name, std::move(value)});
        }
    }
    return description;
}

/// A channel by its description, as it stands in a row.
struct IbtChannel {
    TableColumn column;
    std::size_t place = 0;  ///< in a row
    SampleType type = SampleType::float32;
};

/// The channel of a description; nothing where it is no channel, or lies beyond the rows.
std::optional<IbtChannel> channel_at(const BinaryNumbers& in, std::size_t at, const IbtRows& rows) {
    const std::optional<SampleType> type = ibt_type_of(in.unsigned32(at));
    const std::size_t place = in.unsigned32(at + 4);
    const bool is_list = in.unsigned32(at + 8) != 1;  // of all cars, or of times within a row
    if (!type || is_list || place > rows.length || size_of(*type) > rows.length - place) {
        return std::nullopt;
    }
    const std::string written = in.text(at + 112, 32);
    const std::string unit = written == "C" ? "degC" : written.starts_with("irsdk_") ? "" : written;
    IbtChannel channel{
        .column = {.head = {.heading = {in.text(at + 16, 32), unit.empty() ? std::nullopt : std::optional(unit)},
                            .place = {}},
                   .rate = rows.rate},
        .place = place,
        .type = *type};
    return channel.column.head.heading.name.empty() ? std::nullopt : std::optional(std::move(channel));
}

void read_samples(const BinaryNumbers& in, const IbtRows& rows, IbtChannel& channel) {
    const double factor = channel.column.head.heading.unit == "%" ? 100.0 : 1.0;
    channel.column.number.resize(rows.count);
    for (std::size_t row = 0; row < rows.count; ++row) {
        channel.column.number[row] = factor * in.number(rows.first + row * rows.length + channel.place, channel.type);
    }
}

}  // namespace

bool is_iracing_ibt(std::string_view first_bytes) {
    if (first_bytes.size() < 48) {
        return false;
    }
    const BinaryNumbers in(first_bytes);
    const std::uint32_t version = in.unsigned32(0);
    const std::uint32_t buffers = in.unsigned32(32);
    return (version == 1 || version == 2) && in.unsigned32(4) <= 1 && in.unsigned32(8) > 0 &&
           in.unsigned32(8) <= highest_ibt_rate && buffers > 0 && buffers <= 4;
}

std::optional<LogTable> read_iracing_ibt(const std::string& bytes, const std::filesystem::path& /*path*/,
                                         InputErrors& errors) {
    const auto refuse = [&](const std::string& what) {
        return errors.add({.file = 0}, what,
                          "the file is damaged or incomplete: copy it from the simulator's folder again");
    };
    if (bytes.size() < ibt_head_size) {
        return refuse(
            fmt::format("the file ends within the head of an iRacing .ibt file: it has {} bytes", bytes.size()));
    }
    const BinaryNumbers in(bytes);
    const std::size_t described = in.unsigned32(24);
    const std::size_t descriptions = in.unsigned32(28);
    IbtRows rows{
        .first = in.unsigned32(52), .length = in.unsigned32(36), .rate = static_cast<double>(in.unsigned32(8))};
    if (described > most_ibt_channels || descriptions > in.size() ||
        described > (in.size() - descriptions) / ibt_description_size) {
        return refuse(
            fmt::format("the descriptions of {} channels from byte {} on lie beyond the end of the file at byte {}",
                        described, descriptions, in.size()));
    }
    if (rows.first > in.size() || rows.length == 0) {
        return refuse(fmt::format("the rows of {} bytes from byte {} on lie beyond the end of the file at byte {}",
                                  rows.length, rows.first, in.size()));
    }
    rows.count = (in.size() - rows.first) / rows.length;
    std::vector<TableColumn> channels;
    std::size_t length = 0;  // of all channels in a row
    for (std::size_t i = 0; i < described && rows.count > 0; ++i) {
        if (auto channel = channel_at(in, descriptions + i * ibt_description_size, rows)) {
            length += size_of(channel->type);
            if (length > rows.length) {
                return refuse(fmt::format("{} channels need more than a row's {} bytes: some have the same place in it",
                                          channels.size() + 1, rows.length));
            }
            read_samples(in, rows, *channel);
            channels.push_back(std::move(channel->column));
        }
    }
    if (channels.empty()) {
        return refuse("the file has no channel with samples");
    }
    const std::size_t session = std::min<std::size_t>(in.unsigned32(20), in.size());
    return table_of_channels(std::move(channels),
                             describe_session(std::string_view(bytes).substr(session, in.unsigned32(16))));
}

}  // namespace tiretherm::input
