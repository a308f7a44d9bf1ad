// SPDX-License-Identifier: BSD-3-Clause
// Decides the order of dates, and counts on over midnight and the hours of daylight saving.

#include "input/clock/clock_times.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "input/clock/clock_words.hpp"
#include "solver/order_statistics.hpp"

namespace tiretherm::input {

namespace {

constexpr double day = 86400.0;
constexpr double hour = 3600.0;

std::string_view spelt(DateOrder order) {
    constexpr std::array<std::string_view, 3> words{"day/month/year", "month/day/year", "year/month/day"};
    return words[static_cast<std::size_t>(order)];
}

std::string_view unit_of(DateOrder order) {
    constexpr std::array<std::string_view, 3> units{"d/m/y", "m/d/y", "y/m/d"};
    return units[static_cast<std::size_t>(order)];
}

std::string how_to_say(std::string_view column, std::string_view one, std::string_view other) {
    return fmt::format(
        "write \"{0} [{1}]\" or \"{0} [{2}]\" in the heading, units = {{ \"{0}\" = \"{1}\" }} in the case, or "
        "--unit \"{0}={1}\"",
        column, one, other);
}

/// A column of dates, read in one order.
struct OrderTrial {
    DateOrder order = DateOrder::day_month_year;
    bool exists = true;  ///< there are such days
    bool ascends = true;
    int widest = 0;  ///< days between neighbouring lines
};

OrderTrial try_order(const std::vector<Stamp>& stamps, DateOrder order) {
    OrderTrial trial{.order = order};
    const Stamp* last = nullptr;
    int last_day = 0;
    for (const Stamp& stamp : stamps) {
        if (stamp.orders == 0 || (last != nullptr && stamp.date == last->date)) {
            continue;
        }
        const std::optional<int> number = day_number(stamp.date, order);
        if (!number || (stamp.orders & bit_of(order)) == 0) {
            return {.order = order, .exists = false};
        }
        if (last != nullptr) {
            trial.ascends = trial.ascends && *number >= last_day;
            trial.widest = std::max(trial.widest, std::abs(*number - last_day));
        }
        last = &stamp;
        last_day = *number;
    }
    return trial;
}

/// "10/24/2026" of a stamp.
std::string spell_date(const Stamp& stamp) {
    return fmt::format("{:02}/{:02}/{:02}", stamp.date[0], stamp.date[1], stamp.date[2]);
}

DateOrder choose_order(const std::vector<Stamp>& stamps, const Heading& heading, ClockTimes& into) {
    constexpr int near = 7;  // days
    constexpr int far = 28;  // the first days of two months are as far apart
    const auto dated = std::ranges::find_if(stamps, [](const Stamp& stamp) { return stamp.orders != 0; });
    if (dated == stamps.end()) {
        return DateOrder::day_month_year;
    }
    // What the heading or the user says wins over what the dates look like.
    if (const auto said = clock_spelling(heading.unit.value_or("")); said && said->order) {
        return *said->order;
    }
    std::vector<OrderTrial> left;
    for (const DateOrder order : date_orders) {
        if ((dated->orders & bit_of(order)) != 0) {
            left.push_back(try_order(stamps, order));
        }
    }
    // When no order gives days that exist the fields are wrong, and any order will do to say so.
    const DateOrder usual = left.front().order;
    const auto keep = [&](auto&& is_right) {
        if (std::ranges::any_of(left, is_right)) {
            std::erase_if(left, [&](const OrderTrial& trial) { return !is_right(trial); });
        }
    };
    keep([](const OrderTrial& trial) { return trial.exists; });
    keep([](const OrderTrial& trial) { return trial.ascends; });
    if (!left.front().exists) {
        return usual;
    }
    const auto widest = [](const OrderTrial& trial) { return trial.widest; };
    const OrderTrial narrow = *std::ranges::min_element(left, {}, widest);
    const bool is_one_day = std::ranges::all_of(left, [](const OrderTrial& trial) { return trial.widest == 0; });
    if (left.size() == 1 || is_one_day) {
        return narrow.order;
    }
    const auto others = std::ranges::count_if(left, [](const OrderTrial& trial) { return trial.widest >= far; });
    const auto other = std::ranges::find_if(left, [&](const OrderTrial& trial) { return trial.order != narrow.order; });
    if (narrow.widest <= near && static_cast<std::size_t>(others) + 1 == left.size()) {
        into.remarks.push_back(fmt::format(
            "{}: dates such as {} are read as {}, in which the days follow one another; as {} lines would be "
            "{} days apart",
            heading.name, spell_date(*dated), spelt(narrow.order), spelt(other->order), other->widest));
        return narrow.order;
    }
    into.question = ErrorText{fmt::format("{} is {} or {} in {}, and no line tells which", spell_date(*dated),
                                          spelt(narrow.order), spelt(other->order), heading.name),
                              how_to_say(heading.name, unit_of(narrow.order), unit_of(other->order))};
    return narrow.order;
}

/// Whether 11:20 is minutes and seconds: where the heading says so, other lines have decimals, or hours came later.
bool are_minutes(const std::vector<Stamp>& stamps, const Heading& heading, ClockTimes& into) {
    using Parts = Stamp::Parts;
    const auto has = [&](Parts parts) {
        return std::ranges::any_of(stamps, [&](const Stamp& s) { return s.parts == parts && !std::isnan(s.seconds); });
    };
    if (!has(Parts::two)) {
        return false;
    }
    if (const auto said = clock_spelling(heading.unit.value_or("")); said && said->is_minutes) {
        return *said->is_minutes;
    }
    if (has(Parts::minutes) || has(Parts::whole)) {
        return true;
    }
    double last = 0.0;
    for (const Stamp& stamp : stamps) {  // from 23:59 to 00:00
        if (last >= 23.0 * hour && last < day && stamp.seconds < hour) {
            return false;
        }
        last = stamp.seconds;
    }
    into.question = ErrorText{fmt::format("{} may be hours and minutes, or minutes and seconds", heading.name),
                              how_to_say(heading.name, "h:mm", "m:ss")};
    return false;
}

/// Whether clocks are changed at this time: early on a Sunday. @param time s since 1970 or of a day  @param dated which of them
bool may_be_changed(double time, bool dated) {
    constexpr int sunday = 3;  // 1 January 1970 was a Thursday, day 0
    const double of_day = time - day * std::floor(time / day);
    const int number = static_cast<int>(std::floor(time / day));
    return of_day < 4.0 * hour && (!dated || number % 7 == sunday);
}

/// Adds what a clock that has passed midnight, or has been changed by an hour, no longer shows.
void count_on(std::vector<double>& times, bool dated, const Heading& heading, ClockTimes& into) {
    const double step = solver::median_step(times);
    const double longest = 3.0 * step;  // between lines that follow one another
    double added = 0.0;
    double last = std::nan("");
    for (double& time : times) {
        if (std::isnan(time)) {
            continue;
        }
        const double gone = time + added - last;
        const double shown = time;
        // A clock of the day that goes back by more than half of one has passed midnight.
        if (!dated && gone < -0.5 * day) {
            added += day;
        } else if (gone < 0.0 && gone + hour > 0.0 && gone + hour <= longest && may_be_changed(shown, dated)) {
            added += hour;
            into.remarks.push_back(
                fmt::format("{}: an hour stands twice, as when daylight saving ends: the times go on", heading.name));
        } else if (dated && gone - hour > 0.0 && gone - hour <= longest && gone > longest && step < 0.25 * hour &&
                   may_be_changed(shown, dated)) {
            added -= hour;
            into.remarks.push_back(fmt::format(
                "{}: an hour is missing, as when daylight saving begins: the times go on without it", heading.name));
        }
        time += added;
        last = time;
    }
}

}  // namespace

ClockTimes clock_times(const std::vector<Stamp>& stamps, FieldForm form, const Heading& heading, bool spread) {
    ClockTimes found;
    const DateOrder order = choose_order(stamps, heading, found);
    const bool minutes = are_minutes(stamps, heading, found);
    const bool dated = std::ranges::any_of(stamps, [](const Stamp& stamp) { return stamp.orders != 0; });
    found.seconds.reserve(stamps.size());
    const Stamp* last = nullptr;
    double date = 0.0;
    for (const Stamp& stamp : stamps) {
        if (stamp.orders != 0 && (last == nullptr || stamp.date != last->date)) {
            const std::optional<int> number = day_number(stamp.date, order);
            date = number ? day * *number : std::nan("");
            last = &stamp;
        }
        const bool undated_line = dated && stamp.orders == 0;
        const double of_day = minutes && stamp.parts == Stamp::Parts::two ? stamp.seconds / 60.0 : stamp.seconds;
        found.seconds.push_back(undated_line ? std::nan("") : date + of_day);
    }
    if (form == FieldForm::clock || form == FieldForm::digits) {
        count_on(found.seconds, dated, heading, found);
    }
    if (std::string remark = spread ? share_out(found.seconds, 1) : ""; !remark.empty()) {
        found.remarks.push_back(fmt::format("{}: {}", heading.name, remark));
    }
    const auto first = std::ranges::find_if(found.seconds, [](double t) { return !std::isnan(t); });
    const double start = first == found.seconds.end() ? 0.0 : *first;
    for (double& time : found.seconds) {
        // Differences of clocks are decimal fractions; a microsecond is finer than any logger's.
        time = std::round((time - start) * 1e6) / 1e6;
    }
    return found;
}

}  // namespace tiretherm::input
