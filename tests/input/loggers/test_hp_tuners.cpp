// SPDX-License-Identifier: BSD-3-Clause
// Logs of HP Tuners' VCM Scanner, made up after what its exports look like.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "input/loggers/read_back.hpp"

namespace tiretherm::input {

namespace {

constexpr std::string_view hp_tuners_head =
    "HP Tuners CSV Log File\nVersion: 1.0\n\n[Log Information]\nCreation Time: 7/12/2026 10:11:12 AM\nNotes: \n\n"
    "[Channel Information]\n";
constexpr std::string_view hp_tuners_channels =
    "0,13,161,6101,6101\nOffset,Vehicle Speed (SAE),Ambient Air Temp (SAE),Analog,Analog\ns,mph,\u00B0F,V,psi\n\n";

}  // namespace

// The channels stand in one section, their values in another. 60 mph are 26.8224 m/s, 212 degF are 373.15 K, 10 psi 68 947.57 Pa.
TEST(HpTuners, HasNamesAndValuesInTwoSections) {
    ReadBack file("log.csv", std::string(hp_tuners_head) + std::string(hp_tuners_channels) +
                                 "[Channel Data]\n0.000,60,212,1.5,10\n0.053,,212,1.5,10\n0.103,60,212,1.5,oil\n");
    ASSERT_TRUE(file.is_open()) << file.messages();
    EXPECT_EQ(file.file().description().format, "HP Tuners CSV");
    ASSERT_EQ(file.file().description().details.size(), 2U);
    EXPECT_EQ(file.file().description().details[1].name, "Creation Time");
    EXPECT_EQ(file.file().description().details[1].value, "7/12/2026 10:11:12 AM");
    EXPECT_EQ(file.column("time", "s", Purpose::clock), (std::vector<double>{0.0, 0.053, 0.103}));
    EXPECT_DOUBLE_EQ(file.column("Vehicle Speed (SAE)", "m s-1").back(), 26.8224);
    EXPECT_DOUBLE_EQ(file.column("Ambient Air Temp (SAE)", "K").front(), 373.15);
    EXPECT_EQ(file.column("Analog", "V").front(), 1.5);
    // A wrong field has its line: three of the data after the 13 lines above them.
    EXPECT_TRUE(
        file.file()
            .read({{.column = 4, .name = "oil", .spec = {.unit = "Pa"}, .purpose = Purpose::measured}}, file.errors())
            .empty());
    ASSERT_EQ(file.errors().count(), 1U);
    EXPECT_EQ(file.errors().in_order().front().line, 16);
    EXPECT_EQ(file.errors().in_order().front().source, "0.103,60,212,1.5,oil");
}

TEST(HpTuners, WithoutASectionIsRefused) {
    for (const auto& [text, section] :
         {std::pair{std::string(hp_tuners_head) + std::string(hp_tuners_channels), "[Channel Data]"},
          std::pair{std::string("HP Tuners CSV Log File\nVersion: 1.0\n[Channel Data]\n0,1\n"),
                    "[Channel Information]"}}) {
        const ReadBack file("log.csv", text);
        EXPECT_FALSE(file.is_open());
        EXPECT_EQ(file.messages(), fmt::format("the HP Tuners file has no section {} | export the log again, as CSV: "
                                               "[Channel Information] and [Channel Data] follow the head\n",
                                               section));
    }
}

}  // namespace tiretherm::input
