// SPDX-License-Identifier: BSD-3-Clause
// Counts every allocation of this executable, those of shared objects and of C libraries too.
#pragma once

#include <atomic>

// The sanitizers bring their own allocator.
#ifndef TIRETHERM_SANITIZED
#define TIRETHERM_COUNTS_ALLOCATIONS
#endif

namespace tiretherm::sample {

extern std::atomic<long> allocations;
/// After so many there is no more memory.
extern std::atomic<long> allocations_left;

}  // namespace tiretherm::sample
