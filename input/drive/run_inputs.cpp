// SPDX-License-Identifier: BSD-3-Clause
// Finds the samples within `from` and `to`, bridges short gaps by straight lines and refuses long ones.

#include "input/drive/run_inputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/drive/step_times.hpp"
#include "input/laps/file_laps.hpp"
#include "input/measurements/data_stretches.hpp"
#include "input/measurements/dead_stretches.hpp"
#include "input/model/probes.hpp"
#include "input/text/quantity_specs.hpp"
#include "input/vehicle/dead_channels.hpp"

namespace tiretherm::input {

namespace {

bool find_samples(const RunTable& run, RunFile& file, InputErrors& errors) {
    const std::vector<double>& time = file.time;
    std::optional<double> from = run.from;
    std::optional<double> to = run.to;
    file.laps = find_laps(file.file, time, run.start_line, run.laps.has_value(), errors);
    if (run.laps) {
        LapChoice choice = choose_laps(run.laps->text, file.laps);
        if (!choice.window) {
            errors.add(run.laps->place, std::move(*choice.error), std::move(choice.remedy));
            return false;
        }
        from = choice.window->from;
        to = choice.window->to;
        file.left_out = std::move(choice.left_out);
        if (run.repeat_first_lap > 0 && choice.starts_from_the_pits) {
            errors.warn(run.laps->place,
                        "the lap that is driven before is the first of the file: if the car comes from the pits, speed "
                        "and forces jump between its repetitions; let laps begin with the next");
        }
        file.repeated = {.from = *from, .to = choice.first_ends, .times = run.repeat_first_lap};
    }
    const auto first = from ? std::lower_bound(time.begin(), time.end(), *from) : time.begin();
    const auto last = to ? std::upper_bound(time.begin(), time.end(), *to) : time.end();
    const SourceLocation place = run.place.file >= 0 ? run.place : SourceLocation{.file = file.file.number()};
    if (last - first < 2) {
        const std::string span = fmt::format("the file goes from {:.6g} s to {:.6g} s", time.front(), time.back());
        errors.add(place,
                   from || to ? fmt::format("fewer than two samples lie between from and to: {}", span)
                              : "the file has a single sample: a run goes from one time to another",
                   from || to ? "choose from and to within the file"
                              : "a single reading is a [[measured]] of the case, with channel, value and time");
        return false;
    }
    file.first = static_cast<std::size_t>(first - time.begin());
    file.last = static_cast<std::size_t>(last - time.begin());
    return true;
}

}  // namespace

std::optional<RunFile> open_run_file(const RunTable& run, const TomlValue& document,
                                     const std::vector<std::string>& sensors, const std::vector<std::string>& followed,
                                     InputErrors& errors) {
    std::optional<DataFile> file = DataFile::open(*run.file, run.place, errors);
    if (!file) {
        return std::nullopt;
    }
    if (file->table().moments != LogTable::Moments::times) {
        std::optional<std::vector<double>> times = step_times(*file, document, errors);
        if (!times) {
            return std::nullopt;
        }
        file->take_times(std::move(*times));
    }
    RunColumns columns = classify_columns(*file, *run.keys, sensors, followed, errors);
    RunFile opened{.file = std::move(*file), .columns = std::move(columns)};
    opened.file.choose_rows(opened.columns.chosen());
    if (opened.columns.time < 0) {
        errors.add(opened.file.heads().front().place, "the file has no column time [s]",
                   "rename one: columns = { t = \"time\" }");
        return opened;
    }
    std::vector<std::vector<double>> read = opened.file.read(
        {opened.file.request(opened.columns.time, "time", quantity_specs::moment, Purpose::clock)}, errors);
    if (!read.empty()) {
        opened.time = std::move(read.front());
        if (!find_samples(run, opened, errors)) {
            opened.time.clear();
        }
    }
    return opened;
}

namespace {

/// Of all samples of a file those that belong to the run.
std::vector<double> cut(std::vector<double> all, const RunFile& file) {
    all.resize(std::min(file.last, all.size()));
    all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(file.first, all.size())));
    return all;
}

/// The columns that user effects follow, in base units whatever their unit is.
void read_followed(const RunFile& file, ColumnKeys& keys, RunInputs& into, InputErrors& errors) {
    const std::vector<FollowedColumn>& followed = file.columns.followed;
    std::vector<ColumnRequest> requests;
    into.columns.reserve(followed.size());  // requests look into it
    for (const FollowedColumn& column : followed) {
        const ColumnHead& head = file.file.heads()[static_cast<std::size_t>(column.column)];
        into.columns.push_back({.name = column.name, .unit = base_unit(head.heading.unit), .signal = {}});
        requests.push_back(file.file.request(column.column, column.name, {.unit = into.columns.back().unit}));
    }
    std::vector<std::vector<double>> read = file.file.read(requests, errors);
    const solver::SharedSamples time = cut(file.time, file);
    for (std::size_t i = 0; !file.time.empty() && i < read.size(); ++i) {
        const SourceLocation& place = file.file.heads()[static_cast<std::size_t>(followed[i].column)].place;
        const auto found = driving_samples(
            {.name = followed[i].name,
             .time = time,
             .value = cut(std::move(read[i]), file),
             .holds = keys.holds(followed[i].name),
             .before = file.repeated},
            {.place = place, .elsewhere = "let the effect follow another signal", .can_split = true}, errors);
        if (found) {
            into.columns[i].signal = {.time = found->time, .value = found->value};
            into.columns[i].beside =
                live_column_beside(file.file, followed[i].column, into.columns[i], file.time, errors);
        }
    }
}

}  // namespace

