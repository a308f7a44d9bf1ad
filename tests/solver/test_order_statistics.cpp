// SPDX-License-Identifier: BSD-3-Clause
// Values by their place in the order, beside those of a sorted list.

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "solver/order_statistics.hpp"

namespace tiretherm::solver {

// Whatever the values: even ones, in a few steps as a logger writes them, nearly all within one of 4096 parts of the range, all the
// same, with an infinite one.
TEST(OrderStatistics, SeveralPlacesAreThoseOfTheSortedList) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::vector<std::vector<double>> lists(5);
    for (int i = 0; i < 1000; ++i) {
        const double value = normal(random);
        lists[0].push_back(value);
        lists[1].push_back(std::round(2.0 * value));
        lists[2].push_back(i % 100 == 7 ? 1e9 * value : value);
        lists[3].push_back(21.5);
        lists[4].push_back(i == 400 ? std::numeric_limits<double>::infinity() : value);
    }
    const std::vector<std::size_t> places{0, 199, 399, 400, 799, 999};
    for (const std::vector<double>& list : lists) {
        std::vector<double> sorted = list;
        std::ranges::sort(sorted);
        std::vector<double> expected;
        for (const std::size_t place : places) {
            expected.push_back(sorted[place]);
        }
        EXPECT_EQ(smallest_at(list, places), expected);
    }
    EXPECT_TRUE(smallest_at({}, {}).empty());
}

// 0, 2 and 3 s: steps of 2 and 1 s, the upper of the two. What stands, goes back or is no number is no step.
TEST(OrderStatistics, TheMedianStepIsOfTimesThatGoOn) {
    EXPECT_EQ(median_step({0.0, 2.0, 3.0}), 2.0);
    EXPECT_EQ(median_step({0.0, std::nan(""), 4.0, 4.0, 1.0, 4.0}), 4.0);
    EXPECT_EQ(median_step({5.0, 5.0, 1.0}), 0.0);
}

}  // namespace tiretherm::solver
