// SPDX-License-Identifier: BSD-3-Clause
// Stands in for the allocator of glibc, which it calls.

#include "tests/interface/allocations.hpp"

#include <cstddef>
#include <limits>

namespace tiretherm::sample {

std::atomic<long> allocations{0};
std::atomic<long> allocations_left{std::numeric_limits<long>::max()};

namespace {

/// Counts an allocation. @returns whether there is memory for it
[[maybe_unused]] bool is_granted() {
    ++allocations;
    return allocations_left-- > 0;
}

}  // namespace

}  // namespace tiretherm::sample

#ifdef TIRETHERM_COUNTS_ALLOCATIONS
extern "C" {
void* __libc_malloc(std::size_t size);                 // NOLINT: the name is glibc's
void* __libc_calloc(std::size_t n, std::size_t size);  // NOLINT
void* __libc_realloc(void* memory, std::size_t size);  // NOLINT
void* malloc(std::size_t size) { return tiretherm::sample::is_granted() ? __libc_malloc(size) : nullptr; }
void* calloc(std::size_t n, std::size_t size) {
    return tiretherm::sample::is_granted() ? __libc_calloc(n, size) : nullptr;
}
void* realloc(void* memory, std::size_t size) {
    return tiretherm::sample::is_granted() ? __libc_realloc(memory, size) : nullptr;
}
}
#endif