void leave_out_dead(const ColumnRequest& column, const SourceLocation& place, const ColumnKeys& keys,
                    const std::vector<double>& time, std::vector<double>& value, InputErrors& errors) {
    const std::string dead = keys.keeps_suspicious() ? std::string() : remove_dead(time, value, column.spec.unit);
    if (!dead.empty()) {
        errors.warn(place, "{} {}: left out", column.name, dead);
    }
}

RunInputs read_run_inputs(const RunTable& run, const RunFile* file, InputErrors& errors) {
    RunInputs into{.table = run.table, .name = run.name, .place = run.place};
    into.has_file = run.file.has_value();
    if (file == nullptr) {
        into.unreadable = into.has_file;
        return into;
    }
    if (into.place.file < 0) {
        into.place = {.file = file->file.number()};
    }
    into.unreadable = file->columns.misnamed;
    for (const ColumnHead& head : file->file.heads()) {
        into.headings.push_back(head.heading.name);
    }
    read_followed(*file, *run.keys, into, errors);
    std::vector<ColumnRequest> requests;
    for (const UsedColumn& column : file->columns.used) {
        if (column.input != nullptr) {
            const ColumnHead& head = file->file.heads()[static_cast<std::size_t>(column.column)];
            requests.push_back(file->file.request(column.column, column.name, quantity_specs::of(*column.input)));
            into.inputs.push_back({.signal = column.input, .place = head.place, .time = {}, .value = {}});
        }
    }
    std::vector<std::vector<double>> read = file->file.read(requests, errors);
    if (file->time.empty()) {
        return into;
    }
    const solver::SharedSamples time = cut(file->time, *file);
    into.lead = file->repeated.lead();
    into.left_out = file->left_out;
    into.file_first = file->time.front();
    into.part_of_file = run.from || run.laps;
    into.first = time.front() - into.lead;
    into.last = time.back();
    for (std::size_t i = 0; i < read.size(); ++i) {
        MeasuredInput& input = into.inputs[i];
        const std::string& name = requests[i].name;
        leave_out_dead(requests[i], input.place, *run.keys, file->time, read[i], errors);
        const auto found = driving_samples({.name = name,
                                            .time = time,
                                            .value = cut(std::move(read[i]), *file),
                                            .holds = run.keys->holds(name),
                                            .before = file->repeated},
                                           {.place = input.place,
                                            .elsewhere = fmt::format("ignore the column and give {} in [drive]", name),
                                            .can_split = true},
                                           errors);
        if (found) {
            input.time = found->time;
            input.value = found->value;
        }
    }
    return into;
}

namespace {

/// The inputs as the data checks look at them.
Recording recording_of_inputs(const RunInputs& inputs) {
    Recording recording;
    for (const MeasuredInput& input : inputs.inputs) {
        RecordedColumn& column = recording.columns.emplace_back();
        column.name = input.signal->name;
        column.is_input = true;
        column.time = input.time;
        column.value = input.value;
    }
    return recording;
}

}  // namespace

std::vector<StartReading> start_readings(const RunTable& run, const RunFile& file, const RunInputs& inputs,
                                         const TomlValue& document, const InputErrors& errors) {
    std::vector<StartReading> found;
    std::vector<ColumnRequest> requests;
    const TomlValue* initial = document.find("initial");
    for (const Entry& entry : initial != nullptr ? initial->entries : std::vector<Entry>{}) {
        for (const UsedColumn& column : file.columns.used) {
            const bool is_named = entry.value.kind == TomlValue::Kind::text && column.is_sensor &&
                                  is_channel_of(column.name, entry.value.text);
            if (is_named && std::ranges::find(found, column.name, &StartReading::sensor) == found.end()) {
                found.push_back({.sensor = column.name, .reading = {}});
                requests.push_back({.column = column.column,
                                    .name = column.name,
                                    .spec = quantity_specs::temperature,
                                    .purpose = Purpose::measured});
            }
        }
    }
    InputErrors again = errors;  // the columns are read once more as those of sensors, and what is wrong is said then
    std::vector<std::vector<double>> read = file.file.read(requests, again);
    const Recording recording = read.empty() ? Recording{} : recording_of_inputs(inputs);
    for (std::size_t i = 0; i < read.size() && !file.time.empty(); ++i) {
        if (!run.keys->keeps_suspicious()) {
            remove_dead(file.time, read[i], quantity_specs::temperature.unit,
                        [&](double from, double to) { return is_heated_at_once(recording, from, to); });
        }
        found[i].reading = known_samples(file.time, read[i]);
    }
    return found;
}

}  // namespace tiretherm::input
