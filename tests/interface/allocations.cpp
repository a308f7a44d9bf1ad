// SPDX-License-Identifier: BSD-3-Clause
// Stands in for the allocator of glibc, which it calls.

#include "tests/interface/allocations.hpp"

#include <cstddef>

namespace tiretherm::sample {

std::atomic<long> allocations{0};

}  // namespace tiretherm::sample

#ifdef TIRETHERM_COUNTS_ALLOCATIONS
extern "C" {
void* __libc_malloc(std::size_t size);                 // NOLINT: the name is glibc's
void* __libc_calloc(std::size_t n, std::size_t size);  // NOLINT
void* __libc_realloc(void* memory, std::size_t size);  // NOLINT
void* malloc(std::size_t size) {
    ++tiretherm::sample::allocations;
    return __libc_malloc(size);
}
void* calloc(std::size_t n, std::size_t size) {
    ++tiretherm::sample::allocations;
    return __libc_calloc(n, size);
}
void* realloc(void* memory, std::size_t size) {
    ++tiretherm::sample::allocations;
    return __libc_realloc(memory, size);
}
}
#endif
