// SPDX-License-Identifier: BSD-3-Clause
// Lays the tables of each run (drive, initial, time, measured) over those of the case, reads the result and adds the
// measured values.

#include "input/runs/runs.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>

#include <fmt/format.h>

#include "input/cameras/frames.hpp"
#include "input/columns/instruments.hpp"
#include "input/drive/corner.hpp"
#include "input/drive/run_span.hpp"
#include "input/model/probes.hpp"
#include "input/parameters/parameters.hpp"
#include "input/runs/exchanged_sides.hpp"
#include "input/runs/hot_spots.hpp"
#include "input/runs/possible_manoeuvres.hpp"
#include "input/runs/pyrometer.hpp"
#include "input/runs/run_being_read.hpp"
#include "input/runs/run_readings.hpp"
#include "input/text/word_lists.hpp"
#include "input/toml/toml_text.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace {

// A run may differ in how it was driven and what it measured. Its mesh and its effects are those of the case: one number of a
// model belongs to all runs. A corner may have values of effects of its own, as its camber or its brake differ.
constexpr std::array<std::string_view, 5> tables_of_a_run{"drive", "initial", "time", "measured", "vehicle"};
constexpr std::array<std::string_view, 4> tables_of_a_corner{"drive", "initial", "measured", "effects"};

/// The case with what is said of the corner laid over it, then of the run, then of the corner in this run.
TomlValue merged_document(const TomlValue& document, const RunTable& run) {
    TomlValue merged = document;
    if (run.corner_table != nullptr) {
        if (TomlValue* vehicle = merged.find("vehicle")) {
            TomlValue corner = toml_text::text_value(run.corner);
            corner.place = run.corner_table->place;
            vehicle->remove("corner");
            vehicle->set("corner", corner, corner.place);
        }
        override_tables(merged, *run.corner_table, tables_of_a_corner);
    }
    if (run.table != nullptr) {
        override_tables(merged, *run.table, tables_of_a_run);
        if (const TomlValue* own = run.table->find({"corner", run.corner})) {
            override_tables(merged, *own, tables_of_a_run);
        }
    }
    return merged;
}

/// Of each recording, whose corners follow each other.
void warn_of_exchanged_sides(std::span<const MeasuredRun> runs, const TurnsKnown& turns,
                             std::vector<InputWarning>& warnings) {
    for (std::size_t first = 0; first < runs.size();) {
        std::size_t end = first + 1;
        while (end < runs.size() && runs[end].recording == runs[first].recording) {
            ++end;
        }
        std::string sentence = find_exchanged_sides(runs.subspan(first, end - first), turns);
        if (!sentence.empty()) {
            warnings.push_back({.file = runs[first].file, .what = std::move(sentence)});
        }
        first = end;
    }
}

/// The first lap is repeated with the columns of the run's own file.
void warn_of_files_beside_laps(const TomlValue& document, const RunTable& run, InputErrors& errors) {
    const TomlValue* files = document.find({"drive", "file"});
    if (run.repeat_first_lap > 0 && files != nullptr) {
        errors.warn(files->place,
                    "repeat_first_lap repeats the columns of the run's file, and not those of [[drive.file]]: while "
                    "the lap is driven "
                    "before, they are what they were at that time, or at their first");
    }
}

}  // namespace

std::vector<std::string> unique(const std::vector<std::string>& sentences) {
    std::vector<std::string> once;
    for (const std::string& sentence : sentences) {
        if (std::find(once.begin(), once.end(), sentence) == once.end()) {
            once.push_back(sentence);
        }
    }
    return once;
}

const solver::Problem& Runs::problem_of(const std::string& run) const {
    const auto found = std::ranges::find(experiment.runs, run, &MeasuredRun::name);
    return run.empty() || found == experiment.runs.end() ? problem : found->problem;
}

namespace {

/// What the runs of a case have in common.
struct RunsInCommon {
    const TomlValue& document;  ///< of the case, without what runs and corners lay over it
    const std::string& name;    ///< of the case
    std::vector<RunTable> tables;
    bool measured = false;  ///< the case has runs, or files take the place of them
    ReadMode mode = ReadMode::measured;
    std::vector<std::string> sensors;
    std::vector<std::string> followed;

