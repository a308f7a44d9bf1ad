// SPDX-License-Identifier: BSD-3-Clause
// Numbers and units as an engineer writes them.
#include "post/report/number_text.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace tiretherm::post {
namespace {

// An interval of +-0.34 has two digits of its own at the second place, of +-12 none behind the point.
TEST(NumberText, ANumberHasTheDigitsOfItsInterval) {
    EXPECT_EQ(to_its_digits(8.13642, 0.34), "8.14");
    EXPECT_EQ(to_its_digits(813.642, 12.0), "814");
}

TEST(NumberText, ARangeMayBeOpen) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(range_text("degC", 47.0, 48.0), "47.0 to 48.0");
    EXPECT_EQ(range_text("degC", 60.0, infinity), "> 60.0");
    EXPECT_EQ(range_text("degC", -infinity, 5.0), "< 5.0");
    EXPECT_EQ(range_text("degC", 47.0, 47.0), "47.0");
}

TEST(NumberText, UnitsHaveAFractionBarForNegativePowers) {
    EXPECT_EQ(slashed_unit("W m-2 K-1"), "W/(m2 K)");
    EXPECT_EQ(slashed_unit("N-1"), "1/N");
    EXPECT_EQ(slashed_unit("kg m2"), "kg m2");
    EXPECT_EQ(difference_unit("degC"), "K");
    EXPECT_EQ(difference_unit("kPa"), "kPa");
}

TEST(NumberText, ZeroHasNoSignAndNamesHaveBlanks) {
    EXPECT_EQ(without_sign_of_zero("-0.00"), "0.00");
    EXPECT_EQ(without_sign_of_zero("-0.01"), "-0.01");
    EXPECT_EQ(in_words("outside_shoulder"), "outside shoulder");
}

}  // namespace
}  // namespace tiretherm::post
