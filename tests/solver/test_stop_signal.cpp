// SPDX-License-Identifier: BSD-3-Clause
// An end that is asked for, of the whole program and of one of several computations in it.

#include "solver/stop_signal.hpp"

#include <array>
#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

TEST(StopScope, AskedEndIsItsThreadsAlone) {
    StopScope scope;
    scope.ask();
    EXPECT_TRUE(stop_requested());
    EXPECT_FALSE(is_time_up());
    bool elsewhere = true;
    std::thread([&] { elsewhere = stop_requested(); }).join();
    EXPECT_FALSE(elsewhere);
}

TEST(StopScope, TheNextOneBeginsAfresh) {
    {
        StopScope scope;
        scope.ask();
        stop_after(0.0);
    }
    EXPECT_FALSE(stop_requested());
    const StopScope next;
    EXPECT_FALSE(stop_requested());
}

TEST(StopScope, DeadlineIsItsOwn) {
    stop_after(0.0);
    {
        const StopScope scope;
        EXPECT_FALSE(is_time_up());
        stop_after(0.0);
        EXPECT_TRUE(is_time_up());
    }
    EXPECT_TRUE(is_time_up());
    stop_after(std::numeric_limits<double>::infinity());
    EXPECT_FALSE(stop_requested());
}

// Threads of OpenMP outlive the region and serve the next one, which belongs to nobody.
TEST(StopScope, TasksThatAreSharedOutBelongToIt) {
    std::array<bool, 8> asked{};
    {
        StopScope scope;
        scope.ask();
        in_parallel(
            asked.size(), [&](std::size_t i) { asked[i] = stop_requested(); }, 4);
    }
    for (const bool each : asked) {
        EXPECT_TRUE(each);
    }
    in_parallel(
        asked.size(), [&](std::size_t i) { asked[i] = stop_requested(); }, 4);
    for (const bool each : asked) {
        EXPECT_FALSE(each);
    }
}

}  // namespace

}  // namespace tiretherm::solver
