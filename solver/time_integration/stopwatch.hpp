// SPDX-License-Identifier: BSD-3-Clause
// Wall time of a part of the work.
#pragma once

#include <chrono>

namespace tiretherm::solver {

/// Adds the time until its end to a total, if there is one.
class Stopwatch {
public:
    explicit Stopwatch(double* total) : total_(total) {
        if (total_ != nullptr) {
            start_ = std::chrono::steady_clock::now();
        }
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;
    ~Stopwatch() {
        if (total_ != nullptr) {
            *total_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        }
    }

private:
    double* total_;
    std::chrono::steady_clock::time_point start_;
};

}  // namespace tiretherm::solver
