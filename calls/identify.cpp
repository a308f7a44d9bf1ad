// SPDX-License-Identifier: BSD-3-Clause
// Fits the [[parameter]] values of a case to measured runs, or as a plan predicts the intervals
// before anything is measured.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "calls/calls.hpp"
#include "calls/doing.hpp"
#include "input/runs/reader.hpp"
#include "post/identification/identification_report.hpp"
#include "post/report/file.hpp"
#include "solver/sensitivity/kept_results.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::calls {

namespace {

/// Of a plan's noise, what is new in every sample.
constexpr double white_share = 0.3;

/// What a fit would say.
int plan(const IdentifyOptions& options, input::ExperimentReading& reading, Caller& caller) {
    std::unique_ptr<post::OutputFolder> folder;
    if (!options.directory.empty()) {
        folder = open_output(options.directory, reading.files, post::plan_names(), "nothing was planned", caller);
        if (!folder) {
            return Exit::input_error;
        }
    }
    const input::Experiment experiment = diagnosis::planned(std::move(*reading.experiment));
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    if (observations.rows.empty()) {
        caller.refuse(fmt::format("{}: no sensor says how well it measures", options.case_file),
                      "state standard_deviation with each [[sensor]] that will be there");
        return Exit::input_error;
    }
    const diagnosis::Identification result =
        diagnosis::plan(experiment, observations,
                        diagnosis::stated_noise(experiment, observations, options.correlation_time, white_share));
    if (!result.status.ok()) {
        caller.refuse(result.status.message, "nothing was planned");
        return result.status.outcome == solver::Outcome::stopped ? Exit::interrupted : Exit::numerical_failure;
    }
    const post::IdentificationRecord record{.experiment = experiment,
                                            .observations = observations,
                                            .result = result,
                                            .case_file = options.case_file,
                                            .data = options.data_files(),
                                            .warnings = reading.warnings,
                                            .findings = {},
                                            .planned = true};
    const auto report = [&](const std::vector<std::filesystem::path>& files) {
        post::Report page = post::identification_report(record, files);
        post::ReportSection noise("");
        noise.say(
            fmt::format("Noise assumed: as stated with the sensors; {:.0f} % of its variance is white noise, the rest "
                        "has a correlation time of {:g} s (--correlation-time).",
                        100.0 * (options.correlation_time > 0.0 ? white_share : 1.0), options.correlation_time));
        page.add(std::move(noise));
        return page;
    };
    const auto page = folder == nullptr ? std::optional(report({}))
                                        : write_measured_page(
                                              options, *folder, post::plan_names(), "identify", caller,
                                              [&](const std::filesystem::path& stage) {
                                                  return post::write_identification(record, stage, folder->path());
                                              },
                                              report);
    if (!page) {
        return Exit::input_error;
    }
    caller.take(*page);
    return Exit::done;
}

/// The laps or runs that are left out in turn. @returns nothing after an error
std::optional<std::vector<diagnosis::NamedFold>> what_to_leave_out(const IdentifyOptions& options,
                                                                   const input::Experiment& experiment,
                                                                   const diagnosis::Observations& observations,
                                                                   Caller& caller) {
    using diagnosis::LeaveOut;
    const LeaveOut what = options.leave_out.empty()    ? LeaveOut::nothing
                          : options.leave_out == "lap" ? LeaveOut::lap
                                                       : LeaveOut::run;
    std::vector<diagnosis::NamedFold> folds = diagnosis::named_folds(experiment, observations, what);
    const std::string& file = options.case_file;
    if (what != LeaveOut::nothing && !observations.images.empty()) {
        caller.refuse(fmt::format("{}: a camera's frames cannot be left out", file), "leave out --leave-out");
        return std::nullopt;
    }
    if (what == LeaveOut::lap && folds.size() < 2) {
        caller.refuse(fmt::format("{}: fewer than two laps are known that could be left out", file),
                      "see which laps a log has: tiretherm check LOG; or leave out runs: --leave-out run");
        return std::nullopt;
    }
    if (what == LeaveOut::run && folds.empty()) {
        caller.refuse(fmt::format("{}: the only run cannot be left out", file),
                      "give several [[run]], or leave out laps: --leave-out lap");
        return std::nullopt;
    }
    return folds;
}

}  // namespace

