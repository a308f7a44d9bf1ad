// SPDX-License-Identifier: BSD-3-Clause
// MoTeC .ld files that were written byte by byte: types, scales, rates of channels, and files that are damaged or hostile.

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "input/laps/file_laps.hpp"
#include "input/loggers/binary_numbers.hpp"
#include "input/loggers/ld_writer.hpp"
#include "input/loggers/read_back.hpp"

namespace tiretherm::input {

namespace {

using made_up::integers;
using made_up::LdChannel;
using made_up::LdWriter;

std::string message_of(const std::string& bytes) {
    const ReadBack file("session.ld", bytes);
    EXPECT_FALSE(file.is_open());
    return file.messages();
}

}  // namespace

// (sample / scale / 10^decimals + shift) multiplier: (250 / 2 / 10 + 3) 4 = 62; (-30 / 2 / 10 + 3) 4 = 6.
TEST(MotecLd, ScalesAsItsRecordSays) {
    LdChannel channel = integers("Tyre Temp FL", "C", 10, {250, -30});
    channel.scale = 2;
    channel.decimals = 1;
    channel.shift = 3;
    channel.multiplier = 4;
    ReadBack file("session.ld", LdWriter::file({channel}));
    const std::vector<double> kelvin = file.column("Tyre Temp FL", "K");
    ASSERT_EQ(kelvin.size(), 2U);
    EXPECT_DOUBLE_EQ(kelvin[0], 62.0 + 273.15);
    EXPECT_DOUBLE_EQ(kelvin[1], 6.0 + 273.15);
    EXPECT_EQ(file.column("time", "s", Purpose::clock), (std::vector<double>{0.0, 0.1}));
    EXPECT_EQ(file.file().description().format, "MoTeC .ld");
    ASSERT_FALSE(file.file().description().details.empty());
    EXPECT_EQ(file.file().description().details[0].value, "16/12/2025");
}

// Each type holds -1.5, or -3 with a scale of 2. Half precision: 0xBE00 is -1.5 (sign, exponent 15, fraction 512).
TEST(MotecLd, ReadsEveryType) {
    LdChannel int32{.name = "int32", .unit = "V", .kind = 5, .size = 4, .scale = 2, .count = 1};
    int32.samples = LdWriter::bytes_of(static_cast<std::uint32_t>(-3));
    LdChannel int16{.name = "int16", .unit = "V", .kind = 0, .size = 2, .scale = 2, .count = 1};
    int16.samples = LdWriter::bytes_of(static_cast<std::uint16_t>(-3));
    LdChannel half{.name = "half", .unit = "V", .kind = 7, .size = 2, .count = 1};
    half.samples = LdWriter::bytes_of(std::uint16_t{0xBE00});
    LdChannel single{.name = "single", .unit = "V", .kind = 7, .size = 4, .count = 1};
    single.samples = LdWriter::bytes_of_float(-1.5F);
    LdChannel twice{.name = "twice", .unit = "V", .kind = 8, .size = 8, .count = 1};
    twice.samples = LdWriter::bytes_of_double(-1.5);
    ReadBack file("session.ld", LdWriter::file({int32, int16, half, single, twice}));
    for (const char* name : {"int32", "int16", "half", "single", "twice"}) {
        EXPECT_EQ(file.column(name, "V"), std::vector<double>{-1.5}) << name;
    }
}

// 80 km/h are 22.2 m/s whether a short name of 8 bytes stands before the unit or not.
TEST(MotecLd, UnitsMayStandInThePlaceOfShortNames) {
    LdChannel speed = integers("Ground Speed", "km/h", 1, {80, 90});
    LdChannel tread = integers("Tyre Temp FL", "C", 1, {60, 61});
    speed.has_short_name = tread.has_short_name = false;
    ReadBack file("session.ld", LdWriter::file({speed, tread}));
    EXPECT_DOUBLE_EQ(file.column("Ground Speed", "m s-1").front(), 80.0 / 3.6);
    EXPECT_EQ(file.column("Tyre Temp FL", "K"), (std::vector<double>{333.15, 334.15}));
}

// Of IEEE 754: 1, the largest 65504, the smallest 2^-24, minus infinity, not a number.
TEST(MotecLd, KnowsTheNumbersOfHalfPrecision) {
    EXPECT_EQ(from_half(0x3C00), 1.0);
    EXPECT_EQ(from_half(0x7BFF), 65504.0);
    EXPECT_EQ(from_half(0x0001), std::ldexp(1.0, -24));
    EXPECT_EQ(from_half(0xFC00), -INFINITY);
    EXPECT_TRUE(std::isnan(from_half(0x7E00)));
}

// At 2 and 3 Hz for a second: rows at 0, 1/3, 1/2, 2/3. Each channel has values at its own times alone.
TEST(MotecLd, KeepsTheTimesOfEachChannel) {
    const std::string bytes =
        LdWriter::file({integers("slow", "V", 2, {10, 11}), integers("fast", "V", 3, {20, 21, 22})});
    ReadBack file("session.ld", bytes);
    EXPECT_EQ(file.column("time", "s", Purpose::clock), (std::vector<double>{0.0, 1.0 / 3.0, 0.5, 2.0 / 3.0}));
    const std::vector<double> slow = file.column("slow", "V");
    const std::vector<double> fast = file.column("fast", "V");
    ASSERT_TRUE(slow.size() == 4U && fast.size() == 4U);
    EXPECT_EQ(slow[0], 10.0);
    EXPECT_EQ(slow[2], 11.0);
    EXPECT_TRUE(std::isnan(slow[1]) && std::isnan(slow[3]) && std::isnan(fast[2]));
    EXPECT_EQ(fast[1], 21.0);
    // With the rows of the slow one alone, the fast one has the mean of the samples nearest to each: 20, and of 21 and 22.
    file.file().choose_rows({1});
    EXPECT_EQ(file.column("slow", "V"), (std::vector<double>{10.0, 11.0}));
    EXPECT_EQ(file.column("fast", "V"), (std::vector<double>{20.0, 21.5}));
}

TEST(MotecLd, HasItsLapsInTheFileBesideIt) {
    const Written written;
    const auto path =
        written.add("session.ld", LdWriter::file({integers("speed", "km/h", 1, std::vector<int>(100, 80))}));
    written.add(
        "session.ldx",
        "<?xml version=\"1.0\"?>\n<LDXFile><Layers><Layer><MarkerBlock><MarkerGroup Name=\"Beacons\">\n"
        "<Marker Version=\"100\" ClassName=\"BCN\" Name=\"Manual.2\" Time=\"6.15e+07\"/>\n"
        "<Marker Version=\"100\" ClassName=\"BCN\" Name=\"Manual.1\" Time=\"3.05e+07\"/>\n</MarkerGroup></LDXFile>");
    InputErrors errors;
    const auto file = DataFile::open(path, {}, errors);
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(file->description().markers, (std::vector<double>{30.5, 61.5}));
}

// Elements that end nowhere: 1e6 bytes of them are looked at once, which takes milliseconds and took half a minute.
TEST(HostileLdx, OfElementsWithoutEndIsReadOnce) {
    const Written written;
    const auto path = written.add("session.ld", LdWriter::file({integers("speed", "km/h", 1, {80, 81})}));
    std::string text;
    while (text.size() < 1'000'000) {
        text += "<Marker ";
    }
    written.add("session.ldx", text + "<Marker ClassName=\"BCN\" Time=\"5e5\"/>");
    InputErrors errors;
    const auto begin = std::chrono::steady_clock::now();
    const auto file = DataFile::open(path, {}, errors);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
    ASSERT_TRUE(file.has_value());
    EXPECT_EQ(file->description().markers, std::vector<double>{0.5});
}

TEST(HostileLd, IsRefusedWithASentence) {
    const LdChannel sound = integers("speed", "km/h", 10, {80, 81, 82});
    EXPECT_NE(message_of(std::string("\x40\0\0\0", 4)).find("ends within the head"), std::string::npos);
    // A record that names itself, and two that name each other.
    LdChannel itself = sound;
    itself.next_override = LdWriter::first_record;
    EXPECT_NE(message_of(LdWriter::file({itself})).find("runs in a circle"), std::string::npos);
    EXPECT_NE(message_of(LdWriter::file({sound, itself})).find("runs in a circle"), std::string::npos);
    // The next record beyond the end, or so near to it that it does not fit.
    LdChannel beyond = sound;
    beyond.next_override = 0xFFFFFFF0;
    EXPECT_NE(message_of(LdWriter::file({beyond})).find("ends within the record of channel 2"), std::string::npos);
    // More samples than there are bytes, also where the product of count and size needs more than 32 bits.
    LdChannel many = sound;
    many.count = 0xFFFFFFFF;
    EXPECT_NE(message_of(LdWriter::file({many})).find("beyond the end of the file"), std::string::npos);
    LdChannel elsewhere = sound;
    elsewhere.data_override = 0xFFFFFFFE;
    EXPECT_NE(message_of(LdWriter::file({elsewhere})).find("beyond the end of the file"), std::string::npos);
    // A thousand channels on the same bytes would be a thousand times the file in memory.
    LdChannel shared = sound;
    shared.data_override = 0;
    shared.count = 600;
    EXPECT_NE(message_of(LdWriter::file({shared, shared})).find("shares its samples"), std::string::npos);
    EXPECT_NE(message_of(LdWriter::file({})).find("no channel"), std::string::npos);
}

// Of another type, without a rate or without a scale: the others are read, and it is said which one is not.
TEST(HostileLd, ChannelsOfAnotherKindAreLeftOut) {
    const LdChannel sound = integers("speed", "km/h", 10, {80, 81, 82});
    LdChannel kind = sound;
    kind.kind = 9;
    LdChannel rate = sound;
    rate.rate = 0;
    LdChannel scale = sound;
    scale.scale = 0;
    LdChannel multiplier = sound;
    multiplier.multiplier = 0;
    for (const auto& [odd, said] : {std::pair{kind, "unknown type 9"}, std::pair{rate, "rate of 0 Hz"},
                                    std::pair{scale, "scale of 0"}, std::pair{multiplier, "multiplier of 0"}}) {
        ReadBack file("session.ld", LdWriter::file({odd, sound}));
        ASSERT_TRUE(file.is_open()) << file.messages();
        EXPECT_EQ(file.file().heads().size(), 2U);  // the time and the sound one
        ASSERT_EQ(file.errors().warnings().size(), 1U);
        EXPECT_NE(file.errors().warnings()[0].what.find(said), std::string::npos) << file.errors().warnings()[0].what;
    }
}

// Cut anywhere, a file is refused or read; never more. Every byte of the head and the records may be the last one.
TEST(HostileLd, MayEndAnywhere) {
    const std::string whole =
        LdWriter::file({integers("speed", "km/h", 10, {80, 81}), integers("load", "N", 5, {4000})});
    for (std::size_t length = 4; length < whole.size(); length += 3) {
        EXPECT_NE(message_of(whole.substr(0, length)), "") << length;
    }
}

}  // namespace tiretherm::input
