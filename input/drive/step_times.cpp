// SPDX-License-Identifier: BSD-3-Clause
// Reads the schedule of the case by itself and looks for the steps by their speeds or numbers.

#include "input/drive/step_times.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "input/drive/drive.hpp"
#include "input/text/word_lists.hpp"
#include "solver/hot_spot/schedule_steps.hpp"

namespace tiretherm::input {

namespace {

constexpr double same_speed = 0.01;  ///< relative; tables are headed by rounded speeds
constexpr double km_per_hour = 3.6;

/// The steps of the schedule, without the ramps between them. What is wrong with the schedule is said where the case is read.
std::vector<solver::ScheduleStep> steps_of(const TomlValue& document, const InputErrors& errors) {
    InputErrors again = errors;
    TomlTable root(document, "the case", again);
    root.allow_unknown_keys();
    const DriveTable drive = read_drive(root, nullptr, {});
    TomlTable time = root.subtable("time");
    time.allow_unknown_keys();
    const solver::InputSignals& inputs = drive.signals.inputs;
    const double start = time.quantity("start").value_or(0.0);
    const double last = inputs.stops().empty() ? start : inputs.stops().back();
    const double end = time.quantity("end").value_or(last);
    std::vector<solver::ScheduleStep> steps =
        end > start ? solver::schedule_steps(inputs, start, end) : std::vector<solver::ScheduleStep>{};
    std::erase_if(steps, [](const solver::ScheduleStep& step) { return step.ramp; });
    return steps;
}

std::string spell(const solver::ScheduleStep& step, bool by_speed) {
    return by_speed ? fmt::format("{:.4g} km/h", km_per_hour * step.speed) : fmt::format("{}", step.number);
}

}  // namespace

std::optional<std::vector<double>> step_times(const DataFile& file, const TomlValue& document, InputErrors& errors) {
    const bool by_speed = file.table().moments == LogTable::Moments::speeds;
    const std::vector<double>& moments = file.table().columns.front().number;
    const std::vector<solver::ScheduleStep> steps = steps_of(document, errors);
    constexpr std::string_view as_times = "write the time of each column as its heading: \"20 min\"";
    if (steps.empty()) {
        return errors.add(file.spot(0).place,
                          "the columns are steps of a test, and the case has no schedule with steps",
                          std::string(as_times));
    }
    std::vector<std::string> known;
    std::ranges::transform(steps, std::back_inserter(known),
                           [&](const solver::ScheduleStep& step) { return spell(step, by_speed); });
    std::vector<double> times;
    for (std::size_t k = 0; k < moments.size(); ++k) {
        const double wanted = moments[k];
        const auto is_meant = [&](const solver::ScheduleStep& step) {
            return by_speed ? std::abs(step.speed - wanted) <= same_speed * wanted : step.number == wanted;
        };
        const auto n = std::ranges::count_if(steps, is_meant);
        if (n != 1) {
            return errors.add(
                file.spot(k).place,
                fmt::format("{} of the case's schedule {} {}", n == 0 ? "no step" : fmt::format("{} steps", n),
                            by_speed ? n == 0 ? "runs at" : "run at" : "has the number",
                            by_speed ? fmt::format("{:.4g} km/h", km_per_hour * wanted) : fmt::format("{:g}", wanted)),
                fmt::format("its steps are {}; or {}", listed(known), as_times));
        }
        times.push_back(std::ranges::find_if(steps, is_meant)->to);
    }
    return times;
}

}  // namespace tiretherm::input
