// SPDX-License-Identifier: BSD-3-Clause
// Data checks on camera frames while they are read; each suspicion becomes one sentence.
#pragma once

#include <string>
#include <vector>

#include "input/measurements/experiment.hpp"

namespace tiretherm::input {

/// Looks at a camera's frames as they are read, all detectors of them.
class FrameChecks {
public:
    /// @param kelvin [rows * columns]; NaN: dead
    void take(const std::vector<double>& kelvin);
    /// What is suspicious, and what was left out, a sentence each without the file's name.
    /// @param outside frames that do not lie within the run
    [[nodiscard]] std::vector<std::string> warnings(const MeasuredFrames& frames, std::size_t outside) const;

private:
    double hottest_ = 0.0;        ///< K
    double coldest_ = 1e9;        ///< K
    std::size_t at_hottest_ = 0;  ///< values
    std::size_t in_frames_ = 0;   ///< that have more than one of them
    std::size_t frames_ = 0;
    std::size_t repeated_ = 0;  ///< frames that equal the one before
    std::vector<double> last_;
};

}  // namespace tiretherm::input
