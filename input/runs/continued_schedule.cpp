// SPDX-License-Identifier: BSD-3-Clause
// Takes the last two speed steps as the pattern, appends rows to [[drive.schedule]] and reads the longer case.

#include "input/runs/continued_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "input/tables/columns.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/toml/toml_text.hpp"
#include "input/toml/tree.hpp"

namespace tiretherm::input {

namespace {

/// Where the columns of a schedule with speeds are, and how its numbers become times and speeds.
struct SpeedTable {
    TomlValue* rows = nullptr;
    std::size_t time = 0;
    std::size_t speed = 0;
    Conversion seconds{};
    Conversion metres_per_second{};
};

std::optional<SpeedTable> find_speed_table(TomlValue& document) {
    TomlValue* schedules = document.find({"drive", "schedule"});
    if (schedules == nullptr) {
        return std::nullopt;
    }
    for (TomlValue& schedule : schedules->items) {
        const TomlValue* columns = schedule.find("columns");
        SpeedTable table{.rows = schedule.find("rows")};
        bool has_speed = false;
        for (std::size_t i = 0; columns != nullptr && i < columns->items.size(); ++i) {
            const Heading heading = read_heading(columns->items[i].text);
            if (heading.name == "time") {
                table.time = i;
                table.seconds = read_heading_unit(heading, quantity_specs::moment).conversion;
            } else if (heading.name == "speed") {
                has_speed = true;
                table.speed = i;
                table.metres_per_second =
                    read_heading_unit(heading, quantity_specs::of(*physics::find_signal("speed"))).conversion;
            }
        }
        if (has_speed && table.rows != nullptr) {
            return table;
        }
    }
    return std::nullopt;
}

/// The last two steps, if the test rises from one to the other at one load; otherwise why it cannot go on.
struct RisingSteps {
    const solver::ScheduleStep* before = nullptr;
    const solver::ScheduleStep* last = nullptr;
    std::string refusal{};
};

RisingSteps pattern_of(std::span<const solver::ScheduleStep> steps) {
    std::vector<const solver::ScheduleStep*> standing;
    for (const solver::ScheduleStep& step : steps) {
        if (!step.ramp) {
            standing.push_back(&step);
        }
    }
    if (steps.empty() || steps.back().ramp || standing.size() < 2) {
        return {.refusal = "the test has no steps of speed that could go on"};
    }
    const RisingSteps pattern{.before = standing[standing.size() - 2], .last = standing.back()};
    if (!(pattern.last->speed > pattern.before->speed * (1.0 + 1e-9))) {
        return {.refusal = "the speed does not rise from the last step but one to the last"};
    }
    if (std::abs(pattern.last->load - pattern.before->load) > 1e-6 * pattern.last->load) {
        return {.refusal = "the schedule cannot be continued: the load changes between the last two steps"};
    }
    return pattern;
}

void append_row(const SpeedTable& table, double time, double speed) {
    TomlValue row = table.rows->items.back();
    const auto write = [&](std::size_t column, double number) {
        row.items[column].kind = TomlValue::Kind::real;
        row.items[column].number = number;
        row.items[column].text.clear();
    };
    write(table.time, table.seconds.from_si(time));
    write(table.speed, table.metres_per_second.from_si(speed));
    table.rows->items.push_back(std::move(row));
}

}  // namespace

ContinuedSchedule continue_schedule(const HotSpotCase& of, const solver::Settings& settings,
                                    std::span<const solver::ScheduleStep> steps) {
    if (std::ranges::any_of(steps, &solver::ScheduleStep::recognised)) {
        return {.refusal = "the speed comes from a log"};
    }
    const RisingSteps pattern = pattern_of(steps);
    if (!pattern.refusal.empty()) {
        return {.refusal = pattern.refusal};
    }
    ContinuedSchedule continued{
        .rise = pattern.last->speed - pattern.before->speed, .duration = pattern.before->duration(), .steps = 0};
    const double room = (fastest_continued * (1.0 + 1e-9) - pattern.last->speed) / continued.rise;
    continued.steps = std::min(most_continued, static_cast<int>(std::max(0.0, std::floor(room))));
    if (continued.steps == 0) {
        continued.refusal = fmt::format("a further step would be faster than {:.0f} km/h", 3.6 * fastest_continued);
        return continued;
    }
    TomlValue document = of.document();
    const std::optional<SpeedTable> table = find_speed_table(document);
    if (!table || table->rows->items.empty()) {
        continued.refusal = "the speed does not come from a [[drive.schedule]]";
        return continued;
    }
    const std::vector<TomlValue>& last_row = table->rows->items.back().items;
    if (std::max(table->time, table->speed) >= last_row.size() ||
        std::abs(table->seconds.to_si(last_row[table->time].number) - settings.end) >
            1e-6 * (settings.end - settings.start)) {
        continued.refusal = "the run does not end where its schedule does";
        return continued;
    }
    double time = settings.end;
    double speed = pattern.last->speed;
    for (int i = 0; i < continued.steps; ++i) {
        speed += continued.rise;
        append_row(*table, time, speed);
        time += continued.duration;
        append_row(*table, time, speed);
    }
    TomlValue end = toml_text::text_value(fmt::format("{:.17g} s", time));
    end.place = document.place;
    InputErrors unheard;
    if (set(document, {{"time", document.place}, {"end", document.place}}, end, unheard)) {
        continued.problem = of.problem_of(document);
    }
    if (!continued.problem) {
        continued.refusal = "the case cannot be read with further steps";
    }
    return continued;
}

}  // namespace tiretherm::input
