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
#include "app/commands/diagnose_table.hpp"
#include "app/failure.hpp"
#include "app/measured_call.hpp"
#include "app/messages.hpp"
#include "diagnosis/by_run/run_verdicts.hpp"
#include "diagnosis/compare/camera_rings.hpp"
#include "diagnosis/fit/fit.hpp"
#include "diagnosis/observations/thinning.hpp"
#include "input/validation/validation.hpp"
#include "post/diagnosis/diagnosis_report.hpp"
#include "post/diagnosis/diagnosis_sentences.hpp"
#include "post/report/remark_text.hpp"
#include "solver/sensitivity/kept_results.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

struct DiagnoseOptions : MeasuredCall {
    double time_limit = 0.0;  ///< s; 0: none
    bool by_run = false;      ///< each run alone, too, however long that takes
    bool no_by_run = false;   ///< neither: where that is quick
};

/// From which on whoever waits is told the answer before each run is diagnosed alone.
constexpr double long_wait = 10.0;  // s

/// Each run alone, where there are several and nobody has asked for an end; or why not.
diagnosis::RunVerdicts diagnosed_by_run(const DiagnoseOptions& call, const input::Experiment& experiment,
                                        const diagnosis::Diagnosis& all, const diagnosis::DiagnosisOptions& options) {
    if (experiment.runs.size() < 2 || call.no_by_run) {
        return {};
    }
    if (all.stopped != diagnosis::Part::none || solver::stop_requested()) {
        return {.runs = {}, .left_out = diagnosis::LeftOutRuns::stopped_before};
    }
    if (!call.by_run && all.seconds > diagnosis::longest_before_by_run) {
        return {.runs = {}, .left_out = diagnosis::LeftOutRuns::takes_long};
    }
    return diagnosis::diagnose_by_run(experiment, options);
}

/// The same runs on a richer mesh, where the program can make one of the case's.
std::optional<input::Experiment> on_layers(const MeasuredCall& call, const input::Experiment& experiment,
                                           double thickness) {
    input::ExperimentReading reading = read_corrected(call, {.layers = thickness});
    const auto& problem = experiment.runs.front().problem;
    if (!reading.experiment || reading.experiment->parameters.size() != experiment.parameters.size() ||
        reading.experiment->runs.front().problem.channels.size() != problem.channels.size()) {
        return std::nullopt;
    }
    return diagnosis::with_free_conductivity(diagnosis::with_fine_steps(std::move(*reading.experiment)));
}

/// The case on other meshes, on which a diagnosis sees what its own cannot tell.
class OtherMeshes {
public:
    OtherMeshes(const DiagnoseOptions& call, const diagnosis::Thinned& thinned) {
        const input::Experiment& experiment = thinned.experiment;
        const solver::Problem& problem = experiment.runs.front().problem;
        // A grid has an error of its own, which a finer one shows; lumps are what they are.
        if (!problem.mesh.is_lumped()) {
            finer_ = refined(call, thinned, 2);
        }
        if (finer_ && problem.mesh.n_nodes <= few_nodes) {
            much_finer_ = refined(call, thinned, times);
        }
        if (much_finer_) {
            much_finer_ = diagnosis::with_fine_steps(std::move(*much_finer_));
        }
        thickness_ = input::thickness_as_layers(problem);
        if (thickness_ && (layers_ = on_layers(call, experiment, *thickness_))) {
            take_values(thinned, *layers_);
        }
    }

    /// @returns options that point into this
    [[nodiscard]] diagnosis::DiagnosisOptions options() const {
        diagnosis::DiagnosisOptions options{.finer = finer_ ? &*finer_ : nullptr};
        if (much_finer_) {
            options.much_finer.push_back({.name = fmt::format("{} times as many cells", times),
                                          .experiment = &*much_finer_,
                                          .change = {.finer = times}});
        }
        if (layers_) {
            options.richer.push_back({.name = "layers", .experiment = &*layers_, .change = {.layers = *thickness_}});
        }
        return options;
    }

private:
    static constexpr int times = 4;
    static constexpr int few_nodes = 60;  // four times as many cells of such a mesh are still quick

    static std::optional<input::Experiment> refined(const DiagnoseOptions& call, const diagnosis::Thinned& thinned,
                                                    int finer) {
        std::optional<input::Experiment> read = read_corrected(call, {.finer = finer}).experiment;
        if (read) {
            diagnosis::Remarks same;  // remarks that the case's own mesh has already
            read = diagnosis::in_rings(std::move(*read), same);
            take_values(thinned, *read);
        }
        return read;
    }

    std::optional<input::Experiment> finer_;
    std::optional<input::Experiment> much_finer_;
    std::optional<input::Experiment> layers_;
    std::optional<double> thickness_;  ///< m, of the layers
};

