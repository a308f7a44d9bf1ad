// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm identify`: fits the [[parameter]] values of a case to measured runs, or with --plan predicts the intervals
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
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/failure.hpp"
#include "app/measured_call.hpp"
#include "app/messages.hpp"
#include "input/runs/reader.hpp"
#include "post/identification/identification_report.hpp"
#include "post/report/file.hpp"
#include "solver/sensitivity/kept_results.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

struct IdentifyOptions : MeasuredCall {
    double correlation_time = 10.0;  ///< s, of a plan's noise
    bool profile = false;
    bool plan = false;
    std::string leave_out;  ///< "lap" or "run"
};

/// Of a plan's noise, what is new in every sample.
constexpr double white_share = 0.3;

/// What a fit would say.
int plan(const IdentifyOptions& options, input::ExperimentReading& reading) {
    std::unique_ptr<post::OutputFolder> folder;
    if (!options.directory.empty()) {
        folder = open_output(options.directory, reading.files, post::plan_names(), "nothing was planned", options.json);
        if (!folder) {
            return Exit::input_error;
        }
    }
    const input::Experiment experiment = diagnosis::planned(std::move(*reading.experiment));
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    if (observations.rows.empty()) {
        report_error(fmt::format("{}: no sensor says how well it measures", options.case_file),
                     "state standard_deviation with each [[sensor]] that will be there", options.json);
        return Exit::input_error;
    }
    const diagnosis::Identification result =
        diagnosis::plan(experiment, observations,
                        diagnosis::stated_noise(experiment, observations, options.correlation_time, white_share));
    if (!result.status.ok()) {
        report_error(result.status.message, "nothing was planned", options.json);
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
                                              options, *folder, post::plan_names(), "identify",
                                              [&](const std::filesystem::path& stage) {
                                                  return post::write_identification(record, stage, folder->path());
                                              },
                                              report);
    if (!page) {
        return Exit::input_error;
    }
    print_page(options, *page);
    return Exit::done;
}

/// The laps or runs that are left out in turn. @returns nothing after an error
std::optional<std::vector<diagnosis::NamedFold>> what_to_leave_out(const IdentifyOptions& options,
                                                                   const input::Experiment& experiment,
                                                                   const diagnosis::Observations& observations) {
    using diagnosis::LeaveOut;
    const LeaveOut what = options.leave_out.empty()    ? LeaveOut::nothing
                          : options.leave_out == "lap" ? LeaveOut::lap
                                                       : LeaveOut::run;
    std::vector<diagnosis::NamedFold> folds = diagnosis::named_folds(experiment, observations, what);
    const std::string& file = options.case_file;
    if (what != LeaveOut::nothing && !observations.images.empty()) {
        report_error(fmt::format("{}: a camera's frames cannot be left out", file), "leave out --leave-out",
                     options.json);
        return std::nullopt;
    }
    if (what == LeaveOut::lap && folds.size() < 2) {
        report_error(fmt::format("{}: fewer than two laps are known that could be left out", file),
                     "see which laps a log has: tiretherm check LOG; or leave out runs: --leave-out run", options.json);
        return std::nullopt;
    }
    if (what == LeaveOut::run && folds.empty()) {
        report_error(fmt::format("{}: the only run cannot be left out", file),
                     "give several [[run]], or leave out laps: --leave-out lap", options.json);
        return std::nullopt;
    }
    return folds;
}

