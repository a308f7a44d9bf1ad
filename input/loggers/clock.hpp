// SPDX-License-Identifier: BSD-3-Clause
// Clocks of the day as loggers write them, and times since 1970, as seconds from the first sample on.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "input/text/quantity.hpp"

namespace tiretherm::input {

/// How the numbers of a column are written.
enum class FieldForm : std::uint8_t {
    number,
    clock,       ///< 11:49:03.250, 1:23.456, 2025-12-16T11:49:03.250Z
    digits,      ///< 114903.25 is 11:49:03.25
    since,       ///< a number, counted from the first one on: 1767150797.44
    since_in_ms  ///< the same in milliseconds
};

/// Whether a field is a clock of the day, or minutes and seconds with decimals.
[[nodiscard]] bool is_clock(std::string_view field);

/// Reads a column of clocks. Past midnight a day is added.
class ClockReader {
public:
    explicit ClockReader(FieldForm form) : form_(form) {}

    /// @returns seconds since the first field that could be read; nothing for what is none
    [[nodiscard]] std::optional<Number> read(std::string_view field);

private:
    FieldForm form_;
    std::optional<double> first_{};
    double last_ = 0.0;
    double days_ = 0.0;  ///< s
};

}  // namespace tiretherm::input
