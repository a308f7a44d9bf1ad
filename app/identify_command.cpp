#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/messages.hpp"
#include "cases/experiment.hpp"
#include "diagnosis/identification_report.hpp"
#include "post/file.hpp"

namespace tiretherm::app {

namespace {

struct Options {
    std::string case_file;
    std::vector<std::string> data;
    std::string directory;
    bool profile = false;
    bool json = false;
};

int identify(const Options& options) {
    const std::vector<std::filesystem::path> data(options.data.begin(), options.data.end());
    const cases::ExperimentReading reading = cases::read_experiment(options.case_file, data);
    if (!reading.experiment) {
        tell_mistakes({.problem = std::nullopt, .mistakes = reading.mistakes, .warnings = reading.warnings},
                      "nothing was fitted", options.json);
        return Exit::mistake;
    }
    const cases::Experiment& experiment = *reading.experiment;
    if (experiment.parameters.empty()) {
        tell_error(fmt::format("{}: no number of the case is free", options.case_file),
                   "name those to be fitted: [[parameter]], see cases/README.md", options.json);
        return Exit::mistake;
    }
    const diagnosis::Observations observations = diagnosis::observe(experiment);
    const diagnosis::Identification result =
        diagnosis::identify(experiment, observations, {.profile = options.profile});
    if (!result.status.ok()) {
        tell_error(result.status.message, "nothing was fitted", options.json);
        return Exit::numerical_failure;
    }
    const diagnosis::IdentificationRecord record{.experiment = experiment,
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
        ->add_option("--out", options->directory,
                     "Where the files go; files of an earlier fit there are replaced. Default: out/<case name>")
        ->option_text("DIR");
    command->add_flag("--profile", options->profile,
                      "Intervals by profile likelihood, which need not be symmetric: some ten fits a number");
    command->add_flag("--json", options->json, "One JSON object instead of the page");
    command->footer(
        "All runs and channels are fitted at once. The noise of each channel, correlated and white, is estimated from\n"
        "what no number can explain. A number that the data do not see is named as such.\n"
        "Files: identified.toml (the case with the fitted values), identify.csv (a row for each sample).\n\n"
        "Exit code: 0 done; 1 a mistake in the call, the case or the data; 2 the solver failed or the search did not\n"
        "converge.\n\n"
        "Example:\n"
        "  tiretherm identify cases/practice/two_node_bench.toml --data run1.csv --data run2.csv --out /tmp/bench");
    command->callback([options, &exit_code] { exit_code = identify(*options); });
}

}  // namespace tiretherm::app
