// SPDX-License-Identifier: BSD-3-Clause
// Parses clocks with and without a date.

#include "input/loggers/clock.hpp"

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>

#include "input/tables/csv.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr double day = 86400.0;

/// A whole number without sign at the start of a text, which is taken off. @param most digits
std::optional<int> take_digits(std::string_view& text, std::size_t most) {
    std::size_t n = 0;
    while (n < text.size() && n < most && text[n] >= '0' && text[n] <= '9') {
        ++n;
    }
    int value = 0;
    if (n == 0 || std::from_chars(text.data(), text.data() + n, value).ec != std::errc()) {
        return std::nullopt;
    }
    text.remove_prefix(n);
    return value;
}

bool take(std::string_view& text, char c) {
    if (text.empty() || text.front() != c) {
        return false;
    }
    text.remove_prefix(1);
    return true;
}

/// Seconds with their decimals and nothing behind them, below 60 where minutes stand before them.
std::optional<double> whole_seconds(std::string_view text) {
    std::string room;
    const std::string_view point = with_point(text, room);
    if (point.empty() || point.find_first_not_of("0123456789.") != std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<Number> number = leading_number(point);
    return number && number->rest.empty() && number->value < 61.0 ? std::optional(number->value) : std::nullopt;
}

/// "2025-12-16T" or "2025-12-16 " at the start, taken off, as seconds; 0 where there is none.
double take_date(std::string_view& text) {
    std::string_view rest = text;
    const std::optional<int> year = take_digits(rest, 4);
    if (!year || !take(rest, '-')) {
        return 0.0;
    }
    const std::optional<int> month = take_digits(rest, 2);
    const bool separated = take(rest, '-');
    const std::optional<int> of_month = separated ? take_digits(rest, 2) : std::nullopt;
    if (!month || !of_month || !(take(rest, 'T') || take(rest, ' '))) {
        return 0.0;
    }
    const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*of_month))};
    if (!date.ok()) {
        return 0.0;
    }
    text = rest;
    return day * static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

/// "9/5/2025 " at the start, taken off. Which of the two is the month differs: such a clock counts as one of the day.
void take_slashed_date(std::string_view& text) {
    std::string_view rest = text;
    const bool found = take_digits(rest, 2) && take(rest, '/') && take_digits(rest, 2) && take(rest, '/') &&
                       take_digits(rest, 4) && take(rest, ' ');
    text = found ? rest : text;
}

struct Clock {
    double seconds = 0.0;
    bool dated = false;
};

std::optional<Clock> read_clock(std::string_view text) {
    text = trim(text);
    const double date = take_date(text);
    take_slashed_date(text);
    if (text.ends_with('Z')) {
        text.remove_suffix(1);
    }
    const std::optional<int> first = take_digits(text, 3);
    if (!first || !take(text, ':')) {
        return std::nullopt;
    }
    if (text.find(':') == std::string_view::npos) {  // minutes and seconds, told from hours and minutes by the decimals
        const std::optional<double> seconds = whole_seconds(text);
        const bool has_decimals = text.find_first_of(".,") != std::string_view::npos;
        return seconds && has_decimals ? std::optional(Clock{60.0 * *first + *seconds, date != 0.0}) : std::nullopt;
    }
    const std::optional<int> minutes = take_digits(text, 2);
    const bool separated = take(text, ':');
    const std::optional<double> seconds = separated ? whole_seconds(text) : std::nullopt;
    if (!minutes || *minutes > 59 || !seconds) {
        return std::nullopt;
    }
    return Clock{date + 3600.0 * *first + 60.0 * *minutes + *seconds, date != 0.0};
}

/// 114903.25 as 11:49:03.25.
std::optional<double> read_digits(std::string_view text) {
    const std::optional<Number> number = leading_number(text);
    if (!number || !number->rest.empty() || !(number->value >= 0.0 && number->value < 240000.0)) {
        return std::nullopt;
    }
    const double hours = std::floor(number->value / 10000.0);
    const double minutes = std::floor((number->value - 10000.0 * hours) / 100.0);
    const double seconds = number->value - 10000.0 * hours - 100.0 * minutes;
    return minutes < 60.0 && seconds < 61.0 ? std::optional(3600.0 * hours + 60.0 * minutes + seconds) : std::nullopt;
}

}  // namespace

bool is_clock(std::string_view field) { return read_clock(field).has_value(); }

std::optional<Number> ClockReader::read(std::string_view field) {
    double seconds = 0.0;
    bool may_wrap = false;
    switch (form_) {
        case FieldForm::number:
            return leading_number(field);
        case FieldForm::since:
        case FieldForm::since_in_ms: {
            const std::optional<Number> number = leading_number(field);
            if (!number || !number->rest.empty() || !std::isfinite(number->value)) {
                return number;
            }
            seconds = form_ == FieldForm::since ? number->value : 1e-3 * number->value;
            break;
        }
        case FieldForm::clock: {
            const std::optional<Clock> clock = read_clock(field);
            if (!clock) {
                return std::nullopt;
            }
            seconds = clock->seconds;
            may_wrap = !clock->dated;
            break;
        }
        case FieldForm::digits: {
            const std::optional<double> read = read_digits(field);
            if (!read) {
                return std::nullopt;
            }
            seconds = *read;
            may_wrap = true;
            break;
        }
    }
    // Backwards by more than half a day is midnight; by less it is a clock that was set.
    if (may_wrap && first_ && seconds + days_ < last_ - 0.5 * day) {
        days_ += day;
    }
    last_ = seconds + days_;
    first_ = first_.value_or(last_);
    // Differences of clocks are decimal fractions; a microsecond is finer than any logger's.
    return Number{std::round((last_ - *first_) * 1e6) / 1e6, {}};
}

}  // namespace tiretherm::input
