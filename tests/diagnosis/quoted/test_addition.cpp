// SPDX-License-Identifier: BSD-3-Clause
// Additions to a model: values that are simulated, cubics between them, what a value costs, and names.
#include "diagnosis/quoted/addition.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace tiretherm::diagnosis::quoted {
namespace {

/// A number between 0 and 10 that is absent at 2, and changes one row by its square.
Addition squared() {
    Addition addition{
        .kind = AdditionKind::number, .id = "effect", .key = "k", .absent = 2.0, .low = 0.0, .high = 10.0};
    addition.nodes = {0.0, 2.0, 5.0, 10.0};
    for (const double node : addition.nodes) {
        addition.changes.push_back({node * node});
    }
    return addition;
}

// 0.4 and 1 of the way from 2 to 0 and from 2 to 10: 1.2, 0 and 5.2, 10.
TEST(QuotedAddition, IsSimulatedAtBothEndsAndOnTheWayToThem) {
    const std::vector<double> nodes = trial_nodes(2.0, 0.0, 10.0);
    const std::vector<double> expected{0.0, 1.2, 2.0, 5.2, 10.0};
    ASSERT_EQ(nodes.size(), expected.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_NEAR(nodes[i], expected[i], 1e-12);
    }
    // Absent at an end: nothing stands there twice.
    EXPECT_EQ(trial_nodes(0.0, 0.0, 10.0).size(), 3U);
}

// The slopes at the nodes are those of parabolas, so that a parabola is followed exactly everywhere.
TEST(QuotedAddition, BetweenTheNodesAParabolaIsExact) {
    const Addition addition = squared();
    const std::vector<std::vector<double>> table = addition.table();
    ASSERT_EQ(table.size(), Addition::n_values);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double x = addition.value(i);
        EXPECT_NEAR(table[i][0], x * x, 1e-9) << x;
    }
    EXPECT_DOUBLE_EQ(addition.value(Addition::n_values - 1), 10.0);
}

// The range is two standard deviations to either side: at its ends chi squared pays 4, half the way up 1, and nothing where the
// number changes nothing.
TEST(QuotedAddition, AValueCostsByItsPlausibleRange) {
    const Addition addition = squared();
    EXPECT_EQ(addition.penalty(2.0), 0.0);
    EXPECT_DOUBLE_EQ(addition.penalty(10.0), 4.0);
    EXPECT_DOUBLE_EQ(addition.penalty(0.0), 4.0);
    EXPECT_DOUBLE_EQ(addition.penalty(6.0), 1.0);
    Addition mesh{.kind = AdditionKind::mesh, .id = "section", .what = "section"};
    EXPECT_EQ(mesh.penalty(1.0), 0.0);
}

TEST(QuotedAddition, IsNamedByWhatItChanges) {
    Addition addition = squared();
    EXPECT_EQ(addition.name(), "effect.k");
    addition.what = "critical_speed = 125 km/h";
    EXPECT_EQ(addition.name(), "effect.k (critical_speed = 125 km/h)");
    EXPECT_EQ((Addition{.kind = AdditionKind::input, .id = "hall"}.name()), "input hall");
    EXPECT_EQ((Addition{.kind = AdditionKind::instrument, .id = "bulk_temperature", .key = "offset"}.name()),
              "offset of bulk_temperature");
    // Another number of the same effect is the same cause.
    Addition other = squared();
    other.key = "c";
    EXPECT_TRUE(other.is_same_cause(addition));
    other.id = "another";
    EXPECT_FALSE(other.is_same_cause(addition));
}

}  // namespace
}  // namespace tiretherm::diagnosis::quoted
