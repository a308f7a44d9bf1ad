// SPDX-License-Identifier: BSD-3-Clause
// Patterns with * and ?.

#include <gtest/gtest.h>

#include "input/files/wildcard.hpp"

namespace tiretherm::input {

TEST(Wildcard, WithoutStarOnlyTheNameItself) {
    EXPECT_TRUE(matches("throttle", "throttle"));
    EXPECT_FALSE(matches("throttle", "throttle_2"));
    EXPECT_FALSE(matches("throttle_2", "throttle"));
    EXPECT_FALSE(matches("Throttle", "throttle"));
    EXPECT_TRUE(matches("", ""));
    EXPECT_FALSE(matches("", "x"));
}

TEST(Wildcard, AStarIsAnythingOrNothing) {
    EXPECT_TRUE(matches("ir_*", "ir_1"));
    EXPECT_TRUE(matches("ir_*", "ir_"));
    EXPECT_FALSE(matches("ir_*", "air_1"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_TRUE(matches("*temp*", "brake_temperature"));
    // The first place where the middle fits is not the one that lets the end fit.
    EXPECT_TRUE(matches("*ab*b", "abcabb"));
    EXPECT_TRUE(matches("a*b*c", "a_b_b_c"));
    EXPECT_FALSE(matches("a*b*c", "a_c_b"));
}

TEST(Wildcard, AQuestionMarkIsOneCharacter) {
    EXPECT_TRUE(matches("ir_?", "ir_1"));
    EXPECT_FALSE(matches("ir_?", "ir_"));
    EXPECT_FALSE(matches("ir_?", "ir_12"));
    EXPECT_TRUE(matches("?*", "x"));
    EXPECT_FALSE(matches("?*", ""));
}

TEST(Wildcard, APatternHasAStarOrAQuestionMark) {
    EXPECT_TRUE(is_pattern("ir_*"));
    EXPECT_TRUE(is_pattern("ir_?"));
    EXPECT_FALSE(is_pattern("ir_1"));
}

}  // namespace tiretherm::input
