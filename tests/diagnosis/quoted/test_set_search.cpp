// SPDX-License-Identifier: BSD-3-Clause
// Search over sets of additions, by hand: costs from a table.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "diagnosis/quoted/set_search.hpp"

namespace tiretherm::diagnosis::quoted {
namespace {

/// A search whose costs stand in a table; what does not stand there costs 9.
SetSearch search_in(const std::map<AdditionSet, double>& costs, std::size_t n) {
    SetSearch search;
    for (std::size_t a = 0; a < n; ++a) {
        search.pool.push_back(a);
    }
    search.most = 5;
    search.are_one_cause = [](std::size_t, std::size_t) { return false; };
    search.cost = [&costs](const AdditionSet& set) {
        const auto found = costs.find(set);
        return found == costs.end() ? 9.0 : found->second;
    };
    return search;
}

AdditionSet sorted(AdditionSet set) {
    std::ranges::sort(set);
    return set;
}

}  // namespace

// 0 is the best alone, and 1 with 2, of which neither is any good alone, is the best pair: 0 with 1 costs 7, then 0 is exchanged.
// A third makes it worse.
TEST(SetSearch, ExchangesTheFirstForAPairOfWhichNeitherIsGoodAlone) {
    const std::map<AdditionSet, double> costs{{{}, 8.5}, {{0}, 8.0}, {{0, 1}, 7.0}, {{1, 2}, 2.0}};
    const std::vector<AdditionSet> best = best_sets(search_in(costs, 3));
    ASSERT_EQ(best.size(), 3U);
    EXPECT_EQ(best[1], AdditionSet{0});
    EXPECT_EQ(sorted(best[2]), (AdditionSet{1, 2}));
    SetSearch adds_only = search_in(costs, 3);
    adds_only.looks_back = false;
    EXPECT_EQ(sorted(best_sets(adds_only)[2]), (AdditionSet{0, 1}));
}

// No single one is better than nothing (9 and more beside 8.5), two are: the search goes on to two all the same.
TEST(SetSearch, TriesTwoWhereNoSingleOneHelps) {
    const std::map<AdditionSet, double> costs{{{}, 8.5}, {{1, 2}, 2.0}};
    EXPECT_EQ(sorted(best_sets(search_in(costs, 3)).back()), (AdditionSet{1, 2}));
}

// Exchanges lead from {0, 1, 2} by {0, 2, 3} to {0, 3, 4}. There the first, 0, is superfluous: dropped it leaves a better pair than
// {0, 1} was, which no exchange of one finds.
TEST(SetSearch, DropsWhatLaterOnesMakeSuperfluous) {
    const std::map<AdditionSet, double> costs{{{}, 8.5},        {{0}, 7.0},       {{0, 1}, 6.0}, {{0, 1, 2}, 5.0},
                                              {{0, 2, 3}, 4.5}, {{0, 3, 4}, 3.0}, {{3, 4}, 3.2}};
    SetSearch search = search_in(costs, 5);
    search.most = 3;
    const std::vector<AdditionSet> best = best_sets(search);
    ASSERT_EQ(best.size(), 4U);
    EXPECT_EQ(sorted(best[2]), (AdditionSet{3, 4}));
    EXPECT_EQ(sorted(best[3]), (AdditionSet{0, 3, 4}));
    search.is_enough = [](const AdditionSet& set) { return sorted(set) == AdditionSet{3, 4}; };
    EXPECT_EQ(best_sets(search).size(), 3U);  // then no third is asked for
}

TEST(SetSearch, EndsWhereASetIsEnoughOrCausesDoNotGoTogether) {
    const std::map<AdditionSet, double> costs{{{}, 8.5}, {{0}, 7.0}, {{0, 1}, 5.0}, {{0, 1, 2}, 3.0}};
    SetSearch search = search_in(costs, 3);
    search.is_enough = [](const AdditionSet& set) { return set.size() == 2; };
    EXPECT_EQ(best_sets(search).size(), 3U);
    search.are_one_cause = [](std::size_t a, std::size_t b) { return a + b == 1; };
    EXPECT_NE(sorted(best_sets(search).back()), (AdditionSet{0, 1}));
}

}  // namespace tiretherm::diagnosis::quoted
