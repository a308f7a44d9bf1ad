// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm diagnose`: fits a case to measured runs and reports which effects of the catalogue explain the remaining
// differences.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/measured_call.hpp"
#include "app/messages.hpp"
#include "diagnosis/compare/camera_rings.hpp"
#include "post/diagnosis/diagnosis_report.hpp"
#include "solver/sensitivity/kept_results.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

int diagnose(const MeasuredCall& call) {
    solver::install_stop_handlers();
    const std::optional<input::ExperimentReading> reading = read_measured(call, "nothing was diagnosed");
    if (!reading || !has_free_parameters(call, *reading->experiment)) {
        return Exit::input_error;
    }
    const std::filesystem::path directory = folder_of(call, "out/" + reading->experiment->runs.front().problem.name);
    const std::vector<std::string> names = post::diagnosis_names();
    now_doing(fmt::format("diagnosing {} and writing to {}", call.case_file, directory.string()));
    const auto folder = open_output(directory, reading->files, names, "nothing was diagnosed", call.json);
    if (!folder) {
        return Exit::input_error;
    }
    const auto journal = open_journal(call, *folder, "diagnose", reading->files);
    const solver::UseOfKeptResults kept(*journal);
    std::vector<std::string> remarks;
    const input::Experiment experiment = diagnosis::in_rings(*reading->experiment, remarks);
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    // A grid has an error of its own, which a finer one shows; lumps are what they are.
    std::optional<input::Experiment> finer;
    if (!experiment.runs.front().problem.mesh.is_lumped()) {
        finer = input::read_experiment(call.case_file, call.data_files(), input::ReadMode::measured, 2).experiment;
        if (finer) {
            std::vector<std::string> same;
            finer = diagnosis::in_rings(std::move(*finer), same);
        }
    }
    SimulationCount count(call.json);
    const diagnosis::Diagnosis result =
        diagnosis::diagnose(experiment, observations, {.finer = finer ? &*finer : nullptr, .progress = count.shown()});
    count.wipe();
    if (!result.status.ok()) {
        return report_failure(call, result.status, *folder, *journal, "nothing was diagnosed");
    }
    post::DiagnosisRecord record{.experiment = experiment,
                                 .observations = observations,
                                 .result = result,
                                 .case_file = call.case_file,
                                 .data = call.data_files(),
                                 .warnings = remarks,
                                 .findings = reading->data_warnings};
    std::ranges::copy(reading->warnings, std::back_inserter(record.warnings));
    const auto files = write_measured(call, *folder, names, [&](const std::filesystem::path& stage) {
        return post::write_diagnosis(record, stage, folder->path());
    });
    if (!files) {
        return Exit::input_error;
    }
    print_report(post::diagnosis_report(record, *files), call.json);
    return Exit::done;
}

}  // namespace

void add_diagnose_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand(
        "diagnose", "What a model gets wrong in measured runs, its cause, and what mending gains");
    const auto call = std::make_shared<MeasuredCall>();
    add_measured_options(*command, *call, "[[run]] and [[parameter]]",
                         "files of an earlier diagnosis there are replaced. Default: out/<case name>");
    add_fresh_option(*command, call->fresh);
    command->footer(
        "The free numbers of the case are fitted; what is left is compared with every effect of the catalogue that is\n"
        "not in the model (or those of [diagnose] candidates), alone and in pairs, and with heat that no effect is.\n"
        "The answer is a set: one cause is named, several that the data cannot tell apart are all listed.\n"
        "A camera is taken as the means of three rings about the spot.\n"
        "Differences are simulated - measured.\n"
        "Files: diagnosis.json, extended.toml (the case with the cause switched on, where there is one),\n"
        "residuals.csv (a row for each sample), residuals.png, missing_heat.csv and .png (heat that windows of the "
        "runs lack).\n\n"
        "The files appear together at the end. A diagnosis that was interrupted or killed goes on when the same call "
        "is\n"
        "made again: its simulations are kept in the hidden folder .tiretherm until then.\n\n"
        "Exit code: 0 done, whatever the answer; 1 an error in the call, the case or the data; 2 the solver failed;\n"
        "130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm diagnose cases/practice/two_node_bench.toml --data run1.csv --data run2.csv --out /tmp/bench");
    command->callback([call, &exit_code] { exit_code = diagnose(*call); });
}

}  // namespace tiretherm::app
