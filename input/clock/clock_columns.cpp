// SPDX-License-Identifier: BSD-3-Clause
// Knows times by what loggers call them and by their first fields.

#include "input/clock/clock_columns.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "input/tables/csv.hpp"
#include "input/text/column_names.hpp"

namespace tiretherm::input {

namespace {

/// "timestampms" is "timestamp" with "ms". @returns the unit; empty: none at the end of a name of a time
std::string_view unit_at_end(std::string_view name) {
    // The longer ends come first: "ms" ends with an s, and "seconds" does, too.
    for (const std::string_view unit : {"ms", "us", "ns", "seconds", "sec", "s", "minutes", "min", "hours", "h"}) {
        if (name.ends_with(unit) && has_word(column_words::clocks, name.substr(0, name.size() - unit.size()))) {
            return unit;
        }
    }
    return {};
}

constexpr std::size_t no_clock = column_words::clocks.size();

/// The place of a name among those of times, the surer the lower; `no_clock` of another.
std::size_t rank_of(std::string_view heading) {
    std::string name = bare_name(heading);
    name.resize(name.size() - unit_at_end(name).size());
    return has_word(column_words::clocks, name) ? (" " + std::string(column_words::clocks) + " ").find(" " + name + " ")
                                                : no_clock;
}

bool may_be_digits(double value) {
    const double minutes = std::floor(value / 100.0);
    return value >= 0.0 && value < 240000.0 && std::fmod(value, 100.0) < 60.0 && std::fmod(minutes, 100.0) < 60.0;
}

/// Whether numbers are digits of a clock: they never have more than 59 seconds, and at least once go on by 41 at the end of a minute.
bool are_digits(const std::function<void(const FieldVisitor&)>& visit) {
    bool may_be = true;
    bool ends_a_minute = false;
    double last = -1.0;
    visit([&](std::string_view field) {
        const std::optional<Number> number = leading_number(field);
        may_be = number && number->rest.empty() && may_be_digits(number->value);
        if (may_be) {
            const bool is_next = std::floor(number->value / 100.0) != std::floor(last / 100.0);
            ends_a_minute = ends_a_minute || (last >= 0.0 && is_next && std::fmod(last, 100.0) >= 50.0 &&
                                              std::fmod(number->value, 100.0) < 10.0);
            last = number->value;
        }
        return may_be;
    });
    return may_be && ends_a_minute;
}

/// Whether numbers are days as a spreadsheet counts them, from 2000 on: they go on by less than any seconds of a day do.
bool are_days(const std::function<void(const FieldVisitor&)>& visit) {
    // 1 January 2000 and 31 December 2099 as spreadsheets count days, from the first one of 1900 on. Before and after them a
    // number of this size is more likely something else than a moment.
    constexpr double first_day = 36526.0;
    constexpr double last_day = 73050.0;
    constexpr double longest_step = 9e-4;  // 78 s, or less than the step of a clock of 1 kHz
    double last = std::nan("");
    bool goes_on = false;
    std::string room;
    visit([&](std::string_view field) {
        const std::optional<Number> number = leading_number(with_point(field, room));
        const bool may_be = number && number->rest.empty() && number->value >= first_day && number->value < last_day;
        const double step = may_be ? number->value - last : 0.0;
        goes_on = step > 0.0 && step < longest_step;
        last = may_be ? number->value : last;
        return may_be && !(step > 0.0);
    });
    return goes_on;
}

}  // namespace

void take_time_units(std::vector<ColumnHead>& heads) {
    for (ColumnHead& head : heads) {
        if (const std::string_view unit = unit_at_end(bare_name(head.heading.name));
            !unit.empty() && !head.heading.unit) {
            head.heading.unit = unit == "sec" ? "s" : std::string(unit);
        }
    }
}

FieldForm form_of(const ColumnHead& head, std::string_view first,
                  const std::function<void(const FieldVisitor&)>& visit) {
    constexpr double before_loggers = 3e8;  // s since 1970, in 1979
    constexpr double after_them = 1e10;     // s; as many milliseconds were gone in 1970
    constexpr double least_digits = 1e4;    // one o'clock; a clock of seconds from the start begins at less
    const bool is_named = rank_of(head.heading.name) != no_clock;
    const auto is_nothing = [](std::string_view field) { return field.empty() || field == "-"; };
    if (is_named && is_nothing(first)) {
        visit([&](std::string_view field) {
            first = field;
            return is_nothing(field);
        });
    }
    if (is_clock(first)) {
        return FieldForm::clock;
    }
    const std::string unit = head.heading.unit.value_or("");
    if (unit == "unix time") {
        return FieldForm::since;
    }
    std::string room;
    const std::optional<Number> number = leading_number(with_point(first, room));
    if (!is_named || !number || !number->rest.empty()) {
        return FieldForm::number;
    }
    struct Since {
        std::string_view unit;
        FieldForm form;
    };
    for (const auto& [of, form] : {Since{"s", FieldForm::since}, Since{"ms", FieldForm::since_in_ms},
                                   Since{"us", FieldForm::since_in_us}, Since{"ns", FieldForm::since_in_ns}}) {
        const double seconds = seconds_of_one(form) * number->value;
        if ((unit.empty() || unit == of) && seconds > before_loggers && seconds < after_them) {
            return form;
        }
    }
    if (unit.empty() && are_days(visit)) {
        return FieldForm::since_in_days;
    }
    const bool is_large = number->value >= least_digits && may_be_digits(number->value);
    return unit.empty() && is_large && are_digits(visit) ? FieldForm::digits : FieldForm::number;
}

void mark_clock(std::vector<ColumnHead>& heads) {
    const auto is_time = [](const ColumnHead& head) { return head.heading.name == "time"; };
    if (std::ranges::any_of(heads, is_time)) {
        return;
    }
    ColumnHead* surest = nullptr;
    std::size_t least = 2 * no_clock;
    for (ColumnHead& head : heads) {
        const std::size_t rank = rank_of(head.heading.name);
        // Digits of a clock are whole seconds in most files: a time beside them is finer.
        const std::size_t behind = head.form == FieldForm::digits ? no_clock : 0;
        if (rank < no_clock && rank + behind < least) {
            least = rank + behind;
            surest = &head;
        }
    }
    if (surest != nullptr) {
        surest->is_clock = true;
        return;
    }
    const auto has_clock = [](const ColumnHead& head) { return head.form != FieldForm::number; };
    if (std::ranges::count_if(heads, has_clock) == 1) {
        std::ranges::find_if(heads, has_clock)->is_clock = true;
    }
}

void find_dates(std::vector<ColumnHead>& heads, const std::vector<std::string_view>& first) {
    const auto clock = std::ranges::find_if(heads, [](const ColumnHead& head) {
        return (head.is_clock || head.heading.name == "time") && head.form == FieldForm::clock;
    });
    const auto dates = std::ranges::find_if(first, is_date);
    if (clock != heads.end() && dates != first.end()) {
        const auto at = static_cast<std::size_t>(clock - heads.begin());
        const bool is_undated = at < first.size() && read_stamp(first[at], FieldForm::clock).orders == 0;
        clock->date_column = is_undated ? static_cast<int>(dates - first.begin()) : -1;
    }
}

}  // namespace tiretherm::input
