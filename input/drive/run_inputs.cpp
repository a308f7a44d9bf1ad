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
    if (file.laps.nearest && !run.laps) {
        const SourceLocation of_file{.file = file.file.number()};
        errors.warn(run.start_line ? run.start_line_place : of_file, "{}: {}", never_crossed(*file.laps.nearest),
                    line_remedy);
    }
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

bool read_times(RunFile& file, InputErrors& errors) {
    file.file.choose_rows(file.columns.chosen());
    if (file.columns.time < 0) {
        errors.add(file.file.heads().front().place, "the file has no column time [s]",
                   "rename one: columns = { t = \"time\" }");
        return false;
    }
    std::vector<std::vector<double>> read =
        file.file.read({file.file.request(file.columns.time, "time", quantity_specs::moment, Purpose::clock)}, errors);
    if (read.empty()) {
        return false;
    }
    file.time = std::move(read.front());
    return true;
}

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
    if (read_times(opened, errors) && !find_samples(run, opened, errors)) {
        opened.time.clear();
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

}  // namespace

DrivingColumns read_driving(const RunFile& file, ColumnKeys& keys, bool can_split, InputErrors& errors) {
    DrivingColumns found;
    std::vector<ColumnRequest> requests;
    const auto head_of = [&](int column) { return file.file.heads()[static_cast<std::size_t>(column)]; };
    for (const UsedColumn& column : file.columns.used) {
        if (column.input != nullptr) {
            requests.push_back(file.file.request(column.column, column.name, quantity_specs::of(*column.input)));
            found.inputs.push_back(
                {.signal = column.input, .place = head_of(column.column).place, .time = {}, .value = {}});
        }
    }
    found.followed.reserve(file.columns.followed.size());  // requests look into it
    for (const FollowedColumn& column : file.columns.followed) {
        // Its own unit says what its numbers are.
        const std::string unit = base_unit(head_of(column.column).heading.unit);
        found.followed.push_back({.name = column.name, .unit = unit, .signal = {}});
        requests.push_back(file.file.request(column.column, column.name, {.unit = found.followed.back().unit}));
    }
    std::vector<std::vector<double>> read = file.file.read(requests, errors);
    const solver::SharedSamples time = cut(file.time, file);
    for (std::size_t i = 0; i < read.size() && !file.time.empty(); ++i) {
        const ColumnRequest& column = requests[i];
        const SourceLocation place = head_of(column.column).place;
        const bool is_input = i < found.inputs.size();
        const std::string dead =
            keys.keeps_suspicious() ? std::string() : remove_dead(file.time, read[i], column.spec.unit);
        if (!dead.empty()) {
            errors.warn(place, "{} {}: left out", column.name, dead);
        }
        const auto samples = driving_samples(
            {.name = column.name,
             .time = time,
             .value = cut(std::move(read[i]), file),
             .holds = keys.holds(column.name),
             .before = file.repeated},
            {.place = place,
             .elsewhere = is_input ? fmt::format("ignore the column and give {} in [drive]", column.name)
                                   : "let the effect follow another signal",
             .can_split = can_split},
            errors);
        if (samples && is_input) {
            found.inputs[i].time = samples->time;
            found.inputs[i].value = samples->value;
        } else if (samples) {
            UserColumn& own = found.followed[i - found.inputs.size()];
            own.signal = {.time = samples->time, .value = samples->value};
            own.beside = live_column_beside(file.file, column.column, own, file.time, errors);
        }
    }
    return found;
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
    DrivingColumns driving = read_driving(*file, *run.keys, true, errors);
    into.inputs = std::move(driving.inputs);
    into.columns = std::move(driving.followed);
    if (file->time.empty()) {
        return into;
    }
    into.lead = file->repeated.lead();
    into.left_out = file->left_out;
    into.file_first = file->time.front();
    into.part_of_file = run.from || run.laps;
    into.first = file->time[file->first] - into.lead;
    into.last = file->time[file->last - 1];
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
