// SPDX-License-Identifier: BSD-3-Clause
// Takes a clock apart from left to right: numbers, words, an offset from UTC.

#include "input/clock/clock.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <string>

#include "input/clock/clock_words.hpp"
#include "input/tables/csv.hpp"
#include "input/text/characters.hpp"

namespace tiretherm::input {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
char small(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

/// A whole number without sign.
struct Digits {
    int value = 0;
    std::size_t count = 0;  ///< 0: none
};

Digits take_digits(std::string_view& text, std::size_t most = 8) {
    Digits read;
    while (read.count < std::min(text.size(), most) && is_digit(text[read.count])) {
        read.value = 10 * read.value + (text[read.count] - '0');
        ++read.count;
    }
    text.remove_prefix(read.count);
    return read;
}

bool take(std::string_view& text, char c) {
    const bool found = !text.empty() && text.front() == c;
    text.remove_prefix(found ? 1 : 0);
    return found;
}

bool may_be_in_word(char c) { return is_letter(c) || static_cast<unsigned char>(c) >= 0x80U; }

/// A word in small letters.
std::string take_word(std::string_view& text) {
    const auto size = std::ranges::find_if_not(text, may_be_in_word) - text.begin();
    std::string word(text.substr(0, static_cast<std::size_t>(size)));
    std::ranges::transform(word, word.begin(), small);
    text.remove_prefix(word.size());
    return word;
}

/// Reads one field.
class StampReader {
public:
    explicit StampReader(std::string_view text) : rest_(trim(text)) {}

    Stamp read() {
        while (!rest_.empty()) {
            if (!take_part()) {
                return {};
            }
        }
        if (month_ > 0 && !take_named_date()) {
            return {};
        }
        if (bare_count_ > 0 && month_ == 0) {
            return {};
        }
        if (has_time_) {
            finish_time();
        }
        return stamp_;
    }

private:
    bool take_part() {
        const char c = rest_.front();
        if (is_digit(c)) {
            return take_number();
        }
        if ((c == '+' || c == '-') && has_time_) {
            return take_offset();
        }
        if (may_be_in_word(c)) {
            return take_name();
        }
        rest_.remove_prefix(1);
        const bool has_part = month_ > 0 || bare_count_ > 0;
        const bool beside_month = has_part && !has_time_ && (c == '-' || c == '.' || c == '/');
        return c == ' ' || c == ',' || c == '\t' || c == '_' || beside_month;
    }

    bool take_number() {
        const Digits number = take_digits(rest_);
        const char next = rest_.empty() ? ' ' : rest_.front();
        if (next == ':') {
            return !has_time_ && take_time(number);
        }
        const bool separates = (next == '/' || next == '-' || next == '.') && rest_.size() > 1 && rest_[1] != ' ';
        if (separates && stamp_.orders == 0 && month_ == 0) {
            return take_date(number, next);
        }
        // Eight digits may be any number. Those of a date begin with a year in which a logger can have written it.
        constexpr int first_year = 1970;
        constexpr int last_year = 2100;
        const int year = number.value / 10000;
        if (number.count == 8 && stamp_.orders == 0 && year >= first_year && year <= last_year) {  // 20261024
            return set_date({year, number.value / 100 % 100, number.value % 100}, bit_of(DateOrder::year_month_day));
        }
        if (number.count == 6 && stamp_.orders != 0 && !has_time_) {  // 114903.250
            return take_joined_time(number);
        }
        if (bare_count_ == bare_.size()) {
            return false;
        }
        bare_[bare_count_++] = number;
        return true;
    }

    /// The time of a day without colons, behind its date: 114903, 114903.250.
    bool take_joined_time(const Digits& joined) {
        has_time_ = true;
        first_ = joined.value / 10000;
        second_ = joined.value / 100 % 100;
        third_ = joined.value % 100;
        return first_ < 24 && second_ < 60 && third_ < 61.0 && take_decimals(third_);
    }

    /// 24.10.2026, 10/24/26, 2026-10-24, 24-Oct-2026.
    bool take_date(const Digits& first, char separator) {
        rest_.remove_prefix(1);
        if (may_be_in_word(rest_.front())) {
            bare_[bare_count_++] = first;
            return take_name();
        }
        const Digits second = take_digits(rest_, 2);
        if (second.count == 0 || !take(rest_, separator)) {
            return false;
        }
        const Digits third = take_digits(rest_, 4);
        if (first.count == 4) {
            return third.count > 0 && third.count <= 2 &&
                   set_date({first.value, second.value, third.value}, bit_of(DateOrder::year_month_day));
        }
        if (first.count > 2 || (third.count != 4 && third.count != 2)) {
            return false;
        }
        // Points are written by people who put the day first.
        std::uint8_t orders = bit_of(DateOrder::day_month_year);
        if (separator != '.') {
            orders = static_cast<std::uint8_t>(orders | bit_of(DateOrder::month_day_year) |
                                               (third.count == 2 ? bit_of(DateOrder::year_month_day) : 0U));
        }
        return set_date({first.value, second.value, third.value}, orders);
    }

    bool set_date(const std::array<int, 3>& numbers, std::uint8_t orders) {
        std::ranges::transform(numbers, stamp_.date.begin(), [](int n) { return static_cast<std::int16_t>(n); });
        stamp_.orders = orders;
        return true;
    }

    /// The day and the year that stand beside the name of a month: 3 Sep 2024, Sep 3, 2024, Tue Sep 3 14:05:01 2024.
    bool take_named_date() {
        if (bare_count_ != 2 || stamp_.orders != 0) {
            return false;
        }
        const bool year_first = bare_[0].count == 4;
        const Digits& day = bare_[year_first ? 1 : 0];
        return set_date({day.value, month_, bare_[year_first ? 0 : 1].value}, bit_of(DateOrder::day_month_year));
    }

    /// What follows the hours, or the minutes: ":20", ":20:00,25", ":20.5", ":20:00:250".
    bool take_time(const Digits& first) {
        has_time_ = true;
        first_ = first.value;
        rest_.remove_prefix(1);
        const Digits second = take_digits(rest_, 2);
        if (second.count == 0 || first.count > 4) {
            return false;
        }
        second_ = second.value;
        if (take(rest_, ':')) {
            const Digits third = take_digits(rest_, 2);
            third_ = third.value;
            stamp_.parts = Stamp::Parts::whole;
            return third.count > 0 && second.value < 60 && third.value < 61 && take_decimals(third_);
        }
        const bool has_decimals = rest_.size() > 1 && (rest_[0] == '.' || rest_[0] == ',') && is_digit(rest_[1]);
        stamp_.parts = has_decimals ? Stamp::Parts::minutes : Stamp::Parts::two;
        third_ = 0.0;
        return second.value < 60 && take_decimals(third_);
    }

    /// Decimals behind a point or a comma, or milliseconds behind a colon, where there are any.
    bool take_decimals(double& onto) {
        if (rest_.size() < 2 || !is_digit(rest_[1]) || (rest_[0] != '.' && rest_[0] != ',' && rest_[0] != ':')) {
            return true;
        }
        const bool thousandths = rest_[0] == ':';
        rest_.remove_prefix(1);
        const std::size_t count = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
        double fraction = 0.0;
        // The digits behind the point are read by themselves and behind a point: a comma or a colon may have stood there. More
        // than 18 of them no double holds.
        std::array<char, 20> text{'0', '.'};
        const std::size_t kept = std::min(count, text.size() - 2);
        std::copy_n(rest_.begin(), kept, text.begin() + 2);
        std::from_chars(text.data(), text.data() + 2 + kept, fraction);
        rest_.remove_prefix(count);
        onto += fraction;
        return !thousandths || count == 3;
    }

    /// +02:00, +0200, -7.
    bool take_offset() {
        const double sign = rest_.front() == '-' ? -1.0 : 1.0;
        rest_.remove_prefix(1);
        const Digits hours = take_digits(rest_, 4);
        const Digits minutes = take(rest_, ':') ? take_digits(rest_, 2) : Digits{};
        const bool joined = hours.count > 2;
        const int of_hour = joined ? hours.value % 100 : minutes.value;
        offset_ += sign * (3600.0 * (joined ? hours.value / 100 : hours.value) + 60.0 * of_hour);
        return hours.count > 0 && std::abs(offset_) <= 15.0 * 3600.0;
    }

    bool take_name() {
        const std::string text = take_word(rest_);
        if (text == "t" && (stamp_.orders != 0 || month_ > 0)) {
            return true;
        }
        if ((text == "am" || text == "pm" || text == "a" || text == "p") && has_time_) {
            if (text.size() == 1) {  // a.m.
                static_cast<void>(take(rest_, '.') && take(rest_, 'm') && take(rest_, '.'));
            }
            half_ = text.front() == 'p' ? 12 : 0;
            return first_ >= 1 && first_ <= 12 && stamp_.parts != Stamp::Parts::minutes;
        }
        if ((text == "day" || text == "days") && bare_count_ == 1 && !has_time_) {  // 0 days 00:00:30
            days_ = bare_[0].value;
            bare_count_ = 0;
            return true;
        }
        if (const int month = month_of(text); month > 0 && month_ == 0) {
            month_ = month;
            return true;
        }
        if (const std::optional<int> hours = zone_of(text); hours && has_time_) {
            offset_ += 3600.0 * *hours;
            return true;
        }
        return is_weekday(text);
    }

    void finish_time() {
        if (half_) {
            first_ = first_ % 12 + *half_;
            stamp_.parts = Stamp::Parts::whole;
        } else if (stamp_.orders != 0 && stamp_.parts == Stamp::Parts::two) {
            stamp_.parts = Stamp::Parts::whole;  // beside a date stand hours
        }
        const bool minutes = stamp_.parts == Stamp::Parts::minutes;
        stamp_.seconds =
            (minutes ? 60.0 * first_ + second_ : 3600.0 * first_ + 60.0 * second_) + third_ + 86400.0 * days_ - offset_;
    }

    std::string_view rest_;
    Stamp stamp_;
    bool has_time_ = false;
    int days_ = 0;
    int first_ = 0;
    int second_ = 0;
    double third_ = 0.0;
    double offset_ = 0.0;        ///< s
    std::optional<int> half_{};  ///< h: 0 before noon, 12 after it
    int month_ = 0;              ///< by its name
    std::array<Digits, 2> bare_{};
    std::size_t bare_count_ = 0;
};

/// 114903.25 as 11:49:03.25.
double read_clock_digits(double number) {
    const double hours = std::floor(number / 10000.0);
    const double minutes = std::floor((number - 10000.0 * hours) / 100.0);
    const double seconds = number - 10000.0 * hours - 100.0 * minutes;
    const bool is_one = number >= 0.0 && number < 240000.0 && minutes < 60.0 && seconds < 61.0;
    return is_one ? 3600.0 * hours + 60.0 * minutes + seconds : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Stamp read_stamp(std::string_view field, FieldForm form) {
    if (form == FieldForm::clock) {
        return StampReader(field).read();
    }
    std::string room;
    const std::optional<Number> number = leading_number(with_point(trim(field), room));
    if (!number || !number->rest.empty() || !std::isfinite(number->value)) {
        return {};
    }
    return {.seconds =
                form == FieldForm::digits ? read_clock_digits(number->value) : seconds_of_one(form) * number->value};
}

bool is_clock(std::string_view field) { return !std::isnan(read_stamp(field, FieldForm::clock).seconds); }

bool is_date(std::string_view field) {
    const Stamp stamp = read_stamp(field, FieldForm::clock);
    return std::isnan(stamp.seconds) && std::ranges::any_of(date_orders, [&](DateOrder order) {
               return (stamp.orders & bit_of(order)) != 0 && day_number(stamp.date, order).has_value();
           });
}

std::optional<int> day_number(const std::array<std::int16_t, 3>& date, DateOrder order) {
    const bool year_first = order == DateOrder::year_month_day;
    const int written = date[year_first ? 0 : 2];
    const int year = written >= 100 ? written : written + (written < 70 ? 2000 : 1900);
    const int month = date[order == DateOrder::month_day_year ? 0 : 1];
    const int day = date[year_first ? 2 : order == DateOrder::month_day_year ? 1 : 0];
    if (month < 1 || day < 1) {
        return std::nullopt;
    }
    const std::chrono::year_month_day read{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    return read.ok() ? std::optional(static_cast<int>(std::chrono::sys_days(read).time_since_epoch().count()))
                     : std::nullopt;
}

}  // namespace tiretherm::input
