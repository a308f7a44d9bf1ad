// SPDX-License-Identifier: BSD-3-Clause
// Runs independent tasks on several threads; a free thread takes the next task in order.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tiretherm::solver {

/// Does something n times, several at a time, each begun when a thread is free, in the order of its number. What it throws
/// first is thrown here when all that had been begun has ended; nothing more is begun then.
/// @param threads 0: as many as the machine has
template <typename Work>
void in_parallel(std::size_t n, const Work& work, unsigned threads = 0) {
    std::atomic<std::size_t> next{0};
    std::mutex talk;
    std::exception_ptr thrown;
    const auto take = [&] {
        for (std::size_t i = next++; i < n; i = next++) {
            try {
                work(i);
            } catch (...) {
                const std::lock_guard lock(talk);
                thrown = thrown ? thrown : std::current_exception();
                next = n;
            }
        }
    };
    {
        const std::size_t wanted = threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
        std::vector<std::jthread> others;
        for (std::size_t i = 1; i < std::min(wanted, n); ++i) {
            others.emplace_back(take);
        }
        take();
    }
    if (thrown) {
        std::rethrow_exception(thrown);
    }
}

}  // namespace tiretherm::solver