int identify(const IdentifyOptions& options, Caller& caller) {
    if (options.plan && options.profile) {
        caller.refuse("a plan is of first order and has no profiles", "leave out --profile");
        return Exit::input_error;
    }
    if (options.plan && !options.leave_out.empty()) {
        caller.refuse("a plan has no data that could be left out", "leave out --leave-out");
        return Exit::input_error;
    }
    std::optional<input::ExperimentReading> reading = read_measured(
        options, "nothing was fitted", caller, options.plan ? input::ReadMode::planned : input::ReadMode::measured);
    if (!reading || !has_free_parameters(options, *reading->experiment, caller)) {
        return Exit::input_error;
    }
    if (options.plan) {
        return plan(options, *reading, caller);
    }
    const input::Experiment& experiment = *reading->experiment;
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    const std::optional<std::vector<diagnosis::NamedFold>> folds =
        what_to_leave_out(options, experiment, observations, caller);
    if (!folds) {
        return Exit::input_error;
    }
    now_doing("fitting " + options.case_file);
    const auto folder = open_output(folder_of(options, "out/" + experiment.runs.front().problem.name), reading->files,
                                    post::identification_names(), "nothing was fitted", caller);
    if (!folder) {
        return Exit::input_error;
    }
    const auto journal = open_journal(options, *folder, "identify", reading->files, caller);
    const solver::UseOfKeptResults kept(*journal);
    // The data see the discretisation error of the grid, which a finer one shows; two nodes have none.
    std::optional<input::Experiment> finer;
    if (!experiment.runs.front().problem.mesh.is_lumped()) {
        finer = input::read_experiment(options.case_file, options.data_files(), input::ReadMode::measured, {.finer = 2})
                    .experiment;
        if (!finer) {
            reading->warnings.emplace_back(
                "the parameters are not corrected for the error of the grid: the case cannot be read with half the "
                "spacing (see [limits])");
        }
    }
    SimulationCount count(caller);
    const diagnosis::Identification result = diagnosis::identify(experiment, observations,
                                                                 {.profile = options.profile,
                                                                  .finer = finer ? &*finer : nullptr,
                                                                  .leave_out = *folds,
                                                                  .progress = count.shown()});
    count.wipe();
    if (!result.status.ok()) {
        return report_failure(result.status, *folder, *journal, "nothing was fitted", caller);
    }
    const input::Experiment shown = diagnosis::with_fitted_inputs(experiment, result.values);
    post::IdentificationRecord record{.experiment = shown,
                                      .observations = observations,
                                      .result = result,
                                      .case_file = options.case_file,
                                      .data = options.data_files(),
                                      .warnings = reading->warnings,
                                      .findings = wrong_labels(options, experiment)};
    std::ranges::copy(reading->data_warnings, std::back_inserter(record.findings));
    const auto page = write_measured_page(
        options, *folder, post::identification_names(), "identify", caller,
        [&](const std::filesystem::path& stage) {
            auto files = post::write_identification(record, stage, folder->path());
            // A law that fits where the data are may fail elsewhere, and the case with it.
            const input::Reading fitted = input::read_case(folder->home(files.front()), post::read_text(files.front()));
            if (!fitted.problem) {
                record.warnings.push_back("the fitted case cannot be run as it is: " + fitted.errors.front().what);
            }
            return files;
        },
        [&](const auto& files) { return post::identification_report(record, files); });
    tell_of_journal(*journal, caller);
    if (!page) {
        return Exit::input_error;
    }
    caller.take(*page);
    return result.converged ? Exit::done : Exit::numerical_failure;
}

}  // namespace tiretherm::calls
