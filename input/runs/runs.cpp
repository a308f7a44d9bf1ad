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
#include "input/effects/user_effects.hpp"
#include "input/model/probes.hpp"
#include "input/parameters/parameters.hpp"
#include "input/runs/exchanged_sides.hpp"
#include "input/runs/hot_spots.hpp"
#include "input/runs/pyrometer.hpp"
#include "input/runs/run_readings.hpp"
#include "input/text/word_lists.hpp"
#include "input/vehicle/vehicle_log.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array<std::string_view, 5> tables_of_a_run{"drive", "initial", "time", "measured", "vehicle"};
constexpr std::array<std::string_view, 4> tables_of_a_corner{"drive", "initial", "measured", "effects"};

/// A run as it is being read. The builder points into the document.
struct RunBeingRead {
    RunTable table;
    TomlValue document;  ///< of the case, with the tables of the run laid over it
    ProblemBuilder builder{};
    MeasuredRun run{};

    [[nodiscard]] bool has_readings() const {
        return !run.series.empty() || !run.numbers.empty() || !run.frames.empty();
    }
};
using RunsBeingRead = std::vector<std::unique_ptr<RunBeingRead>>;

/// The car of the case, with the wheel that the run is of.
TomlValue at_corner(TomlValue vehicle, const RunTable& run) {
    std::erase_if(vehicle.entries, [](const Entry& entry) { return entry.key == "corner"; });
    TomlValue corner;
    corner.kind = TomlValue::Kind::text;
    corner.text = run.corner;
    corner.place = run.corner_table->place;
    vehicle.entries.push_back({.key = "corner", .place = corner.place, .value = std::move(corner)});
    return vehicle;
}

/// The case with what is said of the corner laid over it, then of the run, then of the corner in this run.
TomlValue merged_document(const TomlValue& document, const RunTable& run) {
    TomlValue merged = document;
    const auto vehicle = std::ranges::find(merged.entries, "vehicle", &Entry::key);
    if (run.corner_table != nullptr && vehicle != merged.entries.end()) {
        vehicle->value = at_corner(std::move(vehicle->value), run);
    }
    if (run.corner_table != nullptr) {
        override_tables(merged, *run.corner_table, tables_of_a_corner);
    }
    if (run.table != nullptr) {
        override_tables(merged, *run.table, tables_of_a_run);
        const TomlValue* corners = run.table->find("corner");
        if (const TomlValue* own = corners != nullptr ? corners->find(run.corner) : nullptr) {
            override_tables(merged, *own, tables_of_a_run);
        }
    }
    return merged;
}

/// A number of the case counts in each run that has none of its own; it was hardly measured in several.
void warn_of_shared_numbers(const TomlValue& document, const RunsBeingRead& runs, InputErrors& errors) {
    const TomlValue* numbers = document.find("measured");
    const auto sharing = std::ranges::count_if(runs, [](const std::unique_ptr<RunBeingRead>& one) {
        const bool own = one->table.table != nullptr && one->table.table->find("measured") != nullptr;
        return !own && !one->run.numbers.empty();
    });
    if (numbers != nullptr && sharing > 1) {
        errors.warn(numbers->place,
                    fmt::format("the numbers of the case count in each of {} runs: give them to the run "
                                "in which they were measured",
                                sharing));
    }
}

