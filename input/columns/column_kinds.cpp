// SPDX-License-Identifier: BSD-3-Clause
// The rules by which an unused column is a drive, a temperature of the tire, a copy, a result, a clock or constant.

#include "input/columns/column_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "input/columns/column_course.hpp"
#include "input/columns/column_references.hpp"
#include "input/text/column_names.hpp"
#include "input/text/units.hpp"

namespace tiretherm::input {

namespace {

constexpr double moves_alike = 0.95;  ///< correlation of a column with a sensor, both without their trends
constexpr double slow = 0.05;         ///< roughness of what has no jumps and little noise
constexpr double leads = 0.02;        ///< gain of the correlation by a shift that says that one comes before the other
constexpr double hotter = 30.0;       ///< K above every sensor of the tire: something else's temperature

struct ColumnVerdict {
    ColumnKind kind = ColumnKind::drive;
    std::string reason{};
};

/// A column over all runs.
struct UnusedColumn {
    std::string name;
    std::string unit;
    std::vector<UnusedSignal*> in{};  ///< [n_runs] null where the run does not have it
    Course course{};
    std::optional<ColumnVerdict> verdict{};
};

/// The unused columns of all runs, each once, without their courses.
std::vector<UnusedColumn> columns_of(std::vector<MeasuredRun>& runs) {
    std::vector<UnusedColumn> columns;
    std::map<std::string_view, std::size_t> known;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        for (UnusedSignal& signal : runs[r].unused) {
            const auto [at, is_new] = known.try_emplace(signal.name, columns.size());
            if (is_new) {
                columns.push_back({.name = signal.name, .unit = signal.unit});
                columns.back().in.resize(runs.size());
            }
            columns[at->second].in[r] = &signal;
        }
    }
    return columns;
}

/// The way from the start of each run; 0 where it has no speed.
std::vector<std::vector<double>> ways_of(const std::vector<MeasuredRun>& runs) {
    const physics::Signal& speed = *physics::find_signal("speed");
    std::vector<std::vector<double>> ways;
    for (const MeasuredRun& run : runs) {
        std::vector<double>& way = ways.emplace_back(run.time.size(), 0.0);
        double before = 0.0;
        for (std::size_t i = 0; i < way.size() && run.problem.input_signals.gives(speed); ++i) {
            const double now = std::abs(run.problem.input_signals.at(run.time[i], solver::JumpSide::before).speed);
            way[i] = i == 0 ? 0.0 : way[i - 1] + 0.5 * (now + before) * (run.time[i] - run.time[i - 1]);
            before = now;
        }
    }
    return ways;
}

/// Whether a column counts time or the way, on all its samples. @param ways of each run
bool is_clock(const std::vector<MeasuredRun>& runs, const std::vector<std::vector<double>>& ways,
              const UnusedColumn& column) {
    std::vector<std::span<const double>> value;
    std::vector<std::span<const double>> time;
    std::vector<std::span<const double>> way;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const UnusedSignal* before = r > 0 ? column.in[r - 1] : nullptr;  // which the corners of a recording share
        if (column.in[r] != nullptr && (before == nullptr || before->value.data() != column.in[r]->value.data())) {
            value.emplace_back(column.in[r]->value);
            time.emplace_back(runs[r].time);
            way.emplace_back(ways[r]);
        }
    }
    return counts(value, time) || counts(value, way);
}

std::string number(double r) { return fmt::format("r = {:.4f}", r); }

/// Of a temperature: whose it is, by its name, and where that says nothing by whether it comes before all sensors of the tire
/// and is hotter than any of them, as a brake or an exhaust.
ColumnVerdict judge_temperature(const UnusedColumn& column, const std::vector<Reference>& sensors) {
    if (const std::string word = word_of_tire(column.name); !word.empty()) {
        return {ColumnKind::temperature_of_tire, fmt::format("a temperature of the tire by its name ({})", word)};
    }
    if (const std::string word = word_from_outside(column.name); !word.empty()) {
        return {ColumnKind::drive, fmt::format("a temperature from outside of the tire by its name ({})", word)};
    }
    const auto read = conversion(column.unit == "C"   ? "degC"
                                 : column.unit == "F" ? "degF"
                                                      : column.unit,
                                 "K", Scale::absolute);
    const Conversion* kelvin = std::get_if<Conversion>(&read);
    const auto highest = [](const Course& course, const Conversion& si) {
        double most = -INFINITY;
        for (const double value : course.value) {
            most = std::isfinite(value) ? std::max(most, si.to_si(value)) : most;
        }
        return most;
    };
    const Course own = detrended(column.course);
    const bool outside =
        kelvin != nullptr && !sensors.empty() && std::ranges::all_of(sensors, [&](const Reference& sensor) {
            const Lead lead = lead_of(own, detrended(sensor.course));
            return lead.samples > 1 && std::abs(lead.correlation) > std::abs(lead.together) + leads &&
                   highest(column.course, *kelvin) > highest(sensor.course, {}) + hotter;
        });
    return outside ? ColumnVerdict{ColumnKind::drive,
                                   "a temperature that comes before all sensors of the tire and is hotter"}
                   : ColumnVerdict{ColumnKind::temperature_of_tire,
                                   "a temperature, and its name says of nothing that acts on the tire from outside"};
}

