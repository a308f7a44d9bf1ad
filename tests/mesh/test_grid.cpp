// SPDX-License-Identifier: BSD-3-Clause
// Cell edges of uniform and graded segments against hand calculation.

#include "mesh/grid.hpp"

#include <gtest/gtest.h>

namespace tiretherm::mesh {

TEST(Edges, OneSegmentOfEqualCellsIsUniform) {
    // 8 mm in 4 cells: edges every 2 mm.
    EXPECT_EQ(edges(0.0, {{.to = 8.0, .cells = 4}}), (std::vector<double>{0.0, 2.0, 4.0, 6.0, 8.0}));
}

TEST(Edges, RatioIsTheLastWidthOverTheFirst) {
    // 3 cells with widths w, 2w, 4w: ratio 4, 7 w = 7.
    const std::vector<double> e = edges(0.0, {{.to = 7.0, .cells = 3, .ratio = 4.0}});
    ASSERT_EQ(e.size(), 4U);
    EXPECT_NEAR(e[1], 1.0, 1e-14);
    EXPECT_NEAR(e[2], 3.0, 1e-14);
    EXPECT_DOUBLE_EQ(e[3], 7.0);
}

TEST(Edges, SegmentsEndExactlyWhereTheySay) {
    const std::vector<double> e =
        edges(-0.03, {{.to = 0.0056419, .cells = 7, .ratio = 0.3}, {.to = 0.03, .cells = 9, .ratio = 5.0}});
    EXPECT_EQ(e[7], 0.0056419);
    EXPECT_EQ(e[16], 0.03);
}

}  // namespace tiretherm::mesh