/// Corners of which a run measured nothing take no part in it; where none measured anything, it is an error.
void leave_out_idle_corners(RunsBeingRead& runs, InputErrors& errors) {
    std::vector<std::string> recordings;
    for (const auto& one : runs) {
        if (!one->table.corner.empty() &&
            (recordings.empty() ||
             recordings.back() != one->table.recording)) {  // the corners of a run follow each other
            recordings.push_back(one->table.recording);
        }
    }
    for (const std::string& recording : recordings) {
        std::vector<std::string> idle;
        const RunBeingRead* measuring = nullptr;
        const RunBeingRead* last = nullptr;
        for (const auto& one : runs) {
            if (one->table.recording == recording) {
                last = one.get();
                measuring = one->has_readings() ? one.get() : measuring;
                if (!one->has_readings()) {
                    idle.push_back(one->table.corner);
                }
            }
        }
        if (measuring == nullptr) {
            errors.add(last->table.place, fmt::format("no corner of the run {} measures anything", recording),
                       "map columns to sensors in [[corner]]: columns = { COLUMN = \"SENSOR\" }");
        } else if (!idle.empty()) {
            errors.warn(last->table.place,
                        fmt::format("the run {} measures nothing at {}: left out", recording, listed(idle)));
            std::erase_if(runs, [&](const std::unique_ptr<RunBeingRead>& one) {
                return one->table.recording == recording && !one->has_readings();
            });
        }
    }
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

/// Corners may differ in the values of effects, not in which effects there are: a parameter has one place for all.
void check_same_effects(const RunsBeingRead& runs, InputErrors& errors) {
    const auto titles = [](const RunBeingRead& one) {
        std::vector<std::string> names;
        for (const physics::ActiveEffect& active : one.builder.problem.effects) {
            names.emplace_back(active.title());
        }
        return names;
    };
    for (const auto& one : runs) {
        const TomlValue* effects =
            one->table.corner_table != nullptr ? one->table.corner_table->find("effects") : nullptr;
        if (effects != nullptr && titles(*one) != titles(*runs.front())) {
            errors.add(
                effects->place,
                fmt::format("the corner {} has other effects than {}", one->table.corner, runs.front()->table.corner),
                "switch effects on and off in [effects] of the case; a corner gives their values");
        }
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

/// The first lap is repeated with the columns of the run's own file.
void warn_of_files_beside_laps(const TomlValue& document, const RunTable& run, InputErrors& errors) {
    const TomlValue* drive = document.find("drive");
    const TomlValue* files = drive != nullptr ? drive->find("file") : nullptr;
    if (run.repeat_first_lap > 0 && files != nullptr) {
        errors.warn(files->place,
                    "repeat_first_lap repeats the columns of the run's file, and not those of [[drive.file]]: while "
                    "the lap is driven "
                    "before, they are what they were at that time, or at their first");
    }
}

}  // namespace

Runs read_runs(const TomlValue& document, const std::string& name, const std::vector<std::filesystem::path>& data,
               ReadMode mode, InputErrors& errors) {
    Runs into;
    std::vector<RunTable> tables;
    {
        TomlTable root(document, "the case", errors);
        root.allow_unknown_keys();  // its keys are reported by the readers below
        tables = read_run_tables(root, name, data);
    }
    const bool has_runs = tables.front().table != nullptr;  // [[run]] that is no list has none, which is reported
    const bool measured = !data.empty() || has_runs;
    const std::vector<std::string> sensors = sensor_names(document);
    std::vector<std::string> followed = followed_names(document);
    add_vehicle_columns(document, followed);
    RunsBeingRead runs;
    std::vector<CornerColumn> of_one_tire;
    std::vector<InputWarning> of_data;
    SignalChoice signals;
    for (const RunTable& each : tables) {
        if (!each.corner.empty() && std::ranges::find(into.corners, each.corner) == into.corners.end()) {
            into.corners.push_back(each.corner);
        }
        RunBeingRead& reading =
            *runs.emplace_back(new RunBeingRead{.table = each, .document = merged_document(document, each)});
        const RunTable& table = reading.table;
        ProblemBuilder& builder = reading.builder;
        MeasuredRun& run = reading.run;
        builder.car = runs.size() > 1 ? runs[runs.size() - 2]->builder.car : nullptr;
        std::optional<RunFile> file =
            table.file ? open_run_file(table, reading.document, sensors, followed, errors) : std::nullopt;
        if (!file) {
            table.keys->allow_unknown_keys();
        }
        builder.problem.name = name;
        warn_of_files_beside_laps(reading.document, table, errors);
        add_pyrometer_readings(reading.document, table, file ? &*file : nullptr, tables, errors);
        if (measured) {
            builder.run = read_run_inputs(table, file ? &*file : nullptr, errors);
            if (file) {
                if (document.find("vehicle") != nullptr && !file->time.empty()) {
                    builder.run->course = course_over_ground(file->file, file->time, errors);
                    builder.run->course.course = file->repeated.before(builder.run->course.course);
                }
                builder.run->start_readings = start_readings(table, *file, *builder.run, reading.document, errors);
            }
        }
        TomlTable root(reading.document, "the case", errors);
        root.declare_keys({"include", "unset"});
        read_tables(root, builder);
        run.not_driven = not_driven(builder);
        for (const std::string& sentence : run.not_driven) {
            errors.warn(builder.run->place, sentence);
        }
        root.declare_keys({"run", "data", "parameter", "identify", "diagnose", "instrument", "critical", "uncertain",
                           "corner", "pyrometer"});
        run.name = table.name;
        run.recording = table.recording;
        run.corner = table.corner;
        run.file = table.file ? table.file->generic_string() : "";
        if (file) {
            std::ranges::move(columns_of_one_tire(table, *file), std::back_inserter(of_one_tire));
            read_series(*file, builder, errors, run);
            warn_of_starts(reading.document, builder.problem, run, errors);
            if (document.find("vehicle") != nullptr) {
                for (const FollowedColumn& column : file->columns.followed) {
                    std::erase_if(file->columns.unused, [&](int unused) {
                        return unused == column.column && is_used_up_by_vehicle(column.name);
                    });
                }
            }
            read_unused(*file, builder.problem.settings, errors, run);
            run.repeated = file->repeated;
            const double from = builder.problem.settings.start + run.repeated.lead();
            std::ranges::copy_if(file->laps.laps, std::back_inserter(run.laps), [&](const Lap& lap) {
                return lap.start < builder.problem.settings.end && lap.end > from;
            });
            Recording recording = recording_of(*file, builder, run);
            recording.keep_suspicious = table.keys->keeps_suspicious();
            for (std::string& sentence : find_suspicious(recording)) {
                of_data.push_back({.file = run.file, .corner = run.corner, .what = std::move(sentence)});
            }
            leave_out_unusable(recording, run);
        }
        read_numbers(builder, reading.document, table, errors, run);
        read_frames(table, builder, errors, run, of_data);
        if (measured && mode == ReadMode::measured && table.corner.empty()) {
            require_readings(run, table, file ? &*file : nullptr, sensors, errors);
        }
        if (runs.size() == 1) {
            read_identify(root, into.experiment);
            into.critical = read_critical(root, builder.problem, builder.has_mesh);
            static_cast<void>(read_uncertain(root));
            signals = read_diagnose(root, builder.problem, into.experiment);
            into.experiment.instruments = read_instruments(root, builder.problem);
            into.problem = builder.problem;
            into.limits = builder.limits;
            for (const Stock& stock : builder.stock) {
                if (stock.ply && stock.used) {
                    into.plies.push_back(summary_of(*stock.ply, stock.material));
                }
            }
        }
    }
    for (const auto& one : runs) {
        one->table.keys->report_unknown_columns(errors);
    }
    warn_of_shared_columns(of_one_tire, errors);
    warn_of_shared_numbers(document, runs, errors);
    if (measured && mode == ReadMode::measured && errors.count() == 0) {
        leave_out_idle_corners(runs, errors);
    }
    check_same_effects(runs, errors);
    {
        std::vector<RunOfParameter> of_parameters;
        for (const auto& one : runs) {
            of_parameters.push_back(
                {.name = one->table.name, .corner = one->table.corner, .problem = &one->builder.problem});
        }
        TomlTable root(runs.front()->document, "the case", errors);
        root.allow_unknown_keys();  // they have been reported
        read_parameters(root, runs.front()->builder, measured, of_parameters, into.experiment.parameters);
    }
    const TurnsKnown turns{.by_vehicle = document.find("vehicle") != nullptr,
                           .course_agrees = runs.front()->builder.course_agrees};
    for (const auto& one : runs) {
        one->run.problem = std::move(one->builder.problem);
        into.experiment.runs.push_back(std::move(one->run));
    }
    if (errors.count() == 0) {
        warn_of_exchanged_sides(into.experiment.runs, turns, of_data);
        classify_unused(into.experiment.runs);
        into.experiment.instruments = measured_instruments(into.experiment.instruments, into.experiment.runs);
    }
    choose_signals(signals, into.experiment.runs, errors);
    into.data_warnings = render(of_data, into.corners.size());
    return into;
}

}  // namespace tiretherm::input
