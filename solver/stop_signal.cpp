// SPDX-License-Identifier: BSD-3-Clause
// Handlers of SIGINT and SIGTERM that only set a flag and are reset after the first signal; a deadline.

#include "solver/stop_signal.hpp"

#include <chrono>
#include <csignal>
#include <limits>
#include <utility>

#include "mesh/parallel.hpp"

namespace tiretherm::solver {

namespace {

static_assert(std::atomic<bool>::is_always_lock_free, "or a handler may not touch it");

constexpr std::int64_t never = std::numeric_limits<std::int64_t>::max();

StopRequest of_program;  // set by the thread that the signal reaches, read by all that belong to no scope

StopRequest& present() { return of_computation != nullptr ? *static_cast<StopRequest*>(of_computation) : of_program; }

std::int64_t now() { return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1); }

bool has_passed(std::int64_t deadline) { return deadline != never && now() >= deadline; }

thread_local bool may_leave_reading = false;

extern "C" void request(int /*signal*/) { of_program.asked = true; }

}  // namespace

void install_stop_handlers() {
    struct sigaction action {};
    action.sa_handler = &request;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

StopScope::StopScope() : around_(std::exchange(of_computation, &request_)) {}

StopScope::~StopScope() { of_computation = around_; }

bool stop_requested() { return of_program.asked || present().asked || has_passed(present().deadline); }

void stop_after(double seconds) {
    const std::int64_t from = now();
    // Some hundred years fit into 64 bits; what is longer has no end.
    const bool fits = 1e9 * seconds < static_cast<double>(never - from);
    present().deadline = fits ? from + static_cast<std::int64_t>(1e9 * seconds) : never;
}

bool is_time_up() { return !of_program.asked && !present().asked && has_passed(present().deadline); }

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
