// SPDX-License-Identifier: BSD-3-Clause
// What may stand on a sidewall, and what may not.
#include <gtest/gtest.h>

#include "input/tire_property_file/tire_size.hpp"

namespace tiretherm::input {
namespace {

TireSize read_size(std::string_view text) {
    const auto size = read_tire_size(text);
    EXPECT_TRUE(std::holds_alternative<TireSize>(size)) << text;
    return std::holds_alternative<TireSize>(size) ? std::get<TireSize>(size) : TireSize{};
}

// H = 0.5 * 225 mm, rim 17 * 25.4 mm, R = 215.9 + 112.5 mm.
TEST(TireSize, PassengerTireHasItsDimensions) {
    const TireSize size = read_size("225/50 R17");
    EXPECT_EQ(size.text, "225/50 R17");
    EXPECT_NEAR(size.width, 0.225, 1e-12);
    EXPECT_NEAR(size.section_height, 0.1125, 1e-12);
    EXPECT_NEAR(size.rim_diameter, 0.4318, 1e-12);
    EXPECT_NEAR(size.radius(), 0.3284, 1e-12);
    EXPECT_EQ(size.aspect_ratio, 50.0);
    EXPECT_FALSE(size.light_truck);
}

TEST(TireSize, SpellingsOfOneSizeAreAlike) {
    for (const std::string_view text :
         {"225/50R17", " P225/50 ZR17 94W", "225/50-17", "225 / 50 r 17", "T225/50 R17"}) {
        EXPECT_NEAR(read_size(text).radius(), 0.3284, 1e-12) << text;
        EXPECT_FALSE(read_size(text).light_truck) << text;
    }
    EXPECT_NEAR(read_size("315/80 R22.5").rim_diameter, 0.5715, 1e-12);
}

TEST(TireSize, LightTruckTiresAreMarked) {
    EXPECT_TRUE(read_size("265/65 R16C").light_truck);
    EXPECT_TRUE(read_size("265/65 R16C 112/110R").light_truck);
    EXPECT_TRUE(read_size("LT265/70 R17").light_truck);
}

// ETRTO writes the widths of passenger tires with a 5 at the end and those of motorcycle tires with a 0; 120 mm is a front, 250 kPa.
TEST(TireSize, MotorcycleTiresHaveWidthsInWholeCentimetres) {
    for (const std::string_view text :
         {"120/70 ZR17", "190/55 ZR17 (75W)", "130/90-16 67H", "120/70 ZR17 M/C (58W)", "185/55 R17M/C 73W"}) {
        EXPECT_TRUE(read_size(text).motorcycle) << text;
        EXPECT_FALSE(read_size(text).light_truck) << text;
    }
    EXPECT_EQ(read_size("120/70 ZR17 M/C (58W)").service.value().load_index, 58);
    EXPECT_EQ(read_size("120/70 ZR17").load_pressure(), 250e3);
    EXPECT_EQ(read_size("190/55 ZR17").load_pressure(), 290e3);
    // A car's, a spare wheel, a van's, a tractor's, a truck's.
    for (const std::string_view text : {"225/50 R17", "T120/70 R14", "200/60 R16C", "320/85 R24", "200/60-14.5"}) {
        EXPECT_FALSE(read_size(text).motorcycle) << text;
    }
}

TEST(TireSize, ServiceDescriptionMayStandBehind) {
    EXPECT_FALSE(read_size("225/50 R17").service);
    ASSERT_TRUE(read_size("225/50 R17 94H").service);
    EXPECT_EQ(read_size("225/50 R17 94H").service->load_index, 94);
    EXPECT_EQ(read_size("225/50 R17 94H").service->speed_symbol, 'H');
    EXPECT_EQ(read_size("265/65 R16C 112/110R").service->load_index, 112);
    EXPECT_EQ(read_size("265/65 R16C 112/110R").service->speed_symbol, 'R');
    EXPECT_EQ(read_size("225/50 R17 94").service->speed_symbol, ' ');
    EXPECT_FALSE(read_size("225/50 R17 XL").service);
}

// Outer diameter and rim in inches leave the height: (31 - 15)/2 = 8 in, (16 - 10)/2 = 3 in, of an aircraft's 22x5.5 on 12 in 5 in.
// 11R22.5: 0.86 of 279.4 mm; 7.50R16: as high as wide. A racing tire's 660 mm on 18 in: (660 - 457.2)/2 = 101.4 mm.
TEST(TireSize, InchesAndOuterDiametersAreRead) {
    struct Expected {
        std::string_view text;
        double width, height, rim;  // mm, mm, in
    };
    for (const auto& [text, width, height, rim] :
         {Expected{"31x10.50R15LT", 266.7, 203.2, 15}, Expected{"LT31X10.50 R15", 266.7, 203.2, 15},
          Expected{"16.0x7.5-10", 190.5, 76.2, 10}, Expected{"20.5 x 7.0-13", 177.8, 95.25, 13},
          Expected{"10x4.50-5", 114.3, 63.5, 5}, Expected{"22x5.5", 139.7, 127.0, 12},
          Expected{"18x4.4", 111.76, 101.6, 10}, Expected{"H44.5x16.5-21", 419.1, 298.45, 21},
          Expected{"7.2/20.0-13", 182.88, 88.9, 13}, Expected{"11R22.5", 279.4, 240.284, 22.5},
          Expected{"11 R 22.5 146/143L", 279.4, 240.284, 22.5}, Expected{"7.50R16", 190.5, 190.5, 16},
          Expected{"18.4R38", 467.36, 397.256, 38}, Expected{"165SR13", 165, 132, 13},
          Expected{"185R14C 102/100Q", 185, 148, 14}, Expected{"305/660-18", 305, 101.4, 18},
          Expected{"P225/45ZR17 (91Y)", 225, 101.25, 17}, Expected{"ST205/75R15", 205, 153.75, 15}}) {
        const TireSize size = read_size(text);
        EXPECT_NEAR(1e3 * size.width, width, 1e-6) << text;
        EXPECT_NEAR(1e3 * size.section_height, height, 1e-6) << text;
        EXPECT_NEAR(size.rim_diameter / 0.0254, rim, 1e-9) << text;
    }
    EXPECT_TRUE(read_size("31x10.50R15LT").light_truck);
    EXPECT_FALSE(read_size("31x10.50R15LT").truck);
    EXPECT_TRUE(read_size("11R22.5").truck);
    EXPECT_FALSE(read_size("16.0x7.5-10").light_truck);
    EXPECT_EQ(read_size("22x5.5").assumption, "a rim of 12 in, as aircraft tires of type VII have");
    EXPECT_EQ(read_size("11R22.5").assumption, "a section 86 % as high as wide, which the size does not say");
    EXPECT_EQ(read_size("31x10.50R15LT").assumption, "");
    EXPECT_EQ(read_size("LT245/75R16 120/116S").service->load_index, 120);
    EXPECT_EQ(read_size("31x10.50R15LT 109Q").service->speed_symbol, 'Q');
    EXPECT_EQ(read_size("P225/45ZR17 (91Y)").service->speed_symbol, 'Y');
    EXPECT_EQ(read_size("215/60 R16 104/101R").service->load_index, 104);
}

TEST(TireSize, OtherTextsAreRefusedWithAnExample) {
    for (const std::string_view text :
         {"", "225", "225/50", "225/50 X17", "22.5/50 R17", "225/500 R17", "225/50 R170"}) {
        const auto size = read_tire_size(text);
        ASSERT_TRUE(std::holds_alternative<ErrorText>(size)) << text;
        EXPECT_NE(std::get<ErrorText>(size).remedy.find("\"225/50 R17\""), std::string::npos);
    }
}

}  // namespace
}  // namespace tiretherm::input
