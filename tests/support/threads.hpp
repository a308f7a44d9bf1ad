// SPDX-License-Identifier: BSD-3-Clause
// So many threads for a part of a test.
#pragma once

#include <omp.h>

namespace tiretherm::support {

/// Gives the number of threads back that was.
struct Threads {
    explicit Threads(int n) { omp_set_num_threads(n); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() { omp_set_num_threads(before); }
    int before = omp_get_max_threads();
};

}  // namespace tiretherm::support
