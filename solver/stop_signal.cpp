// SPDX-License-Identifier: BSD-3-Clause
// Handlers of SIGINT and SIGTERM that only set a flag and are reset after the first signal; a deadline.

#include "solver/stop_signal.hpp"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <limits>

namespace tiretherm::solver {

namespace {

// Set by the thread that the signal reaches, read by all.
std::atomic<bool> requested = false;
static_assert(std::atomic<bool>::is_always_lock_free, "or a handler may not touch it");

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();
std::atomic<std::int64_t> deadline = never;  // ns of the steady clock

std::int64_t now() {
    return deadline == never ? 0 : std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

thread_local bool may_leave_reading = false;

extern "C" void request(int /*signal*/) { requested = true; }

}  // namespace

void install_stop_handlers() {
    struct sigaction action {};
    action.sa_handler = &request;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool stop_requested() { return requested || now() >= deadline; }

void stop_after(double seconds) {
    const auto from = std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
    // Some hundred years fit into 64 bits; what is longer has no end.
    const bool fits = 1e9 * seconds < static_cast<double>(never - from);
    deadline = fits ? from + static_cast<std::int64_t>(1e9 * seconds) : never;
}

bool is_time_up() { return !requested && now() >= deadline; }

void leave_if_stopped() {
    if (stop_requested()) {
        throw Interrupted();
    }
}

InterruptibleReading::InterruptibleReading() { may_leave_reading = true; }

InterruptibleReading::~InterruptibleReading() { may_leave_reading = false; }

void leave_reading_if_stopped() {
    if (may_leave_reading) {
        leave_if_stopped();
    }
}

}  // namespace tiretherm::solver
