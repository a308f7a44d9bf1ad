// SPDX-License-Identifier: BSD-3-Clause
// A column that a run was read from, and the other units in which its numbers would be as usual: which headings may be wrong.
#pragma once

#include <string>
#include <vector>

#include "input/text/units.hpp"

namespace tiretherm::input {

/// A column of a run's file that the model uses.
struct ReadColumn {
    /// A unit in which the numbers may be written in truth.
    struct OtherUnit {
        std::string name;
        Conversion from_read{};  ///< of the value that was read, in SI, to that which the number is in this unit
    };
    std::string name;      ///< of the input or the sensor
    std::string heading;   ///< what the file calls it
    std::string unit;      ///< in which it was read
    std::string quantity;  ///< its SI unit
    int line = 0;          ///< of the heading; 0: the file has no lines
    bool is_input = false;
    std::vector<OtherUnit> others{};
};

}  // namespace tiretherm::input