int identify(const IdentifyOptions& options) {
    if (options.plan && options.profile) {
        report_error("a plan is of first order and has no profiles", "leave out --profile", options.json);
        return Exit::input_error;
    }
    if (options.plan && !options.leave_out.empty()) {
        report_error("a plan has no data that could be left out", "leave out --leave-out", options.json);
        return Exit::input_error;
    }
    solver::install_stop_handlers();
    std::optional<input::ExperimentReading> reading = read_measured(
        options, "nothing was fitted", options.plan ? input::ReadMode::planned : input::ReadMode::measured);
    if (!reading || !has_free_parameters(options, *reading->experiment)) {
        return Exit::input_error;
    }
    if (options.plan) {
        return plan(options, *reading);
    }
    const input::Experiment& experiment = *reading->experiment;
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    const std::optional<std::vector<diagnosis::NamedFold>> folds = what_to_leave_out(options, experiment, observations);
    if (!folds) {
        return Exit::input_error;
    }
    now_doing("fitting " + options.case_file);
    const auto folder = open_output(folder_of(options, "out/" + experiment.runs.front().problem.name), reading->files,
                                    post::identification_names(), "nothing was fitted", options.json);
    if (!folder) {
        return Exit::input_error;
    }
    const auto journal = open_journal(options, *folder, "identify", reading->files);
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
    SimulationCount count(options.quiet);
    const diagnosis::Identification result = diagnosis::identify(experiment, observations,
                                                                 {.profile = options.profile,
                                                                  .finer = finer ? &*finer : nullptr,
                                                                  .leave_out = *folds,
                                                                  .progress = count.shown()});
    count.wipe();
    if (!result.status.ok()) {
        return report_failure(options, result.status, *folder, *journal, "nothing was fitted");
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
        options, *folder, post::identification_names(), "identify",
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
    tell_of_journal(*journal);
    if (!page) {
        return Exit::input_error;
    }
    print_page(options, *page);
    return result.converged ? Exit::done : Exit::numerical_failure;
}

}  // namespace

void add_identify_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("identify", "Fit parameters of a case to measured runs, with 95 % intervals");
    const auto options = std::make_shared<IdentifyOptions>();
    add_measured_options(*command, *options, "[[run]] and [[parameter]]",
                         "files of an earlier fit there are replaced. Default: out/<case name>; of a plan none");
    add_fresh_option(*command, options->fresh);
    command->add_flag("--profile", options->profile,
                      "Intervals by profile likelihood, which need not be symmetric: some ten fits for each parameter");
    command->add_flag("--plan", options->plan,
                      "Before anything is measured: the intervals that these runs and sensors would give");
    command
        ->add_option("--leave-out", options->leave_out,
                     "Each lap, or each run, is predicted by a fit without it as well: some three fits for each")
        ->option_text("lap|run")
        ->check(CLI::IsMember({"lap", "run"}));
    add_seconds_option(*command, "--correlation-time", options->correlation_time,
                       "Of the noise that a plan assumes. Default: 10", Seconds::from_zero);
    command->footer(
        "All runs and channels are fitted at once. The noise of each channel, correlated and white, is estimated from\n"
        "what no parameter can explain. A parameter that the data do not see is named as such.\n"
        "Findings say which parameters are not as expected, and why: far off what was known before, at a size that no "
        "tire\n"
        "has (tiretherm effects EFFECT). Beside such a parameter, or where an error of the model may pass for noise, "
        "the others\n"
        "are called doubtful.\n"
        "Of a camera's frames every pixel is taken, and what the grid and the steps make of them is corrected.\n"
        "A plan takes every sensor with a standard_deviation, at the times of the runs' files or of [time] output.\n"
        "Files: report.html (this page with charts, for a browser), page.txt (this page), identified.toml (the case "
        "with the\n"
        "fitted values), identify.csv (a row for each sample), parameters.csv (values, intervals and correlations), "
        "laws.csv\n"
        "(k(T) and c(T) that were fitted, with their 95 % bands); of laps and of a car's tires laps.csv; of a plan the "
        "page and\n"
        "plan.json.\n"
        "Charts as pictures: tiretherm report DIR --png\n\n"
        "The files appear together at the end. A fit that was interrupted or killed goes on when the same call is "
        "made\n"
        "again: its simulations are kept in the hidden folder .tiretherm until then.\n\n"
        "Exit code: 0 done; 1 an error in the call, the case or the data; 2 the solver failed or the search did not\n"
        "converge; 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm identify cases/practice/two_node_bench.toml \\\n"
        "      --data cases/practice/puzzle1.csv --out out/puzzle\n"
        "  tiretherm identify cases/laser/identify.toml --plan");
    command->callback([options, &exit_code] { exit_code = identify(*options); });
}

}  // namespace tiretherm::app
