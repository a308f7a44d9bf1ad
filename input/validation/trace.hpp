// SPDX-License-Identifier: BSD-3-Clause
// Channels of a run over time, and the single numbers that are read from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/time_integration/march.hpp"

namespace tiretherm::input {

/// What is asked of a channel's course. Between rows it is straight, beyond them it is held.
struct Window {
    enum class Take : std::uint8_t {
        at,      ///< the value at `to`
        mean,    ///< over the time from `from` to `to`
        max,     ///< largest value there
        min,     ///< smallest value there
        time_to  ///< s after `from` until `share` of the change from `from` to `to` has been reached for the first time
    };
    Take take = Take::at;
    double from = 0.0;   ///< s
    double to = 0.0;     ///< s
    double share = 0.0;  ///< 1, of time_to
};

/// The channels of a run, row by row.
class Trace {
public:
    void take(const solver::Snapshot& snapshot);

    [[nodiscard]] std::size_t rows() const { return time_.size(); }
    /// @pre rows() > 0  @returns in the channel's unit; s for time_to
    [[nodiscard]] double read(std::size_t channel, const Window& window) const;
    /// Lets a channel read about + factor (value - about) + offset, as an instrument that is wrong by these does.
    void correct(std::size_t channel, double factor, double about, double offset);

private:
    [[nodiscard]] double at(std::size_t channel, double t) const;
    /// Times at which a stretch of the course begins, bends or ends.
    [[nodiscard]] std::vector<double> corners(double from, double to) const;

    std::size_t width_ = 0;
    std::vector<double> time_;   ///< [rows] s
    std::vector<double> value_;  ///< [rows * channels]
};

}  // namespace tiretherm::input