    [[nodiscard]] bool has_car() const { return document.find("vehicle") != nullptr; }
    [[nodiscard]] bool needs_readings() const { return measured && mode == ReadMode::measured; }
};

/// What has been read so far, run by run.
struct RunsRead {
    RunsBeingRead runs{};
    std::vector<CornerColumn> of_one_tire{};
    std::vector<InputWarning> of_data{};
    SignalChoice signals{};
    Runs into{};
};

/// @param before the run that was read before this one; null: none
RunInputs inputs_of(const RunBeingRead& reading, const RunFile* file, bool has_car, const RunBeingRead* before,
                    InputErrors& errors) {
    RunInputs inputs = read_run_inputs(reading.table, file, errors);
    if (file == nullptr) {
        return inputs;
    }
    if (has_car && !file->time.empty()) {
        const bool is_known = before != nullptr && before->inputs && !reading.table.corner.empty() &&
                              before->run.recording == reading.table.recording && before->run.time == file->time;
        // All corners of a car drive the same way.
        inputs.course = is_known ? before->inputs->course : course_over_ground(file->file, file->time, errors);
        if (!is_known) {
            inputs.course.course = file->repeated.before(inputs.course.course);
        }
    }
    inputs.start_readings = start_readings(reading.table, *file, inputs, reading.document, errors);
    return inputs;
}

/// What the file's columns say beside the inputs: sensors, unused columns, laps; and what is suspicious about them.
/// @param beside another corner of the run; null: none
void read_columns(RunFile& file, bool has_car, const MeasuredRun* beside, RunBeingRead& reading, InputErrors& errors,
                  std::vector<InputWarning>& of_data) {
    const solver::Problem& problem = reading.tables.problem;
    MeasuredRun& run = reading.run;
    read_series(file, problem, errors, run);
    warn_of_starts(reading.document, problem, run, errors);
    for (const FollowedColumn& column : has_car ? file.columns.followed : std::vector<FollowedColumn>{}) {
        if (is_used_up_by_vehicle(column.name)) {
            std::erase(file.columns.unused, column.column);
        }
    }
    read_unused(file, problem.settings, beside, errors, run);
    run.repeated = file.repeated;
    const double from = problem.settings.start + run.repeated.lead();
    std::ranges::copy_if(file.laps.laps, std::back_inserter(run.laps),
                         [&](const Lap& lap) { return lap.start < problem.settings.end && lap.end > from; });
    Recording recording = recording_of(file, *reading.inputs, problem, run);
    recording.keep_suspicious = reading.table.keys->keeps_suspicious();
    std::ranges::transform(recording.columns, std::back_inserter(run.columns), with_other_units);
    for (std::string& sentence : find_suspicious(recording)) {
        of_data.push_back({.file = run.file, .corner = run.corner, .what = std::move(sentence)});
    }
    leave_out_unusable(recording, run);
}

/// What is said of the case as a whole, and read with its first run.
SignalChoice read_tables_of_case(TomlTable& root, const CaseTables& read, Runs& into) {
    read_identify(root, into.experiment);
    into.critical = read_critical(root, read.problem);
    static_cast<void>(read_uncertain(root));
    SignalChoice signals = read_diagnose(root, read.problem, into.experiment);
    into.experiment.instruments = read_instruments(root, read.problem);
    into.problem = read.problem;
    into.limits = read.limits;
    for (const Stock& stock : read.stock) {
        if (stock.ply && stock.used) {
            into.plies.push_back(summary_of(*stock.ply, stock.material));
        }
    }
    return signals;
}

void read_free_parameters(const RunsBeingRead& runs, bool measured, InputErrors& errors,
                          std::vector<solver::FreeParameter>& into) {
    std::vector<RunOfParameter> of_parameters;
    for (const auto& one : runs) {
        of_parameters.push_back(
            {.name = one->table.name, .corner = one->table.corner, .problem = &one->tables.problem});
    }
    const RunBeingRead& first = *runs.front();
    TomlTable root(first.document, "the case", errors);
    root.allow_unknown_keys();  // they have been reported
    // Of runs that were measured an initial temperature is another number in each, otherwise one that belongs to all.
    const std::vector<std::string> run_names = measured ? names_of(of_parameters) : std::vector<std::string>{};
    read_parameters(root,
                    {.problem = first.tables.problem,
                     .stock = first.tables.stock,
                     .cameras = first.tables.cameras,
                     .document = root.content(),
                     .run_names = run_names,
                     .errors = errors},
                    of_parameters, into);
}

/// Reads one run. The first one reads what is said of the case as a whole, too.
/// @param car as the run before has found its motion; null: none
void read_run(RunBeingRead& reading, const RunsInCommon& common, std::shared_ptr<const CarMotion> car, RunsRead& read,
              InputErrors& errors) {
    const RunTable& table = reading.table;
    std::optional<RunFile> opened =
        table.file ? open_run_file(table, reading.document, common.sensors, common.followed, errors) : std::nullopt;
    RunFile* const file = opened ? &*opened : nullptr;
    const RunBeingRead* const before = read.runs.size() > 1 ? read.runs[read.runs.size() - 2].get() : nullptr;
    if (file == nullptr) {
        table.keys->allow_unknown_keys();
    }
    warn_of_files_beside_laps(reading.document, table, errors);
    add_pyrometer_readings(reading.document, table, file, common.tables, errors);
    if (common.measured) {
        reading.inputs = inputs_of(reading, file, common.has_car(), before, errors);
    }
    const RunInputs* const inputs = reading.inputs ? &*reading.inputs : nullptr;
    TomlTable root(reading.document, "the case", errors);
    root.declare_keys({"include", "unset", "set"});
    reading.tables = read_tables(root, common.name, inputs, std::move(car));
    MeasuredRun& run = reading.run;
    if (inputs != nullptr) {
        run.not_driven = not_driven(*inputs, reading.tables.span, reading.tables.problem.settings);
    }
    for (const std::string& sentence : run.not_driven) {
        errors.warn(inputs->place, sentence);
    }
    root.declare_keys({"run", "data", "parameter", "identify", "diagnose", "instrument", "critical", "uncertain",
                       "corner", "pyrometer"});
    run.name = table.name;
    run.recording = table.recording;
    run.corner = table.corner;
    run.file = table.file ? table.file->generic_string() : "";
    if (file != nullptr) {
        std::ranges::move(columns_of_one_tire(table, *file), std::back_inserter(read.of_one_tire));
        read_columns(*file, common.has_car(), before != nullptr ? &before->run : nullptr, reading, errors,
                     read.of_data);
    }
    read_numbers(reading.tables.problem, reading.document, table, errors, run);
    read_frames(table, inputs, reading.tables.cameras, reading.tables.problem, errors, run, read.of_data);
    if (common.needs_readings() && table.corner.empty()) {
        require_readings(run, table, file, common.sensors, errors);
    }
    if (&reading == read.runs.front().get()) {
        read.signals = read_tables_of_case(root, reading.tables, read.into);
    }
}

RunsInCommon what_runs_have_in_common(const TomlValue& document, const std::string& name,
                                      const std::vector<std::filesystem::path>& data, ReadMode mode,
                                      InputErrors& errors) {
    TomlTable root(document, "the case", errors);
    root.allow_unknown_keys();  // its keys are reported by the readers of its runs
    std::vector<RunTable> tables = read_run_tables(root, name, data);
    const bool has_runs = tables.front().table != nullptr;  // [[run]] that is no list has none, which is reported
    return {.document = document,
            .name = name,
            .tables = std::move(tables),
            .measured = !data.empty() || has_runs,
            .mode = mode,
            .sensors = sensor_names(document),
            .followed = followed_columns(document)};
}

}  // namespace

