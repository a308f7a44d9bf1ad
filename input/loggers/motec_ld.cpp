// SPDX-License-Identifier: BSD-3-Clause
// Files .ld of MoTeC loggers: a header, and a linked list of channels with a rate, a type and a scale each. Layout by public descriptions
// of the format: header 64 at byte 0, the first record's address at 8, the data's at 12; a record of 124 bytes has the addresses
// of its neighbours and of its samples, their count, type, size and rate, shift, multiplier, scale and decimals, name, short name
// and unit. A value is (sample / scale / 10^decimals + shift) multiplier. The marks between laps are read from the file .ldx beside it.
// Every address and count of the file is compared with its size before it is used.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "input/files/regular_file.hpp"
#include "input/loggers/binary_logs.hpp"
#include "input/loggers/binary_numbers.hpp"
#include "input/loggers/logger_units.hpp"
#include "input/text/quantity.hpp"
#include "input/text/units.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::input {

namespace {

constexpr std::size_t head_size = 0x1A0;   ///< up to the venue
constexpr std::size_t record_size = 0x54;  ///< up to the unit; 40 unused bytes follow
// Each record names the address of the next one: a damaged chain would go on as long as the file has addresses.
constexpr std::size_t most_channels = 10000;

/// A channel's record.
struct Record {
    std::uint32_t next = 0;
    std::uint32_t data = 0;   ///< address of the samples
    std::uint32_t count = 0;  ///< of samples
    SampleType type = SampleType::int16;
    int rate = 0;  ///< Hz
    int shift = 0;
    int multiplier = 1;
    int scale = 1;
    int decimals = 0;
    std::string name;
    std::string short_name;  ///< up to the unit's end, where the one runs into the other
    std::string unit;
};

std::optional<SampleType> type_of(int kind, int size) {
    const bool is_float = kind == 7 || kind == 8;
    const bool is_integer = kind == 0 || kind == 3 || kind == 5;
    if (is_float) {
        return size == 2   ? std::optional(SampleType::float16)
               : size == 4 ? std::optional(SampleType::float32)
               : size == 8 ? std::optional(SampleType::float64)
                           : std::nullopt;
    }
    return is_integer && size == 2   ? std::optional(SampleType::int16)
           : is_integer && size == 4 ? std::optional(SampleType::int32)
                                     : std::nullopt;
}

/// Reads the records and says what is wrong with them.
class LdReader {
public:
    LdReader(const BinaryNumbers& in, InputErrors& errors) : in_(in), errors_(errors) {}

    std::optional<std::vector<TableColumn>> channels() {
        const std::size_t before = errors_.count();
        std::vector<TableColumn> found;
        std::set<std::uint32_t> seen;
        std::uint32_t at = in_.unsigned32(8);
        while (at != 0) {
            if (!seen.insert(at).second) {
                return errors_.add(place_,
                                   fmt::format("the list of channels runs in a circle: after channel {} it comes back "
                                               "to one that was there before",
                                               seen.size()),
                                   "the file is damaged: read it from the logger again");
            }
            if (seen.size() > most_channels) {
                return errors_.add(place_, fmt::format("the file has more than {} channels", most_channels),
                                   "the file is damaged: read it from the logger again");
            }
            if (at > in_.size() || in_.size() - at < record_size) {
                return errors_.add(place_,
                                   fmt::format("the file ends within the record of channel {}: it has {} bytes",
                                               seen.size(), in_.size()),
                                   "the file is incomplete: copy it from the logger again");
            }
            at = take_record(at, seen.size(), found);
        }
        take_units_from_short_names(found);
        if (found.empty() && errors_.count() == before) {
            errors_.add(place_, "the file has no channel with samples", "");
        }
        return errors_.count() == before ? std::optional(std::move(found)) : std::nullopt;
    }

private:
    /// @returns where the next record is
    std::uint32_t take_record(std::uint32_t at, std::size_t index, std::vector<TableColumn>& into) {
        Record record{.next = in_.unsigned32(at + 4),
                      .data = in_.unsigned32(at + 8),
                      .count = in_.unsigned32(at + 12),
                      .rate = in_.unsigned16(at + 22),
                      .shift = in_.signed16(at + 24),
                      .multiplier = in_.signed16(at + 26),
                      .scale = in_.signed16(at + 28),
                      .decimals = in_.signed16(at + 30),
                      .name = in_.text(at + 32, 32),
                      .short_name = in_.text(at + 64, 12),
                      .unit = in_.text(at + 72, 12)};
        if (record.name.empty()) {
            record.name = in_.text(at + 64, 8);
        }
        const std::string called =
            record.name.empty() ? fmt::format("{}", index) : fmt::format("{} ({})", index, record.name);
        const auto refuse = [&](const std::string& what) {
            errors_.add(place_, fmt::format("channel {} {}", called, what),
                        "the file is damaged or incomplete: copy it from the logger again");
            return record.next;
        };
        // A channel of another kind, as newer loggers may have, is no damage to the others.
        const auto leave_out = [&](const std::string& what) {
            errors_.warn(place_, "channel {} {}: it is left out", called, what);
            return record.next;
        };
        const int kind = in_.unsigned16(at + 18);
        const int size = in_.unsigned16(at + 20);
        const std::optional<SampleType> type = type_of(kind, size);
        if (!type) {
            return leave_out(fmt::format("is of the unknown type {} with {} bytes a sample", kind, size));
        }
        record.type = *type;
        const std::uint64_t length = std::uint64_t{record.count} * static_cast<std::uint64_t>(size);
        if (record.data > in_.size() || length > in_.size() - record.data) {
            return refuse(fmt::format("has {} samples from byte {} on, beyond the end of the file at byte {}",
                                      record.count, record.data, in_.size()));
        }
        samples_ += length;
        if (samples_ > in_.size()) {
            return refuse("shares its samples with another one: together they are longer than the file");
        }
        if (record.count > 0 && record.rate == 0) {
            return leave_out("has a rate of 0 Hz");
        }
        if (record.scale == 0 || record.multiplier == 0 || std::abs(record.decimals) > 30) {
            return leave_out(fmt::format("has a scale of {}, a multiplier of {} and {} decimals", record.scale,
                                         record.multiplier, record.decimals));
        }
        const std::uint32_t next = record.next;
        if (record.count > 0 && !record.name.empty()) {
            into.push_back(channel_of(record));
            short_names_.push_back(std::move(record.short_name));
        }
        return next;
    }

