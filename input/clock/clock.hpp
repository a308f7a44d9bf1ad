// SPDX-License-Identifier: BSD-3-Clause
// A clock as one field writes it: a time of the day with or without a date, digits, seconds since 1970.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "input/text/quantity.hpp"

namespace tiretherm::input {

/// How the numbers of a column are written.
enum class FieldForm : std::uint8_t {
    number,
    clock,        ///< 11:49:03.250, 1:23.456, 2:05 PM, 24.10.2026 23:20, Sep 3, 2024 14:05, 2025-12-16T11:49:03+01:00,
                  ///< 20251216T114903.250
    digits,       ///< 114903.25 is 11:49:03.25
    since,        ///< a number, counted from the first one on: 1767150797.44
    since_in_ms,  ///< the same in milliseconds, 1767150797440
    since_in_us,
    since_in_ns,
    since_in_days  ///< as a spreadsheet keeps a moment: 46090.58321759, the days since 1900
};

/// Seconds of one of a form that counts.
[[nodiscard]] constexpr double seconds_of_one(FieldForm form) {
    return form == FieldForm::since_in_ms     ? 1e-3
           : form == FieldForm::since_in_us   ? 1e-6
           : form == FieldForm::since_in_ns   ? 1e-9
           : form == FieldForm::since_in_days ? 86400.0
                                              : 1.0;
}

/// Which number of a date is which.
enum class DateOrder : std::uint8_t { day_month_year, month_day_year, year_month_day };
inline constexpr std::array date_orders{DateOrder::day_month_year, DateOrder::month_day_year,
                                        DateOrder::year_month_day};
/// An order among several in the bits of a number.
[[nodiscard]] constexpr std::uint8_t bit_of(DateOrder order) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(order));
}

/// A clock as a field has it.
struct Stamp {
    double seconds = std::numeric_limits<
        double>::quiet_NaN();            ///< of the day or since 1970, an offset from UTC taken off; NaN: no clock
    std::array<std::int16_t, 3> date{};  ///< its numbers in the order in which they are written
    std::uint8_t orders = 0;             ///< bits of the orders that the date may have; 0: no date
    enum class Parts : std::uint8_t {
        whole,    ///< nothing is open
        two,      ///< 11:20, in `seconds` as hours and minutes
        minutes,  ///< 11:20.5, minutes and seconds
    } parts = Parts::whole;
};

/// Reads a field. @param form of its column, not `number`
[[nodiscard]] Stamp read_stamp(std::string_view field, FieldForm form);

/// Days since 1970 of the numbers of a date; a year below 70 is one of this century. Nothing where there is no such day.
[[nodiscard]] std::optional<int> day_number(const std::array<std::int16_t, 3>& date, DateOrder order);

/// Whether a field is a clock of the day, with or without a date.
[[nodiscard]] bool is_clock(std::string_view field);
/// Whether a field is a date alone.
[[nodiscard]] bool is_date(std::string_view field);

}  // namespace tiretherm::input
