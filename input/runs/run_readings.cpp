// SPDX-License-Identifier: BSD-3-Clause
// Collects sensor series, unused columns and [[measured]] numbers within the run's time span.

#include "input/runs/run_readings.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <variant>

#include <fmt/format.h>

#include "input/model/sensors.hpp"
#include "input/text/suggestions.hpp"
#include "input/text/word_lists.hpp"
#include "physics/celsius.hpp"

namespace tiretherm::input {

namespace {

int find_channel(const solver::Problem& problem, std::string_view name) {
    const auto found = std::find_if(problem.channels.begin(), problem.channels.end(),
                                    [&](const solver::Channel& channel) { return channel.name == name; });
    return found == problem.channels.end() ? -1 : static_cast<int>(found - problem.channels.begin());
}

/// Samples of the file that lie within the run, of two lines at one time the first.
class Samples {
public:
    Samples(const RunFile& file, const solver::Settings& settings) {
        for (std::size_t i = file.first; i < file.last; ++i) {
            const double t = file.time[i];
            if (t >= settings.start && t <= settings.end && (i == file.first || t != file.time[i - 1])) {
                rows_.push_back(i);
            }
        }
    }

    [[nodiscard]] std::vector<double> of(const std::vector<double>& all) const {
        std::vector<double> chosen;
        chosen.reserve(rows_.size());
        std::ranges::transform(rows_, std::back_inserter(chosen), [&](std::size_t row) { return all[row]; });
        return chosen;
    }

private:
    std::vector<std::size_t> rows_;
};

}  // namespace

void read_series(const RunFile& file, const solver::Problem& problem, InputErrors& errors, MeasuredRun& run) {
    std::vector<ColumnRequest> requests;
    std::vector<std::size_t> channels;
    for (const UsedColumn& column : file.columns.used) {
        const int channel = column.is_sensor ? find_channel(problem, column.name) : -1;
        if (channel < 0) {
            continue;
        }
        const auto index = static_cast<std::size_t>(channel);
        requests.push_back(file.file.request(column.column, column.name, value_spec(problem.channels[index].quantity)));
        channels.push_back(index);
    }
    const std::vector<std::vector<double>> read = file.file.read(requests, errors);
    if (file.time.empty()) {
        return;
    }
    const Samples samples(file, problem.settings);
    run.time = samples.of(file.time);
    for (std::size_t i = 0; i < read.size(); ++i) {
        MeasuredSeries series{.channel = channels[i], .value = samples.of(read[i])};
        for (std::size_t k = 0; k < run.time.size(); ++k) {
            const auto holds = [&](const LapWindow& lap) { return run.time[k] >= lap.from && run.time[k] < lap.to; };
            if (std::ranges::any_of(file.left_out, holds)) {
                series.value[k] = std::nan("");
            }
        }
        if (std::all_of(series.value.begin(), series.value.end(), [](double v) { return std::isnan(v); })) {
            const ColumnHead& head = file.file.heads()[static_cast<std::size_t>(requests[i].column)];
            errors.add(head.place, fmt::format("{} has no value in the run", requests[i].name),
                       fmt::format("leave the column out: ignore = [\"{}\"]", head.heading.name));
        } else {
            run.series.push_back(std::move(series));
        }
    }
}

void read_unused(const RunFile& file, const solver::Settings& settings, const MeasuredRun* beside, InputErrors& errors,
                 MeasuredRun& run) {
    const bool is_same = beside != nullptr && beside->file == run.file && beside->time == run.time;
    const Samples samples(file, settings);
    for (const int column : file.columns.unused) {
        const Heading& heading = file.file.heads()[static_cast<std::size_t>(column)].heading;
        if (is_same) {
            const auto known = std::ranges::find(beside->unused, heading.name, &UnusedSignal::name);
            if (known != beside->unused.end() && known->unit == heading.unit.value_or("")) {
                run.unused.push_back(*known);
                continue;
            }
        }
        const std::vector<std::vector<double>> read = file.file.read(
            {{.column = column, .name = heading.name, .spec = {.unit = "1"}, .purpose = Purpose::unused}}, errors);
        if (file.time.empty() || read.empty()) {
            return;
        }
        std::vector<double> value = samples.of(read.front());
        if (std::ranges::any_of(value, [](double v) { return std::isfinite(v); })) {
            run.unused.push_back({.name = heading.name, .unit = heading.unit.value_or(""), .value = std::move(value)});
        }
    }
}

void warn_of_starts(const TomlValue& document, const solver::Problem& problem, const MeasuredRun& run,
                    InputErrors& errors) {
    constexpr double far = 10.0;  // K; what a tire that stood a while differs by within itself
    const TomlValue* initial = document.find("initial");
    for (const mesh::LumpedNode& lumped : problem.mesh.lumped_nodes) {
        for (const MeasuredSeries& series : run.series) {
            const solver::Channel& channel = problem.channels[series.channel];
            const auto first = std::ranges::find_if(series.value, [](double v) { return !std::isnan(v); });
            if (initial == nullptr || initial->find(lumped.name) != nullptr || problem.initial.empty() ||
                channel.quantity != solver::Quantity::temperature || first == series.value.end() ||
                channel.where.nodes != std::vector<int>{lumped.node}) {
                continue;
            }
            const double start = problem.initial[static_cast<std::size_t>(lumped.node)];
            if (std::abs(*first - start) > far) {
                errors.warn(initial->place,
                            "{} starts at {:.0f} degC, as the {}, and {} reads {:.0f} degC first: "
                            "{} = \"{}\" in [initial] starts it there",
                            lumped.name, celsius(start), lumped.name == "drum" ? "road" : "air around", channel.name,
                            celsius(*first), lumped.name, channel.name);
            }
        }
    }
}

void read_numbers(const solver::Problem& problem, const TomlValue& document, const RunTable& table, InputErrors& errors,
                  MeasuredRun& run) {
    const TomlValue* list = document.find("measured");
    const bool own = table.table != nullptr && table.table->find("measured") != nullptr;
    const std::vector<solver::Measured>& numbers = problem.measured;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const solver::Measured& number = numbers[i];
        const int channel = find_channel(problem, number.channel);
        if (channel < 0) {
            continue;
        }
        const auto index = static_cast<std::size_t>(channel);
        const std::optional<double> sd =
            number.uncertainty ? number.uncertainty : problem.channels[index].standard_deviation;
        if (sd) {
            run.numbers.push_back({.channel = index,
                                   .time = number.time,
                                   .value = 0.5 * (number.low + number.high),
                                   .standard_deviation = *sd,
                                   .source = number.source});
        } else if (own) {
            const SourceLocation place = list != nullptr && i < list->items.size() ? list->items[i].place : table.place;
            errors.add(place, fmt::format("the number of {} has no uncertainty", number.channel),
                       fmt::format("add uncertainty = {}, its standard uncertainty",
                                   spell_example(deviation_spec(problem.channels[index].quantity))));
        }
    }
}