Runs read_runs(const TomlValue& document, const std::string& name, const std::vector<std::filesystem::path>& data,
               ReadMode mode, InputErrors& errors) {
    const RunsInCommon common = what_runs_have_in_common(document, name, data, mode, errors);
    RunsRead read;
    RunsBeingRead& runs = read.runs;
    Runs& into = read.into;
    for (const RunTable& table : common.tables) {
        if (!table.corner.empty() && std::ranges::find(into.corners, table.corner) == into.corners.end()) {
            into.corners.push_back(table.corner);
        }
        // The motion of a car is that of all its tires: who finds it first hands it on.
        std::shared_ptr<const CarMotion> car = runs.empty() ? nullptr : runs.back()->tables.car;
        RunBeingRead& reading =
            *runs.emplace_back(new RunBeingRead{.table = table, .document = merged_document(document, table)});
        read_run(reading, common, std::move(car), read, errors);
    }
    // A column may be known to one run's file and not to another's: which keys name none is known behind the last of them.
    for (const auto& one : runs) {
        one->table.keys->report_unknown_columns(errors);
    }
    warn_of_shared_columns(read.of_one_tire, errors);
    warn_of_shared_numbers(document, runs, errors);
    if (common.needs_readings() && errors.count() == 0) {
        leave_out_idle_corners(runs, errors);
    }
    check_same_effects(runs, errors);
    read_free_parameters(runs, common.measured, errors, into.experiment.parameters);
    const TurnsKnown turns{.by_vehicle = common.has_car(), .course_agrees = runs.front()->tables.course_agrees};
    for (const auto& one : runs) {
        one->run.problem = std::move(one->tables.problem);
        into.experiment.runs.push_back(std::move(one->run));
    }
    if (errors.count() == 0) {
        warn_of_exchanged_sides(into.experiment.runs, turns, read.of_data);
        classify_unused(into.experiment.runs);
        into.experiment.instruments = measured_instruments(into.experiment.instruments, into.experiment.runs);
    }
    choose_signals(read.signals, into.experiment.runs, errors);
    into.experiment.possible = read_possible(document, into.experiment.runs, errors);
    into.data_warnings = render(read.of_data, into.corners.size());
    return std::move(into);
}

}  // namespace tiretherm::input
