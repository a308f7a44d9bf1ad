// SPDX-License-Identifier: BSD-3-Clause
// Knows the calls that are under way, and the one of the main thread.

#include "python/extension/interruption.hpp"

#include <mutex>
#include <set>

namespace tiretherm::python {

namespace {

std::mutex counting;
std::set<Interruption*> under_way;
std::atomic<Interruption*> of_main_thread = nullptr;
static_assert(std::atomic<Interruption*>::is_always_lock_free, "or a handler may not touch it");

extern "C" void take_signal(int /*signal*/) {
    if (Interruption* const call = of_main_thread) {
        call->take_signal();
    }
}

}  // namespace

Interruption::Interruption(bool by_signal) : by_signal_(by_signal) {
    {
        const std::lock_guard lock(counting);
        under_way.insert(this);
    }
    if (by_signal_) {
        around_ = of_main_thread.exchange(this);
        struct sigaction action {};
        action.sa_handler = &tiretherm::python::take_signal;
        sigaction(SIGINT, &action, &before_);
    }
}

Interruption::~Interruption() {
    if (by_signal_) {
        sigaction(SIGINT, &before_, nullptr);
        of_main_thread = around_;
    }
    const std::lock_guard lock(counting);
    under_way.erase(this);
}

void Interruption::stop_all() {
    const std::lock_guard lock(counting);
    for (Interruption* const call : under_way) {
        call->scope_.ask();
    }
}

}  // namespace tiretherm::python