/// By name and unit, and by what needs no other column.
std::optional<ColumnVerdict> judge_alone(const UnusedColumn& column, const std::vector<MeasuredRun>& runs,
                                         const std::vector<std::vector<double>>& ways,
                                         const std::vector<Reference>& sensors) {
    if (is_constant(column.course)) {
        return ColumnVerdict{ColumnKind::constant, "never changes"};
    }
    if (const std::string word = word_of_result(column.name); !word.empty()) {
        return ColumnVerdict{ColumnKind::result, fmt::format("computed, by its name ({})", word)};
    }
    if (is_temperature(column.name, column.unit)) {
        return judge_temperature(column, sensors);
    }
    // However evenly it rises, a pressure counts nothing.
    if (!column.unit.empty() && std::holds_alternative<Conversion>(conversion(column.unit, "Pa", Scale::absolute))) {
        const std::string word = word_of_tire(column.name);
        return word.empty()
                   ? std::nullopt
                   : std::optional(ColumnVerdict{
                         ColumnKind::result,
                         fmt::format("a pressure of the tire by its name ({}), which follows its temperature", word)});
    }
    if (const std::string word = word_of_clock(column.name); !word.empty()) {
        return ColumnVerdict{ColumnKind::clock,
                             fmt::format("a time, a counter, a distance or a place by its name ({})", word)};
    }
    if (is_clock(runs, ways, column)) {
        return ColumnVerdict{ColumnKind::clock, "goes evenly with the time or the way, or counts"};
    }
    return std::nullopt;
}

/// Beside inputs and sensors.
std::optional<ColumnVerdict> judge_beside(const UnusedColumn& column, const std::vector<double>& standard,
                                          const std::vector<Reference>& inputs, const std::vector<Reference>& products,
                                          const std::vector<Reference>& sensors) {
    for (const std::vector<Reference>* list : {&inputs, &sensors}) {
        for (const Reference& other : *list) {
            if (is_copy(standard, other.standard)) {
                return ColumnVerdict{ColumnKind::copy, fmt::format("a copy of {} ({})", other.name,
                                                                   number(correlation(standard, other.standard)))};
            }
        }
    }
    for (const Reference& product : products) {
        if (is_copy(standard, product.standard)) {
            return ColumnVerdict{ColumnKind::result, fmt::format("follows from inputs: {} ({})", product.name,
                                                                 number(correlation(standard, product.standard)))};
        }
    }
    for (const Reference& input : inputs) {
        if (is_function(column.course.value, input.course.value)) {
            return ColumnVerdict{ColumnKind::result, fmt::format("an exact function of {}", input.name)};
        }
    }
    const Course own = detrended(column.course);
    for (const Reference& sensor : sensors) {
        const Course other = detrended(sensor.course);
        if (roughness(own) > std::max(slow, 2.0 * roughness(other))) {
            continue;  // it jumps, which no temperature does
        }
        const Lead lead = lead_of(own, other);
        const bool before = lead.samples > 0 && std::abs(lead.correlation) > std::abs(lead.together) + 0.1 * leads;
        if (std::abs(lead.correlation) > moves_alike && !before) {
            return ColumnVerdict{ColumnKind::temperature_of_tire,
                                 fmt::format("moves like {} ({})", sensor.name, number(lead.correlation))};
        }
    }
    return std::nullopt;
}

}  // namespace

void classify_unused(std::vector<MeasuredRun>& runs) {
    std::vector<UnusedColumn> columns = columns_of(runs);
    if (columns.empty()) {
        return;
    }
    const CommonSamples samples(runs, columns.size());
    for (UnusedColumn& column : columns) {
        column.course = samples.of([&](std::size_t r, std::size_t row) {
            return column.in[r] == nullptr ? std::nan("") : column.in[r]->value[row];
        });
    }
    const std::vector<std::vector<double>> ways = ways_of(runs);
    const std::vector<Reference> inputs = changing_inputs(runs, samples);
    const std::vector<Reference> products = products_of(inputs);
    const std::vector<Reference> sensors = temperature_sensors(runs, samples);
    std::vector<std::pair<const UnusedColumn*, std::vector<double>>> drives;
    for (UnusedColumn& column : columns) {
        column.verdict = judge_alone(column, runs, ways, sensors);
        if (column.verdict && column.verdict->kind != ColumnKind::drive) {
            continue;
        }
        std::vector<double> standard = standardised(column.course.value);
        if (!column.verdict) {
            column.verdict = judge_beside(column, standard, inputs, products, sensors);
        }
        if (!column.verdict || column.verdict->kind == ColumnKind::drive) {
            const auto same =
                std::ranges::find_if(drives, [&](const auto& drive) { return is_copy(standard, drive.second); });
            if (same == drives.end()) {
                column.verdict = column.verdict.value_or(ColumnVerdict{});
                drives.emplace_back(&column, std::move(standard));
            } else {
                column.verdict = ColumnVerdict{
                    ColumnKind::copy,
                    fmt::format("a copy of {} ({})", same->first->name, number(correlation(standard, same->second)))};
            }
        }
    }
    for (const UnusedColumn& column : columns) {
        for (UnusedSignal* signal : column.in) {
            if (signal != nullptr) {
                signal->kind = column.verdict->kind;
                signal->reason = column.verdict->reason;
                signal->may_be_cause = signal->kind == ColumnKind::drive;
            }
        }
    }
}

}  // namespace tiretherm::input
