// SPDX-License-Identifier: BSD-3-Clause
// The history of a hot spot, and when it passes what a part can bear.
#include "solver/hot_spot/hot_spot.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "mesh/builders.hpp"

namespace tiretherm::solver {

// 340 K between 330 K at 100 s and 350 K at 200 s: half-way, 150 s, with the surface at 305 K.
TEST(HotSpotHistory, PassesBetweenItsRows) {
    const mesh::Mesh mesh =
        mesh::build(mesh::TwoNode{.area = 0.5, .surface_volume = 1e-3, .bulk_volume = 5e-3, .bulk_depth = 0.01});
    HotSpotHistory history(mesh, {.name = "bulk",
                                  .temperature = 340.0,
                                  .nodes = {1},
                                  .surface_name = "surface",
                                  .surface = {.nodes = {0}, .weights = {1.0}}});
    const std::vector<std::vector<double>> rows{{300.0, 310.0}, {302.0, 330.0}, {308.0, 350.0}, {306.0, 320.0}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Snapshot now;
        now.time = 100.0 * static_cast<double>(i);
        now.temperature = rows[i];
        history.take(now);
    }
    EXPECT_NEAR(passing_time(history.time(), history.temperature(), 340.0), 150.0, 1e-9);
    EXPECT_NEAR(value_at(history.time(), history.surface(), 150.0), 305.0, 1e-9);
    EXPECT_EQ(history.hottest_row(), 2U);
    EXPECT_NEAR(history.hottest_place()(rows[2]), 350.0, 1e-12);
    EXPECT_TRUE(std::isnan(passing_time(history.time(), history.temperature(), 351.0)));
    EXPECT_DOUBLE_EQ(passing_time(history.time(), history.temperature(), 305.0), 0.0);
}

// 360 K is reached to 3 mK at 100 s and exactly at 300 s: a plateau is identified by when it was reached.
TEST(HotSpotHistory, PlateauIsHottestWhereItIsReached) {
    const mesh::Mesh mesh =
        mesh::build(mesh::TwoNode{.area = 0.5, .surface_volume = 1e-3, .bulk_volume = 5e-3, .bulk_depth = 0.01});
    HotSpotHistory history(mesh, {.name = "bulk", .temperature = 370.0, .nodes = {1}});
    for (const double T : {300.0, 359.997, 359.999, 360.0}) {
        const std::vector<double> field{300.0, T};
        Snapshot now;
        now.time = 100.0 * static_cast<double>(history.rows());
        now.temperature = field;
        history.take(now);
    }
    EXPECT_EQ(history.hottest_row(), 1U);
    EXPECT_TRUE(std::isnan(history.surface()[0]));
}

}  // namespace tiretherm::solver
