// SPDX-License-Identifier: BSD-3-Clause
// Loops and tasks in threads: sums have the same digits for any number of threads, what is thrown comes out, tasks of a task are
// shared, its loops stay on its thread.

#include "mesh/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/threads.hpp"

namespace tiretherm {
namespace {

/// 1, 1/2, 1/3 ...: summed up in another order, they have other last digits.
std::vector<double> harmonic(std::size_t n) {
    std::vector<double> terms(n);
    for (std::size_t i = 0; i < n; ++i) {
        terms[i] = 1.0 / static_cast<double>(i + 1);
    }
    return terms;
}

constexpr std::size_t many = 100 * least_of_range;

/// Threads that take part in a long loop, which each of its rounds gives time to come.
std::size_t threads_of_loop() {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    Team::with(many, [&] {
        over_ranges(many, [&](std::size_t, std::size_t, std::size_t) {
            std::this_thread::sleep_for(std::chrono::milliseconds(3));
            const std::scoped_lock lock(mutex);
            threads.insert(std::this_thread::get_id());
        });
    });
    return threads.size();
}

TEST(Parallel, SumsHaveTheSameDigitsForAnyNumberOfThreads) {
    // ln n + 0.5772... + 1/2n is the sum to 1/12n2; all numbers are below 12, so that 1e5 additions err by less than 1e-10.
    const std::vector<double> terms = harmonic(100000);
    std::set<double> sums;
    for (const int threads : {1, 2, 3, 5}) {
        const support::Threads now(threads);
        Team::with(terms.size(), [&] { sums.insert(sum_of(terms)); });
    }
    ASSERT_EQ(sums.size(), 1U);
    EXPECT_NEAR(*sums.begin(), std::log(1e5) + 0.57721566490153286 + 0.5e-5, 1e-10);
    EXPECT_NE(*sums.begin(), std::accumulate(terms.begin(), terms.end(), 0.0));  // else the order would not show
}

// 0 to n - 1 are summed without rounding: n (n - 1)/2, whatever is left over behind the last four.
TEST(Parallel, AFoldSideBySideTakesEachOnce) {
    const auto take = [](double sum, std::size_t i) { return sum + static_cast<double>(i); };
    const auto join = [](double a, double b) { return a + b; };
    for (const std::size_t n : {0UL, 1UL, 3UL, 4UL, 5UL, 1023UL}) {
        const auto terms = static_cast<double>(n);
        EXPECT_EQ(fold_side_by_side(0, n, 0.0, take, join), n == 0 ? 0.0 : 0.5 * terms * (terms - 1.0)) << n;
    }
}

TEST(Parallel, LargestIsTheFirstOfThoseThatAreEqual) {
    std::vector<double> values(50000, 1.0);
    values[700] = values[40000] = 2.0;
    const support::Threads now(3);
    Largest most;
    Team::with(values.size(),
               [&] { most = largest_over_nodes(values.size(), [&](std::size_t i) { return values[i]; }); });
    EXPECT_EQ(most.value, 2.0);
    EXPECT_EQ(most.place, 700U);
}

TEST(Parallel, EveryNodeIsVisitedOnce) {
    const support::Threads now(3);
    for (const std::size_t n : {0UL, 1UL, least_of_range, least_shared - 1, least_shared, 123457UL}) {
        std::vector<int> visits(n);
        Team::with(many, [&] { over_nodes(n, [&](std::size_t i) { ++visits[i]; }); });
        EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), std::ssize(visits)) << n;
    }
}

// Loops as short and as many as those of a solution by iteration, also where there are more threads than cores: none is lost, and each
// sees what the one before it wrote.
TEST(Parallel, ManyShortLoopsFollowOneAnother) {
    for (const int threads : {2, 3, 8}) {
        const support::Threads now(threads);
        std::vector<long> before(16, 0);
        std::vector<long> after(16, 0);
        constexpr long rounds = 20000;
        Team::with(many, [&] {
            for (long round = 0; round < rounds; ++round) {
                split_loop(0, 16, true, [&](std::size_t i) { after[i] = before[(i + 1) % 16] + 1; });
                std::swap(before, after);
            }
        });
        EXPECT_EQ(before, std::vector<long>(16, rounds)) << threads;
    }
}

