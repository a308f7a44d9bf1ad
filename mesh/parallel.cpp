// SPDX-License-Identifier: BSD-3-Clause
// How threads wait. The OpenMP of GCC lets one that waits spin for some 3 ms before it sleeps. Where other programs run, it so takes
// the core from the thread that it waits for, and two threads are ten times slower than one. It does not where it has more threads than
// there are cores; and nothing but the environment, which is read before the program begins, tells it otherwise.

#include "mesh/parallel.hpp"

#include <chrono>
#include <cstdlib>
#include <thread>

namespace tiretherm {

namespace {

/// Two threads more, which sleep until the program ends.
[[noreturn]] void own_threads_that_sleep() {
    std::atomic<int> here = 0;
#pragma omp parallel num_threads(2)
    ++here;
    for (;;) {
        std::this_thread::sleep_for(std::chrono::hours(24));
    }
}

}  // namespace

void keep_waiting_short() {
    static const bool is_said = [] {
        const bool said = std::getenv("OMP_WAIT_POLICY") != nullptr || std::getenv("GOMP_SPINCOUNT") != nullptr;
        if (!said) {
            std::thread(own_threads_that_sleep).detach();
        }
        return said;
    }();
    static_cast<void>(is_said);
}

}  // namespace tiretherm
