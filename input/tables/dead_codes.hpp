// SPDX-License-Identifier: BSD-3-Clause
// What loggers write where a sensor of temperature gives nothing: 9999, 65535, -999.
#pragma once

#include <string>
#include <vector>

#include "input/tables/column_reader.hpp"

namespace tiretherm::input {

/// Numbers of a column of temperatures that are out of all range, far from the others and always the same, in fewer than half of
/// its samples. @param written [rows] in the column's unit
struct DeadCodes {
    DeadCodes(const std::vector<double>& written, const ColumnHead& head, const ColumnRequest& request);

    [[nodiscard]] bool has(double number) const {
        return !codes.empty() && (number == codes.front() || number == codes.back());
    }

    std::vector<double> codes{};  ///< two at most
    std::string sentence{};       ///< what of the column is left out; empty: nothing
};

}  // namespace tiretherm::input
