// SPDX-License-Identifier: BSD-3-Clause
// Fits a case to measured runs and reports which effects of the catalogue explain the remaining
// differences.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "calls/calls.hpp"
#include "calls/doing.hpp"
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

namespace tiretherm::calls {

namespace {

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

}  // namespace

int diagnose(DiagnoseOptions call, const TableOptions& of_table, Caller& caller) {
    if (call.time_limit > 0.0) {
        solver::stop_after(call.time_limit);
    }
    if (input::is_validation_table(call.case_file)) {
        return diagnose_table(call, of_table, caller);
    }
    std::optional<input::ExperimentReading> reading = read_measured(call, "nothing was diagnosed", caller);
    if (!reading || !has_free_parameters(call, *reading->experiment, caller)) {
        return Exit::input_error;
    }
    const std::filesystem::path directory = folder_of(call, "out/" + reading->experiment->runs.front().problem.name);
    const std::vector<std::string> names = post::diagnosis_names();
    now_doing(fmt::format("diagnosing {} and writing to {}", call.case_file, directory.string()));
    const auto folder = open_output(directory, reading->files, names, "nothing was diagnosed", caller);
    if (!folder) {
        return Exit::input_error;
    }
    const auto journal = open_journal(call, *folder, "diagnose", reading->files, caller);
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
    SimulationCount count(caller);
    options.progress = count.stages();
    diagnosis::Diagnosis result = diagnosis::diagnose(experiment, observations, options);
    diagnosis::take_data_faults(std::move(faults), experiment, result);
    count.wipe();
    if (!result.status.ok()) {
        return report_failure(result.status, *folder, *journal, "nothing was diagnosed", caller);
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
    if (!caller.is_quiet() && !call.no_by_run && experiment.runs.size() > 1 && result.seconds > long_wait &&
        !solver::stop_requested()) {
        caller.note("all runs together: " + post::reason_of(record));
    }
    record.by_run = diagnosed_by_run(call, experiment, result, options);
    count.wipe();
    const auto files = write_measured(*folder, names, caller, [&](const std::filesystem::path& stage) {
        return post::write_diagnosis(record, stage, folder->path());
    });
    tell_of_journal(*journal, caller);
    if (!files) {
        return Exit::input_error;
    }
    caller.take(post::diagnosis_report(record, *files));
    const bool complete = result.stopped == diagnosis::Part::none && !record.by_run.are_cut_short();
    if (const std::string rest = complete ? "" : kept_for_next_call(*folder, *journal); !rest.empty()) {
        caller.note(rest);
    }
    return complete || solver::is_time_up() ? Exit::done : Exit::interrupted;
}

}  // namespace tiretherm::calls