    /// Some programs write no short names, and the units in their place.
    void take_units_from_short_names(std::vector<TableColumn>& channels) const {
        const auto is_unit = [](const std::string& text) {
            return text.empty() || is_logger_unit(text) || !signature(text).empty();
        };
        const bool has_units = std::ranges::any_of(
            channels, [](const TableColumn& channel) { return channel.head.heading.unit.has_value(); });
        for (std::size_t i = 0; !has_units && std::ranges::all_of(short_names_, is_unit) && i < channels.size(); ++i) {
            channels[i].head.heading.unit = unit_of(short_names_[i]);
        }
    }

    static std::optional<std::string> unit_of(const std::string& written) {
        return written.empty() ? std::nullopt : std::optional(written);
    }

    [[nodiscard]] TableColumn channel_of(const Record& record) const {
        solver::leave_reading_if_stopped();
        TableColumn channel{.head = {.heading = {record.name, unit_of(record.unit)}, .place = {}},
                            .number = in_.samples(record.data, record.count, record.type),
                            .rate = static_cast<double>(record.rate)};
        const double power = std::pow(10.0, record.decimals);
        for (double& value : channel.number) {
            value = (value / record.scale / power + record.shift) * record.multiplier;
        }
        return channel;
    }

    const BinaryNumbers& in_;
    SourceLocation place_{.file = 0};
    InputErrors& errors_;
    std::uint64_t samples_ = 0;             ///< bytes of all channels
    std::vector<std::string> short_names_;  ///< of the channels that are kept
};

constexpr std::uintmax_t largest_ldx = 10'000'000;  ///< bytes; a file of a few beacons has some kilobytes
constexpr double microsecond = 1e-6;

/// Times of the beacons in a file .ldx, XML that MoTeC i2 writes beside a .ld file: the elements Marker of class BCN, in microseconds.
/// What else it holds is of the display. Empty where none can be read: the laps may stand in a channel.
/// @returns s, ascending
std::vector<double> read_ldx_markers(const std::filesystem::path& file) {
    if (!not_readable(file, largest_ldx).what.empty()) {
        return {};
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    std::vector<double> markers;
    std::size_t end = 0;
    for (std::size_t at = text.find("<Marker "); at != std::string::npos; at = text.find("<Marker ", end)) {
        end = std::min(text.find_first_of("<>", at + 1), text.size());  // of a damaged element at the next one
        const std::string_view element = std::string_view(text).substr(at, end - at);
        const std::size_t time = element.find(" Time=\"");
        if (element.find("ClassName=\"BCN\"") == std::string_view::npos || time == std::string_view::npos) {
            continue;
        }
        const std::optional<Number> number = leading_number(element.substr(time + 7));
        if (number && std::isfinite(number->value)) {
            markers.push_back(microsecond * number->value);
        }
    }
    std::ranges::sort(markers);
    return markers;
}

}  // namespace

bool is_motec_ld(std::string_view first_bytes) { return first_bytes.starts_with(std::string_view("\x40\0\0\0", 4)); }

std::optional<LogTable> read_motec_ld(const std::string& bytes, const std::filesystem::path& path,
                                      InputErrors& errors) {
    if (bytes.size() < head_size) {
        return errors.add(
            {.file = 0},
            fmt::format("the file ends within the head of a MoTeC .ld file: it has {} bytes", bytes.size()),
            "the file is incomplete: copy it from the logger again");
    }
    const BinaryNumbers in(bytes);
    LogDescription description{.format = "MoTeC .ld"};
    const auto add = [&](const char* name, std::size_t at, std::size_t length) {
        if (std::string text = in.text(at, length); !text.empty()) {
            description.details.push_back({name, std::move(text)});
        }
    };
    add("Date", 0x5E, 16);
    add("Time", 0x7E, 16);
    add("Driver", 0x9E, 64);
    add("Vehicle", 0xDE, 64);
    add("Venue", 0x15E, 64);
    std::optional<std::vector<TableColumn>> channels = LdReader(in, errors).channels();
    if (!channels) {
        return std::nullopt;
    }
    std::error_code ignored;
    const std::filesystem::path beacons = std::filesystem::path(path).replace_extension(".ldx");
    if (std::filesystem::exists(beacons, ignored)) {
        static_cast<void>(errors.add_file(beacons.generic_string(), ""));  // results follow from it, too
        description.markers = read_ldx_markers(beacons);
    }
    return table_of_channels(std::move(*channels), std::move(description));
}

}  // namespace tiretherm::input
