// SPDX-License-Identifier: BSD-3-Clause
// Handlers of SIGINT and SIGTERM that only set a flag and are reset after the first signal.

#include "solver/stop_signal.hpp"

#include <csignal>

namespace tiretherm::solver {

namespace {

volatile std::sig_atomic_t requested = 0;

extern "C" void request(int /*signal*/) { requested = 1; }

}  // namespace

void install_stop_handlers() {
    struct sigaction action {};
    action.sa_handler = &request;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() { return requested != 0; }

void leave_if_stopped() {
    if (stop_requested()) {
        throw Interrupted();
    }
}

}  // namespace tiretherm::solver
