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
