// SPDX-License-Identifier: BSD-3-Clause
// The progress line of a run on a terminal: share done, simulated time, hottest temperature, speed and remaining time.
#pragma once

#include <chrono>
#include <cstdio>
#include <span>
#include <string>

namespace tiretherm::post {

/// How far a run is, for the line below.
struct Advance {
    double start = 0.0;    ///< s
    double end = 0.0;      ///< s
    double time = 0.0;     ///< s, now
    double hottest = 0.0;  ///< K, now
    double elapsed = 0.0;  ///< s of wall time, > 0
};

/// `laser/one_watt  37 %  t = 662 s of 1800 s  hottest 98.1 °C  2 100 x real time  0.4 s left`
[[nodiscard]] std::string progress_line(const std::string& name, const Advance& advance);

/// One line on a terminal, rewritten at most ten times a second and removed at the end.
class Progress {
public:
    /// @param stream where the line goes, usually stderr   @param shown false: stays silent
    Progress(std::FILE* stream, bool shown, std::string name, double start, double end);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// @param time s  @param temperature [n_nodes] K
    void update(double time, std::span<const double> temperature);

private:
    using Clock = std::chrono::steady_clock;

    std::FILE* stream_;
    bool shown_;
    std::string name_;
    double start_;
    double end_;
    Clock::time_point begun_;
    Clock::time_point written_;
    bool line_stands_ = false;
};

}  // namespace tiretherm::post