namespace {

/// Whether a column may hold what a temperature sensor reads: neither the clock nor in a unit of something else.
bool may_be_temperature(const Heading& heading) {
    const std::string unit = heading.unit.value_or("");
    const auto read = conversion(unit, "K", Scale::absolute);
    return unit.empty() ? nearest(heading.name, {"time", "t", "zeit", "timestamp"}).empty()
                        : unit == "C" || unit == "F" || std::holds_alternative<Conversion>(read);
}

/// A key as a case writes it in braces.
std::string spell_key(const std::string& key) {
    const bool bare =
        key.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") == std::string::npos;
    return bare ? key : fmt::format("\"{}\"", key);
}

/// The headings that the model does not use, the first few of them.
std::string some_headings(const RunFile& file) {
    constexpr std::size_t shown = 8;
    std::vector<std::string> names;
    for (const int column : file.columns.unused) {
        if (names.size() < shown) {
            names.push_back(file.file.heads()[static_cast<std::size_t>(column)].heading.name);
        }
    }
    return fmt::format("{}{}", fmt::join(names, ", "), file.columns.unused.size() > shown ? " ..." : "");
}

}  // namespace

void require_readings(const MeasuredRun& run, const RunTable& table, const RunFile* file,
                      const std::vector<std::string>& sensors, InputErrors& errors) {
    const bool has_column = file != nullptr && std::any_of(file->columns.used.begin(), file->columns.used.end(),
                                                           [](const UsedColumn& column) { return column.is_sensor; });
    const bool names_a_file = table.file || (table.table != nullptr && table.table->find("file") != nullptr);
    if (has_column || !run.numbers.empty() || !table.frames.empty() || (names_a_file && file == nullptr)) {
        return;
    }
    const std::string known =
        sensors.empty() ? "the case has no [[sensor]]; add one" : fmt::format("the sensors are {}", listed(sensors));
    if (file == nullptr) {
        errors.add(table.place, fmt::format("the run {} measures nothing", table.name),
                   fmt::format("give it a file, or measured = [{{ channel = \"{}\", value = \"...\", uncertainty = "
                               "\"...\" }}]",
                               sensors.empty() ? "..." : sensors.front()));
        return;
    }
    const SourceLocation place = table.place.file >= 0 ? table.place : SourceLocation{.file = file->file.number()};
    const auto unused = std::ranges::find_if(file->columns.unused, [&](int column) {
        return may_be_temperature(file->file.heads()[static_cast<std::size_t>(column)].heading);
    });
    const std::string example = unused == file->columns.unused.end()
                                    ? std::string("COLUMN")
                                    : spell_key(file->file.heads()[static_cast<std::size_t>(*unused)].heading.name);
    errors.add(place,
               fmt::format("none of the file's columns{} is mapped to a sensor: the run {} measures nothing",
                           file->columns.unused.empty() ? "" : fmt::format(" ({})", some_headings(*file)), table.name),
               fmt::format("map one: columns = {{ {} = \"{}\" }}; {}", example,
                           sensors.empty() ? "..." : sensors.front(), known));
}

}  // namespace tiretherm::input
