// SPDX-License-Identifier: BSD-3-Clause
// Maps: borders lie halfway, signed scales have 0 in the middle, what is no number is left out.

#include "post/page/cell_chart.hpp"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tiretherm::post {
namespace {

using Json = nlohmann::json;

// 80, 100, 140: halfway 90 and 120; the first is as far below 80 as 90 is above, the last as far above 140 as 120 is below.
TEST(CellChart, BordersLieHalfwayBetweenValues) {
    EXPECT_EQ(borders_between({80.0, 100.0, 140.0}), (std::vector<double>{70.0, 90.0, 120.0, 160.0}));
    EXPECT_EQ(borders_between({5.0}), (std::vector<double>{4.5, 5.5}));
}

TEST(CellChart, ASignedScaleReachesAsFarBelowZeroAsAbove) {
    const std::vector<MapCell> cells{{0.0, 1.0, 0.0, 1.0, -3.0}, {1.0, 2.0, 0.0, 1.0, 2.0}};
    const Json chart = Json::parse(
        compact_json(cell_chart({.name = "time"}, {.name = "place"}, {.name = "heat", .is_signed = true}, cells)));
    EXPECT_EQ(chart["low"], -3.0);
    EXPECT_EQ(chart["high"], 3.0);
    const Json plain = Json::parse(compact_json(cell_chart({.name = "time"}, {.name = "place"}, {.name = "T"}, cells)));
    EXPECT_EQ(plain["low"], -3.0);
    EXPECT_EQ(plain["high"], 2.0);
}

TEST(CellChart, CellsWithoutANumberAreLeftOutAndMarksStay) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const std::vector<MapCell> cells{{0.0, 1.0, 0.0, 1.0, none}, {1.0, 2.0, 0.0, 1.0, 2.0, true}};
    const Json chart = Json::parse(compact_json(cell_chart({.name = "x"}, {.name = "y"}, {.name = "T"}, cells)));
    ASSERT_EQ(chart["cells"].size(), 1u);
    EXPECT_EQ(chart["cells"][0]["at"], Json::parse("[1.0,2.0,0.0,1.0,2.0]"));
    EXPECT_EQ(chart["cells"][0]["marked"], true);
}

}  // namespace
}  // namespace tiretherm::post
