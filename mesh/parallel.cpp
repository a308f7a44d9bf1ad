// SPDX-License-Identifier: BSD-3-Clause
// How a loop is handed over. OpenMP would begin a region for each: its threads either sleep in between, and to wake one takes as long as
// a short loop, or they spin for milliseconds, and where other programs run so take the core from the thread that they wait for.

#include "mesh/parallel.hpp"

namespace tiretherm {

namespace {

/// How often a thread looks before it sleeps: some dozen microseconds.
constexpr int looks = 2000;
constexpr std::uint32_t one_turn = 1U << 8U;

constexpr std::uint32_t turn_of(std::uint32_t state) { return state / one_turn; }
constexpr std::uint32_t helpers_in(std::uint32_t state) { return state % one_turn; }

void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

/// Waits until the state is as wanted. @returns it
template <typename Wanted>
std::uint32_t wait_for(const std::atomic<std::uint32_t>& state, const Wanted& wanted) {
    std::uint32_t now = state.load(std::memory_order_acquire);
    for (int look = 0; !wanted(now) && look < looks; ++look) {
        pause();
        now = state.load(std::memory_order_acquire);
    }
    while (!wanted(now)) {
        state.wait(now, std::memory_order_acquire);
        now = state.load(std::memory_order_acquire);
    }
    return now;
}

}  // namespace

thread_local Team* Team::now_ = nullptr;

void Team::open() {
    state_.fetch_add(one_turn, std::memory_order_release);
    state_.notify_all();
}

/// Nobody begins with the loop any more; those who did are waited for.
void Team::close() {
    state_.fetch_add(one_turn, std::memory_order_relaxed);
    wait_for(state_, [](std::uint32_t state) { return helpers_in(state) == 0; });
}

void Team::work_on_loop(std::size_t thread) noexcept {
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        Part& part = parts_[(thread + k) % parts_.size()];
        for (std::size_t i = part.next.fetch_add(1, std::memory_order_relaxed); i < part.end;
             i = part.next.fetch_add(1, std::memory_order_relaxed)) {
            call_(body_, i);
        }
    }
}

void Team::help(std::size_t thread) {
    std::uint32_t last = 0;
    for (;;) {
        std::uint32_t state =
            wait_for(state_, [last](std::uint32_t now) { return turn_of(now) % 2 == 1 && turn_of(now) != last; });
        if (!state_.compare_exchange_weak(state, state + 1, std::memory_order_acquire)) {
            continue;
        }
        last = turn_of(state);
        if (call_ == nullptr) {
            return;
        }
        work_on_loop(thread);
        state = state_.fetch_sub(1, std::memory_order_release) - 1;
        if (helpers_in(state) == 0 && turn_of(state) % 2 == 0) {
            state_.notify_all();
        }
    }
}

/// A loop that is nothing, and stays open, ends the helping.
void Team::dismiss() {
    call_ = nullptr;
    open();
}

}  // namespace tiretherm
