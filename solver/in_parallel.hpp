// SPDX-License-Identifier: BSD-3-Clause
// Runs independent tasks on several threads; a free thread takes the next task in order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace tiretherm::solver {

/// Does something n times, several at a time, each begun when a thread is free, in the order of its number. It must not
/// throw.   @param threads 0: as many as the machine has
template <typename Work>
void in_parallel(std::size_t n, const Work& work, unsigned threads = 0) {
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
        for (std::size_t i = next++; i < n; i = next++) {
            work(i);
        }
    };
    const std::size_t wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min(wanted, n); ++i) {
        others.emplace_back(take);
    }
    take();
}

}  // namespace tiretherm::solver
