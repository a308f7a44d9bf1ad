// SPDX-License-Identifier: BSD-3-Clause
// Reads [time]: start, end or steady state, step or tolerance, output intervals, time-integration method and linear
// solver.

#include <algorithm>

#include <fmt/format.h>

#include "input/drive/run_span.hpp"
#include "input/text/quantity_specs.hpp"

namespace tiretherm::input {

namespace {

constexpr double many_steps = 1e7;  // more are a slip of the unit: at 1 kHz they last three hours

/// A log goes on beyond the run, which somebody who included the run's end from another file does not see.
void warn_of_cut_log(const TomlTable& time, const solver::Settings& settings, const DrivenSpan& span) {
    if (!span.logged_from || !span.logged_to || settings.steady) {
        return;
    }
    const double length = *span.logged_to - *span.logged_from;
    const double before = settings.start - *span.logged_from;
    const double after = *span.logged_to - settings.end;
    const auto warn = [&](std::string_view key, double cut, std::string_view which) {
        if (time.has(key) && cut > 1e-6 * length) {
            time.errors().warn(time.place(key),
                               "[time] {} cuts {} of {} off the {} of the log; {} = \"{:.10g} s\" in the "
                               "case would use all of it",
                               key, in_minutes(std::min(cut, length)), in_minutes(length), which, key,
                               key == "start" ? *span.logged_from : *span.logged_to);
        }
    };
    warn("start", before, "beginning");
    warn("end", after, "end");
}

}  // namespace

solver::Settings read_time_settings(TomlTable& root, const DrivenSpan& span, const RunInputs* run) {
    solver::Settings into;
    // A measured run lasts as long as its file, unless its own table says otherwise.
    const bool of_file = run != nullptr && run->last;
    const bool own_start = of_file && run->says("time", "start");
    const bool own_end = of_file && run->says("time", "end");
    const bool implied = span.logged_to || (run != nullptr && run->has_file);
    TomlTable time = root.subtable("time", implied ? Need::optional : Need::required);
    time.read_into(into);
    into.start = time.quantity("start").value_or(span.logged_from.value_or(0.0));
    const auto end = time.quantity("end", implied || into.steady ? Need::optional : Need::required);
    into.end = end.value_or(span.logged_to.value_or(into.start));
    if (of_file) {
        into.start = own_start ? into.start : start_of_run(*run, span, into.start, end);
        into.end = own_end ? into.end : *run->last;
    }
    if (own_start && run->lead > 0.0) {
        time.add_error("start", "start and repeat_first_lap both say where the run begins", "keep one of them");
    }

    const double length = into.end - into.start;
    if ((end || own_start) && !into.steady && !(length > 0.0)) {
        time.add_error(of_file && !own_end ? "start" : "end",
                       fmt::format("the run ends at {:.6g} s and starts at {:.6g} s", into.end, into.start),
                       "let end be later than start");
        return into;
    }
    if (!of_file) {
        warn_of_cut_log(time, into, span);
    }
    if (into.fixed_step && length / *into.fixed_step > many_steps) {
        time.errors().warn(time.place("step"), "step divides the run into {:.2g} pieces", length / *into.fixed_step);
    }
    for (const std::string_view key : {"tolerance", "largest_step"}) {
        if (into.fixed_step && time.has(key)) {
            time.errors().warn(time.place(key), "{} has no effect: the step is fixed", key);
        }
    }
    return into;
}

}  // namespace tiretherm::input
