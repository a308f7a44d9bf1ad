// SPDX-License-Identifier: BSD-3-Clause
// Between two points, on one, and beyond the ends.
#include "physics/bracket.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace tiretherm::physics {
namespace {

double line_at(double x) {
    const std::vector<double> at{0.0, 2.0, 6.0};
    const std::vector<double> value{10.0, 20.0, 0.0};
    return bracket(at, x).between([&](std::size_t i) { return value[i]; });
}

// A quarter of the way from 2 to 6 a quarter of the way from 20 to 0: 15.
TEST(Bracket, IsOnTheStraightLineBetweenTwoPoints) {
    EXPECT_DOUBLE_EQ(line_at(1.0), 15.0);
    EXPECT_DOUBLE_EQ(line_at(3.0), 15.0);
    EXPECT_EQ(line_at(2.0), 20.0);
}

TEST(Bracket, HoldsTheEnds) {
    EXPECT_EQ(line_at(-5.0), 10.0);
    EXPECT_EQ(line_at(6.0), 0.0);
    EXPECT_EQ(line_at(100.0), 0.0);
}

// Beyond the last of the points an infinite value stays one, and one point alone is both ends.
TEST(Bracket, OfOnePointIsThatPoint) {
    const std::vector<double> at{1.0};
    for (const double x : {0.0, 1.0, 2.0}) {
        EXPECT_EQ(bracket(at, x).between([](std::size_t) { return std::numeric_limits<double>::infinity(); }),
                  std::numeric_limits<double>::infinity());
    }
}

}  // namespace
}  // namespace tiretherm::physics
