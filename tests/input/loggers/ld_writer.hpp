// SPDX-License-Identifier: BSD-3-Clause
// Writes MoTeC .ld files byte by byte, sound ones and ones that no logger writes. After public descriptions of the layout; knows
// nothing of the reader.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tiretherm::input::made_up {

/// A channel with its samples as the bytes of their type.
struct LdChannel {
    std::string name;
    std::string unit;
    int rate = 1;
    int kind = 3;  ///< 3: integer, 7: float
    int size = 2;  ///< bytes of a sample
    int shift = 0;
    int multiplier = 1;
    int scale = 1;
    int decimals = 0;
    std::string samples{};  ///< bytes
    std::uint32_t count = 0;
    std::uint32_t next_override = 0xFFFFFFFF;  ///< address of the next record in place of the true one
    std::uint32_t data_override = 0xFFFFFFFF;
    bool has_short_name = true;  ///< else the unit stands in its place
};

class LdWriter {
public:
    static constexpr std::size_t first_record = 0x400;
    static constexpr std::size_t record_size = 124;

    /// A number, the lowest byte first.
    template <typename T>
    static std::string bytes_of(T value) {
        std::string bytes;
        for (std::size_t i = 0; i < sizeof(T); ++i) {
            bytes += static_cast<char>(static_cast<unsigned char>(static_cast<std::uint64_t>(value) >> (8 * i)));
        }
        return bytes;
    }
    static std::string bytes_of_float(float value) { return bytes_of(std::bit_cast<std::uint32_t>(value)); }
    static std::string bytes_of_double(double value) { return bytes_of(std::bit_cast<std::uint64_t>(value)); }

    static std::string file(const std::vector<LdChannel>& channels) {
        std::string bytes(first_record, '\0');
        bytes[0] = 0x40;
        const std::size_t data = first_record + record_size * channels.size();
        put(bytes, 8, bytes_of(static_cast<std::uint32_t>(channels.empty() ? 0 : first_record)));
        put(bytes, 12, bytes_of(static_cast<std::uint32_t>(data)));
        put(bytes, 0x5E, "16/12/2025");
        put(bytes, 0x7E, "11:49:03");
        put(bytes, 0xDE, "M4 GT4");
        put(bytes, 0x15E, "Circle");
        std::string samples;
        for (std::size_t i = 0; i < channels.size(); ++i) {
            const LdChannel& c = channels[i];
            const auto here = static_cast<std::uint32_t>(first_record + record_size * i);
            const bool last = i + 1 == channels.size();
            const std::uint32_t next = last ? 0 : here + static_cast<std::uint32_t>(record_size);
            const auto at = static_cast<std::uint32_t>(data + samples.size());
            std::string record;
            record += bytes_of(i == 0 ? std::uint32_t{0} : here - static_cast<std::uint32_t>(record_size));
            record += bytes_of(c.next_override == 0xFFFFFFFF ? next : c.next_override);
            record += bytes_of(c.data_override == 0xFFFFFFFF ? at : c.data_override) + bytes_of(c.count);
            for (const int number : {0, c.kind, c.size, c.rate, c.shift, c.multiplier, c.scale, c.decimals}) {
                record += bytes_of(static_cast<std::uint16_t>(number));
            }
            record += fixed(c.name, 32) + (c.has_short_name ? fixed(c.name.substr(0, 3), 8) : "") + fixed(c.unit, 12);
            record.resize(record_size, '\0');
            bytes += record;
            samples += c.samples;
        }
        return bytes + samples;
    }

private:
    static void put(std::string& bytes, std::size_t at, std::string_view what) { bytes.replace(at, what.size(), what); }
    static std::string fixed(std::string text, std::size_t length) {
        text.resize(length, '\0');
        return text;
    }
};

/// A channel of 16-bit integers.
inline LdChannel integers(std::string name, std::string unit, int rate, const std::vector<int>& raw) {
    LdChannel channel{.name = std::move(name), .unit = std::move(unit), .rate = rate};
    for (const int value : raw) {
        channel.samples += LdWriter::bytes_of(static_cast<std::uint16_t>(static_cast<std::int16_t>(value)));
    }
    channel.count = static_cast<std::uint32_t>(raw.size());
    return channel;
}

}  // namespace tiretherm::input::made_up
