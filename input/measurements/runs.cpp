// SPDX-License-Identifier: BSD-3-Clause
// Lays the tables of each run (drive, initial, time, measured) over those of the case, reads the result and adds the
// measured values.

#include "input/measurements/runs.hpp"

#include <algorithm>
#include <array>
#include <deque>

#include <fmt/format.h>

#include "input/cameras/frames.hpp"
#include "input/columns/instruments.hpp"
#include "input/effects/user_effects.hpp"
#include "input/measurements/run_readings.hpp"
#include "input/model/probes.hpp"
#include "input/parameters/hot_spots.hpp"
#include "input/parameters/parameters.hpp"
#include "input/text/suggestions.hpp"

namespace tiretherm::input {

namespace {

constexpr std::array<std::string_view, 4> tables_of_a_run{"drive", "initial", "time", "measured"};

/// A number of the case counts in each run that has none of its own; it was hardly measured in several.
void warn_of_shared_numbers(const TomlValue& document, const std::vector<RunTable>& tables,
                            const Experiment& experiment, InputErrors& errors) {
    const TomlValue* numbers = document.find("measured");
    std::size_t sharing = 0;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const bool own = tables[i].table != nullptr && tables[i].table->find("measured") != nullptr;
        sharing += !own && !experiment.runs[i].numbers.empty() ? 1 : 0;
    }
    if (numbers != nullptr && sharing > 1) {
        errors.warn(numbers->place,
                    fmt::format("the numbers of the case count in each of {} runs: give them to the run "
                                "in which they were measured",
                                sharing));
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

Runs read_runs(const TomlValue& document, const std::string& name, const std::vector<std::filesystem::path>& data,
               ReadMode mode, InputErrors& errors) {
    Runs into;
    std::vector<RunTable> tables;
    {
        TomlTable root(document, "the case", errors);
        root.allow_unknown_keys();  // its keys are reported by the readers below
        tables = read_run_tables(root, name, data);
    }
    const bool measured = !data.empty() || document.find("run") != nullptr;
    const std::vector<std::string> sensors = sensor_names(document);
    const std::vector<std::string> followed = followed_names(document);
    const std::vector<std::string> run_names = measured ? names_of(tables) : std::vector<std::string>{};
    std::deque<TomlValue> documents;  // the builders point into them
    SignalChoice signals;
    for (const RunTable& table : tables) {
        TomlValue& merged = documents.emplace_back(document);
        if (table.table != nullptr) {
            override_tables(merged, *table.table, tables_of_a_run);
        }
        std::optional<RunFile> file = table.file ? open_run_file(table, sensors, followed, errors) : std::nullopt;
        if (!file) {
            table.keys->allow_unknown_keys();
        }
        ProblemBuilder builder;
        builder.problem.name = name;
        if (measured) {
            builder.run = read_run_inputs(table, file ? &*file : nullptr, errors);
        }
        TomlTable root(merged, "the case", errors);
        root.declare_keys({"include", "unset"});
        read_tables(root, builder);
        root.declare_keys({"run", "data", "parameter", "identify", "diagnose", "instrument", "critical", "uncertain"});
        MeasuredRun run;
        run.name = table.name;
        run.file = table.file ? table.file->generic_string() : "";
        if (file) {
            read_series(*file, builder, errors, run);
            read_unused(*file, builder.problem.settings, errors, run);
            Recording recording = recording_of(*file, builder, run);
            recording.keep_suspicious = table.keys->keeps_suspicious();
            std::ranges::move(find_suspicious(recording), std::back_inserter(into.data_warnings));
            leave_out_unusable(recording, run);
        }
        read_numbers(builder, merged, table, errors, run);
        read_frames(table, builder, errors, run, into.data_warnings);
        if (measured && mode == ReadMode::measured) {
            require_readings(run, table, file ? &*file : nullptr, sensors, errors);
        }
        if (documents.size() == 1) {
            read_parameters(root, builder, run_names, into.experiment.parameters);
            read_identify(root, into.experiment);
            static_cast<void>(read_critical(root, builder.problem, builder.has_mesh));
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
        run.problem = std::move(builder.problem);
        into.experiment.runs.push_back(std::move(run));
    }
    for (const RunTable& table : tables) {
        table.keys->report_unknown_columns(errors);
    }
    warn_of_shared_numbers(document, tables, into.experiment, errors);
    if (errors.count() == 0) {
        classify_unused(into.experiment.runs);
        into.experiment.instruments = measured_instruments(into.experiment.instruments, into.experiment.runs);
    }
    choose_signals(signals, into.experiment.runs, errors);
    return into;
}

}  // namespace tiretherm::input
