#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace tiretherm::diagnosis {

/// Does something n times, on all cores, in any order. It must not throw.
template <typename Work>
void in_parallel(std::size_t n, const Work& work) {
    std::atomic<std::size_t> next{0};
    const auto take = [&] {
        for (std::size_t i = next++; i < n; i = next++) {
            work(i);
        }
    };
    std::vector<std::jthread> others;
    for (std::size_t i = 1; i < std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), n); ++i) {
        others.emplace_back(take);
    }
    take();
}

}  // namespace tiretherm::diagnosis
