#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "cases/experiment.hpp"
#include "cases/reader.hpp"
#include "diagnosis/identification_report.hpp"
#include "post/file.hpp"

namespace tiretherm::app {

namespace {

struct Options {
    std::string case_file;
    std::vector<std::string> data;
    std::string directory;
    double correlation_time = 10.0;  ///< s, of a plan's noise
    bool profile = false;
    bool plan = false;
    bool json = false;
};

/// Of a plan's noise, what is new in every sample.
constexpr double white_share = 0.3;

/// What a fit would say.
int plan(const Options& options, const std::vector<std::filesystem::path>& data, cases::ExperimentReading& reading) {
    const cases::Experiment experiment = diagnosis::planned(std::move(*reading.experiment));
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    if (observations.rows.empty()) {
        tell_error(fmt::format("{}: no sensor says how well it measures", options.case_file),
                   "state standard_deviation with each [[sensor]] that will be there", options.json);
        return Exit::mistake;
    }
    const diagnosis::Identification result =
        diagnosis::plan(experiment, observations,
                        diagnosis::stated_noise(experiment, observations, options.correlation_time, white_share));
    if (!result.status.ok()) {
        tell_error(result.status.message, "nothing was planned", options.json);
        return Exit::numerical_failure;
    }
    const diagnosis::IdentificationRecord record{.experiment = experiment,
                                                 .observations = observations,
                                                 .result = result,
                                                 .case_file = options.case_file,
                                                 .data = data,
                                                 .warnings = reading.warnings,
                                                 .findings = {},
                                                 .planned = true};
    std::vector<std::filesystem::path> files;
    try {
        if (!options.directory.empty()) {
            files = diagnosis::write_identification(record, options.directory);
        }
    } catch (const post::FileError& error) {
        tell_error(error.what(), "choose another directory with --out", options.json);
        return Exit::mistake;
    }
    if (options.json) {
        fmt::print("{}", diagnosis::identification_json(record, files));
    } else {
        fmt::print("{}", diagnosis::identification_text(record, may_be_bold()));
        fmt::print(
            "\nNoise assumed: as stated with the sensors; {:.0f} % of its variance new in every sample, the rest "
            "forgotten over {:g} s (--correlation-time).\n",
            100.0 * (options.correlation_time > 0.0 ? white_share : 1.0), options.correlation_time);
    }
    return Exit::done;
}

int identify(const Options& options) {
    if (!(options.correlation_time >= 0.0)) {
        tell_error(fmt::format("the correlation time is {} s", options.correlation_time), "give 0 s or more",
                   options.json);
        return Exit::mistake;
    }
    if (options.plan && options.profile) {
        tell_error("a plan is of first order and has no profiles", "leave out --profile", options.json);
        return Exit::mistake;
    }
    const std::vector<std::filesystem::path> data(options.data.begin(), options.data.end());
    cases::ExperimentReading reading = cases::read_experiment(
        options.case_file, data, options.plan ? cases::Occasion::planned : cases::Occasion::measured);
    if (!reading.experiment) {
        tell_mistakes({.problem = std::nullopt, .mistakes = reading.mistakes, .warnings = reading.warnings},
                      "nothing was fitted", options.json);
        return Exit::mistake;
    }
    if (reading.experiment->parameters.empty()) {
        tell_error(fmt::format("{}: no number of the case is free", options.case_file),
                   "name those to be fitted: [[parameter]], see cases/README.md", options.json);
        return Exit::mistake;
    }
    if (options.plan) {
        return plan(options, data, reading);
    }
    const cases::Experiment& experiment = *reading.experiment;
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    const bool watched = on_terminal(stdout) && on_terminal(stderr) && !options.json;
    const auto progress = [](long simulations) { fmt::print(stderr, "\r{} simulations ", simulations); };
    const diagnosis::Identification result = diagnosis::identify(
        experiment, observations,
        {.profile = options.profile, .progress = watched ? std::function<void(long)>(progress) : nullptr});
    if (watched) {
        fmt::print(stderr, "\r{:20}\r", "");
    }
    if (!result.status.ok()) {
        tell_error(result.status.message, "nothing was fitted", options.json);
        return Exit::numerical_failure;
    }
    diagnosis::IdentificationRecord record{.experiment = experiment,
                                           .observations = observations,
                                           .result = result,
                                           .case_file = options.case_file,
                                           .data = data,
                                           .warnings = reading.warnings,
                                           .findings = reading.findings};
    std::vector<std::filesystem::path> files;
    try {
        const std::string name = experiment.runs.front().problem.name;
        files = diagnosis::write_identification(record, options.directory.empty() ? "out/" + name : options.directory);
        // A law that fits where the data are may fail elsewhere, and the case with it.
        if (const cases::Reading fitted = cases::read_case(files.front()); !fitted.problem) {
            record.warnings.push_back("the fitted case cannot be run as it is: " + fitted.mistakes.front().what);
        }
    } catch (const post::FileError& error) {
        tell_error(error.what(), "choose another directory with --out", options.json);
        return Exit::mistake;
    }
    if (options.json) {
        fmt::print("{}", diagnosis::identification_json(record, files));
    } else {
        fmt::print("{}\nFiles\n", diagnosis::identification_text(record, may_be_bold()));
        for (const std::filesystem::path& file : files) {
            fmt::print("  {}\n", file.string());
        }
    }
    return result.converged ? Exit::done : Exit::numerical_failure;
}

}  // namespace

void add_identify_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("identify", "Fit numbers of a case to measured runs, with honest intervals");
    const auto options = std::make_shared<Options>();
    command->add_option("CASE", options->case_file, "Case file (TOML) with [[run]] and [[parameter]]")
        ->required()
        ->option_text(" ");
    command
        ->add_option("--data", options->data,
                     "A measured run (CSV or HDF5), once for each; they take the place of the case's own")
        ->option_text("FILE ...");
    command
        ->add_option(
            "--out", options->directory,
            "Where the files go; files of an earlier fit there are replaced. Default: out/<case name>; of a plan none")
        ->option_text("DIR");
    command->add_flag("--profile", options->profile,
                      "Intervals by profile likelihood, which need not be symmetric: some ten fits a number");
    command->add_flag("--plan", options->plan,
                      "Before anything is measured: the intervals that these runs and sensors would give");
    command
        ->add_option("--correlation-time", options->correlation_time, "Of the noise that a plan assumes. Default: 10")
        ->option_text("SECONDS");
    command->add_flag("--json", options->json, "One JSON object instead of the page");
    command->footer(
        "All runs and channels are fitted at once. The noise of each channel, correlated and white, is estimated from\n"
        "what no number can explain. A number that the data do not see is named as such.\n"
        "A plan takes every sensor with a standard_deviation, at the times of the runs' files or of [time] output.\n"
        "Files: identified.toml (the case with the fitted values), identify.csv (a row for each sample);\n"
        "plan.json of a plan.\n\n"
        "Exit code: 0 done; 1 a mistake in the call, the case or the data; 2 the solver failed or the search did not\n"
        "converge.\n\n"
        "Example:\n"
        "  tiretherm identify cases/practice/two_node_bench.toml --data run1.csv --data run2.csv --out /tmp/bench\n"
        "  tiretherm identify cases/laser/identify.toml --plan");
    command->callback([options, &exit_code] { exit_code = identify(*options); });
}

}  // namespace tiretherm::app
