// SPDX-License-Identifier: BSD-3-Clause
// Handlers of SIGINT and SIGTERM that only set a flag and are reset after the first signal.

#include "solver/stop_signal.hpp"

#include <atomic>
#include <csignal>

namespace tiretherm::solver {

namespace {

// Set by the thread that the signal reaches, read by all.
std::atomic<bool> requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "or a handler may not touch it");

extern "C" void request(int /*signal*/) { requested = true; }

}  // namespace

void install_stop_handlers() {
    struct sigaction action {};
    action.sa_handler = &request;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() { return requested; }

void leave_if_stopped() {
    if (stop_requested()) {
        throw Interrupted();
    }
}

}  // namespace tiretherm::solver
