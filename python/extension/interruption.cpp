// SPDX-License-Identifier: BSD-3-Clause
// Counts the calls under way. The last of them to end clears what asked for an end, so that the next ones begin afresh.

#include "python/extension/interruption.hpp"

#include <atomic>
#include <limits>
#include <mutex>

#include "solver/stop_signal.hpp"

namespace tiretherm::python {

namespace {

std::mutex counting;
int under_way = 0;
std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free, "or a handler may not touch it");

/// A deadline can be set from a handler, and taken back.
extern "C" void take_signal(int /*signal*/) {
    signalled = true;
    solver::stop_after(0.0);
}

}  // namespace

Interruption::Interruption(bool by_signal) : by_signal_(by_signal) {
    {
        const std::lock_guard lock(counting);
        ++under_way;
    }
    if (by_signal_) {
        signalled = false;
        struct sigaction action {};
        action.sa_handler = &take_signal;
        sigaction(SIGINT, &action, &before_);
    }
}

Interruption::~Interruption() {
    if (by_signal_) {
        sigaction(SIGINT, &before_, nullptr);
    }
    const std::lock_guard lock(counting);
    if (--under_way == 0) {
        solver::stop_after(std::numeric_limits<double>::infinity());
    }
}

bool Interruption::was_signalled() const { return by_signal_ && signalled; }

void stop() {
    const std::lock_guard lock(counting);
    if (under_way > 0) {
        solver::stop_after(0.0);
    }
}

}  // namespace tiretherm::python