TEST(Parallel, WhatIsThrownBetweenLoopsComesOut) {
    const support::Threads now(2);
    const auto fail = [] { throw std::runtime_error("between loops"); };
    EXPECT_THROW(Team::with(many, fail), std::runtime_error);
    EXPECT_EQ(Team::of_this_thread(), nullptr);
}

TEST(Parallel, WhatATaskThrowsComesOutAndNothingMoreIsBegun) {
    for (const unsigned threads : {1U, 2U, 3U}) {
        std::atomic<int> begun = 0;
        const auto work = [&](std::size_t i) {
            ++begun;
            if (i == 4) {
                throw std::runtime_error("the fifth");
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        };
        try {
            in_parallel(1000, work, threads);
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "the fifth");
        }
        // All before it, it, and what the other threads had begun or were about to while it was thrown.
        EXPECT_GE(begun, 5);
        EXPECT_LT(begun, 100);
    }
}

TEST(Parallel, LoopInsideATaskStaysOnItsThread) {
    std::vector<std::size_t> threads(2);
    in_parallel(
        2, [&](std::size_t i) { threads[i] = threads_of_loop(); }, 2);
    EXPECT_EQ(threads, (std::vector<std::size_t>{1, 1}));
}

// Two tasks, the second of which has thirty tasks of its own: the thread that is through with the first takes part in them.
TEST(Parallel, TasksOfATaskAreSharedWithWhoeverIsFree) {
    const support::Threads now(2);
    std::mutex mutex;
    std::set<std::thread::id> threads;
    std::vector<int> done(30);
    const auto inner = [&](std::size_t i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const std::scoped_lock lock(mutex);
        ++done[i];
        threads.insert(std::this_thread::get_id());
    };
    in_parallel(2, [&](std::size_t i) {
        if (i == 1) {
            in_parallel(done.size(), inner);
        }
    });
    EXPECT_EQ(done, std::vector<int>(30, 1));
    EXPECT_EQ(threads.size(), 2U);
}

// One of two threads has a task that ends when seven others, which have tasks of their own, are through: the other thread, whichever
// it is, must not wait for it in any of them.
TEST(Parallel, ATaskWaitsForItsOwnTasksAlone) {
    const support::Threads now(2);
    for (const std::size_t last : {0UL, 1UL}) {
        std::atomic<int> through = 0;
        int seen = 0;
        in_parallel(9, [&](std::size_t i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));  // both threads have one of the first two
            if (i == last) {
                const auto start = std::chrono::steady_clock::now();
                while (through < 7 && std::chrono::steady_clock::now() - start < std::chrono::seconds(20)) {
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                }
                seen = through;
                return;
            }
            in_parallel(2, [&](std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
            ++through;
        });
        EXPECT_GE(seen, 7) << last;
    }
}

TEST(Parallel, WhatATaskOfATaskThrowsComesOut) {
    const support::Threads now(3);
    std::atomic<int> caught = 0;
    const auto fail = [](std::size_t i) {
        if (i == 2) {
            throw std::runtime_error("inside");
        }
    };
    const auto try_it = [&](std::size_t) {
        try {
            in_parallel(5, fail);
        } catch (const std::runtime_error&) {
            ++caught;
        }
    };
    in_parallel(4, try_it);
    EXPECT_EQ(caught, 4);
    EXPECT_THROW(in_parallel(4, [&](std::size_t) { in_parallel(5, fail); }), std::runtime_error);
}

TEST(Parallel, TheThreadsThatAreAskedForAreForATaskThatIsAlone) {
    const support::Threads now(3);
    std::size_t threads = 0;
    const auto count = [&](std::size_t) { threads = threads_of_loop(); };
    in_parallel(1, count, 2);
    EXPECT_EQ(threads, 2U);
    in_parallel(4, count, 1);
    EXPECT_EQ(threads, 1U);
    EXPECT_EQ(threads_of_loop(), 3U);
    EXPECT_EQ(threads_for(10), 3);
    EXPECT_EQ(threads_for(2, 8), 2);
    EXPECT_EQ(threads_for(0, 8), 1);
}

}  // namespace
}  // namespace tiretherm