int diagnose(DiagnoseOptions call, const TableOptions& of_table) {
    solver::install_stop_handlers();
    if (call.time_limit > 0.0) {
        solver::stop_after(call.time_limit);
    }
    if (input::is_validation_table(call.case_file)) {
        return diagnose_table(call, of_table);
    }
    std::optional<input::ExperimentReading> reading = read_measured(call, "nothing was diagnosed");
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
    if (call.time_limit > 0.0) {
        journal->keep_at_once();
    }
    const solver::UseOfKeptResults kept(*journal);
    diagnosis::Remarks remarks;
    const auto as_taken = [&] {
        remarks.clear();
        return diagnosis::thinned(diagnosis::in_rings(*reading->experiment, remarks));
    };
    diagnosis::Thinned thinned = as_taken();
    diagnosis::DataFaults faults = correct_data(call, *reading, thinned.experiment);
    if (!faults.found.empty()) {
        thinned = as_taken();
    }
    const input::Experiment& experiment = thinned.experiment;
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    const OtherMeshes meshes(call, thinned);
    diagnosis::DiagnosisOptions options = meshes.options();
    SimulationCount count(call.quiet);
    options.progress = count.stages();
    diagnosis::Diagnosis result = diagnosis::diagnose(experiment, observations, options);
    diagnosis::take_data_faults(std::move(faults), experiment, result);
    count.wipe();
    if (!result.status.ok()) {
        return report_failure(call, result.status, *folder, *journal, "nothing was diagnosed");
    }
    const input::Experiment shown = diagnosis::with_fitted_inputs(experiment, result.values);
    post::DiagnosisRecord record{.experiment = shown,
                                 .observations = observations,
                                 .result = result,
                                 .case_file = call.case_file,
                                 .data = call.data_files(),
                                 .warnings = post::texts_of(remarks),
                                 .findings = reading->data_warnings,
                                 .by_run = {},
                                 .with_page = !call.no_report,
                                 .inputs = reading->files};
    std::ranges::copy(reading->warnings, std::back_inserter(record.warnings));
    std::ranges::copy(post::texts_of(thinned.remarks), std::back_inserter(record.findings));
    if (!call.quiet && !call.no_by_run && experiment.runs.size() > 1 && result.seconds > long_wait &&
        !solver::stop_requested()) {
        fmt::print(stderr, "tiretherm: all runs together: {}\n", post::reason_of(record));
    }
    record.by_run = diagnosed_by_run(call, experiment, result, options);
    count.wipe();
    const auto files = write_measured(call, *folder, names, [&](const std::filesystem::path& stage) {
        return post::write_diagnosis(record, stage, folder->path());
    });
    tell_of_journal(*journal);
    if (!files) {
        return Exit::input_error;
    }
    print_page(call, post::diagnosis_report(record, *files));
    const bool complete = result.stopped == diagnosis::Part::none && !record.by_run.are_cut_short();
    if (const std::string rest = complete ? "" : kept_for_next_call(*folder, *journal); !rest.empty()) {
        std::fflush(stdout);
        fmt::print(stderr, "tiretherm: {}\n", rest);
    }
    return complete || solver::is_time_up() ? Exit::done : Exit::interrupted;
}

}  // namespace

void add_diagnose_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand(
        "diagnose", "Find which effect a model lacks in measured runs, and what adding it gains");
    const auto call = std::make_shared<DiagnoseOptions>();
    add_measured_options(*command, *call, "[[run]] and [[parameter]]",
                         "files of an earlier diagnosis there are replaced. Default: out/<case name>");
    add_fresh_option(*command, call->fresh);
    add_seconds_option(*command, "--time-limit", call->time_limit,
                       "Of wall time after which the best answer so far is given; Ctrl-C does the same. The same call, "
                       "as often as it is made, goes on from there");
    CLI::Option* by_run = command->add_flag(
        "--by-run", call->by_run,
        "Each of several runs alone as well, however long that takes. Default: where all together took up to 60 s");
    command->add_flag("--no-by-run", call->no_by_run, "No run alone")->excludes(by_run);
    const auto of_table = std::make_shared<TableOptions>();
    command->add_option("--model", of_table->model, "Of a table: the model that is diagnosed. Default: its first one")
        ->option_text("KEY");
    command
        ->add_option("--threads", of_table->threads,
                     "Of a table: runs at a time. Default: as many as the machine can do")
        ->option_text("N")
        ->check(CLI::Range(1, 1024));
    command->add_flag("--markdown", of_table->markdown, "Of a table: the page for a README")->excludes("--json");
    command->footer(
        "The free parameters of the case are fitted; what is left is compared with every effect of the catalogue that "
        "is\n"
        "not in the model (or those of [diagnose] candidates), alone and in pairs, and with heat that no effect is.\n"
        "The answer is a set: one cause is named, several that the data cannot tell apart are all listed.\n"
        "A camera is taken as the means of three rings about the spot.\n"
        "Dense logs are thinned to some 1500 values a sensor and run, by means over blocks; the page says how far.\n"
        "Each of several runs is diagnosed alone, too: what only one shows is a fault of that run.\n"
        "Columns that the model does not use may be causes where they drive the tire, or as [diagnose] signals and "
        "ignore say.\n"
        "CASE may also be a table of measured numbers over many experiments, as `validate` reads it. Then additions "
        "to\n"
        "one model (effects, parameters, another mesh, unprinted inputs, instruments) are judged by experiments that "
        "took\n"
        "no part in fitting them. Its files are report.html, page.txt and diagnosis.json.\n"
        "Differences are simulated - measured.\n"
        "Files: report.html (this page with charts, for a browser), page.txt (this page), diagnosis.json, "
        "extended.toml (the\n"
        "case with the cause switched on, where there is one), residuals.csv (a row for each sample), missing_heat.csv "
        "(heat\n"
        "that windows of the runs lack), laps.csv (of laps and of a car's tires). Charts as pictures: tiretherm report "
        "DIR --png\n\n"
        "The files appear together at the end, also after Ctrl-C or --time-limit: they then hold the best answer so "
        "far.\n"
        "A diagnosis that was killed, interrupted or cut short by --time-limit goes on when the same call is made "
        "again:\n"
        "its simulations are kept in the hidden folder .tiretherm until then.\n\n"
        "Exit code: 0 done, whatever the answer, also the best one within --time-limit; 1 an error in the call, the "
        "case\n"
        "or the data; 2 the solver failed, or --time-limit passed before there was an answer; 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm diagnose cases/practice/two_node_bench.toml \\\n"
        "      --data cases/practice/puzzle1.csv --out out/puzzle");
    command->callback([call, of_table, &exit_code] { exit_code = diagnose(*call, *of_table); });
}

}  // namespace tiretherm::app
