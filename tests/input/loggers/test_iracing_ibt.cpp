// SPDX-License-Identifier: BSD-3-Clause
// iRacing .ibt files that were written byte by byte, sound ones and ones that no simulator writes.

#include <gtest/gtest.h>

#include "input/loggers/ld_writer.hpp"
#include "input/loggers/read_back.hpp"

namespace tiretherm::input {

namespace {

using made_up::LdWriter;

/// A channel of a row.
struct IbtChannel {
    std::string name;
    std::string unit{};
    int type = 4;  ///< 1 truth, 2 integer, 3 bits, 4 and 5 numbers of 4 and 8 bytes
    int count = 1;
    std::vector<std::string> rows{};  ///< bytes
};

void put(std::string& bytes, std::size_t at, std::string_view what) { bytes.replace(at, what.size(), what); }
std::string int32(std::size_t value) { return LdWriter::bytes_of(static_cast<std::uint32_t>(value)); }
std::string real(float value) { return LdWriter::bytes_of_float(value); }

std::string ibt_file(const std::vector<IbtChannel>& channels) {
    const std::string yaml = "---\nWeekendInfo:\n TrackDisplayName: Road Atlanta\n...\n";
    std::string described;
    std::size_t length = 0;
    for (const IbtChannel& channel : channels) {
        std::string one(144, '\0');
        put(one, 0,
            int32(static_cast<std::size_t>(channel.type)) + int32(length) +
                int32(static_cast<std::size_t>(channel.count)));
        put(one, 16, channel.name);
        put(one, 112, channel.unit);
        described += one;
        length += channel.rows.front().size();
    }
    std::string rows;
    for (std::size_t row = 0; row < channels.front().rows.size(); ++row) {
        for (const IbtChannel& channel : channels) {
            rows += channel.rows[row];
        }
    }
    std::string head(144, '\0');
    const std::size_t session = head.size() + described.size();
    put(head, 0,
        int32(2) + int32(1) + int32(60) + int32(0) + int32(yaml.size()) + int32(session) + int32(channels.size()) +
            int32(head.size()) + int32(1) + int32(length));
    put(head, 52, int32(session + yaml.size()));
    return head + described + yaml + rows;
}

std::vector<IbtChannel> channels_of_two_rows() {
    return {{.name = "SessionTime",
             .unit = "s",
             .type = 5,
             .rows = {LdWriter::bytes_of_double(7.0), LdWriter::bytes_of_double(7.0 + 1.0 / 60.0)}},
            {.name = "OnTrack", .type = 1, .rows = {std::string(1, '\0'), std::string(1, '\1')}},
            {.name = "Lap", .type = 2, .rows = {int32(3), int32(4)}},
            {.name = "Flags", .unit = "irsdk_Flags", .type = 3, .rows = {int32(1), int32(1)}},
            {.name = "LFtempCM", .unit = "C", .rows = {real(60.5F), real(61.0F)}},
            {.name = "Throttle", .unit = "%", .rows = {real(0.25F), real(1.0F)}},
            {.name = "CarIdxRPM", .count = 2, .rows = {real(1.0F) + real(2.0F), real(3.0F) + real(4.0F)}},
            {.name = "LatAccel_ST",
             .unit = "m/s^2",
             .count = 2,
             .rows = {real(1.0F) + real(2.0F), real(3.0F) + real(4.0F)}}};
}

}  // namespace

// Rows at 60 Hz. A share of 0.25 is 25 %. Bits, lists of cars and lists of times within a row are left out.
TEST(IracingIbt, HasItsChannels) {
    ReadBack file("session.ibt", ibt_file(channels_of_two_rows()));
    ASSERT_TRUE(file.is_open()) << file.messages();
    EXPECT_EQ(file.file().heads().size(), 6U);  // the time and five channels
    EXPECT_EQ(file.file().description().format, "iRacing .ibt");
    ASSERT_FALSE(file.file().description().details.empty());
    EXPECT_EQ(file.file().description().details[0].value, "Road Atlanta");
    EXPECT_EQ(file.column("time", "s", Purpose::clock), (std::vector<double>{0.0, 1.0 / 60.0}));
    EXPECT_EQ(file.column("LFtempCM", "K"), (std::vector<double>{333.65, 334.15}));
    EXPECT_EQ(file.column("Throttle", "1"), (std::vector<double>{0.25, 1.0}));
    EXPECT_EQ(file.column("Lap", "1"), (std::vector<double>{3.0, 4.0}));
    EXPECT_EQ(file.column("OnTrack", "1"), (std::vector<double>{0.0, 1.0}));
}

// Cut anywhere it is refused or has fewer rows; with other numbers in its head it is refused.
TEST(HostileIbt, IsRefusedWithASentence) {
    const std::string whole = ibt_file(channels_of_two_rows());
    for (std::size_t length = 48; length < whole.size(); length += 5) {
        const ReadBack file("session.ibt", whole.substr(0, length));
        EXPECT_TRUE(file.is_open() != !file.messages().empty()) << length;
    }
    for (const auto& [at, said] :
         {std::pair{24, "descriptions of 4294967295 channels"}, std::pair{28, "beyond the end"},
          std::pair{52, "the rows of"}, std::pair{36, "no channel with samples"}}) {
        std::string wrong = whole;
        put(wrong, static_cast<std::size_t>(at), int32(0xFFFFFFFFU));
        const ReadBack file("session.ibt", wrong);
        EXPECT_FALSE(file.is_open()) << at;
        EXPECT_NE(file.messages().find(said), std::string::npos) << file.messages();
    }
}

// Ten thousand channels on the same 8 bytes of a row would be ten thousand times the file in memory. Two are 16 bytes of 8.
TEST(HostileIbt, ChannelsDoNotShareTheirBytes) {
    const IbtChannel channel{.name = "a", .type = 5, .rows = {LdWriter::bytes_of_double(1.0)}};
    std::string shared = ibt_file({channel, channel});
    put(shared, 36, int32(8));             // bytes of a row
    put(shared, 144 + 144 + 4, int32(0));  // place of the second channel
    const ReadBack file("session.ibt", shared);
    EXPECT_FALSE(file.is_open());
    EXPECT_NE(file.messages().find("2 channels need more than a row's 8 bytes"), std::string::npos) << file.messages();
}

}  // namespace tiretherm::input
