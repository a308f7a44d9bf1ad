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
#include "diagnosis/comparison.hpp"
#include "post/file.hpp"

namespace tiretherm::app {

namespace {

struct Options {
    std::string case_file;
    std::vector<std::string> data;
    std::string directory;
    bool json = false;
};

int compare(const Options& options) {
    const std::vector<std::filesystem::path> data(options.data.begin(), options.data.end());
    cases::ExperimentReading reading = cases::read_experiment(options.case_file, data);
    if (!reading.experiment) {
        tell_mistakes({.problem = std::nullopt, .mistakes = reading.mistakes, .warnings = reading.warnings},
                      "nothing was compared", options.json);
        return Exit::mistake;
    }
    const std::string name = reading.experiment->runs.front().problem.name;
    diagnosis::Comparison comparison = diagnosis::compare(*reading.experiment, name);
    if (!comparison.status.ok()) {
        tell_error(comparison.status.message, "nothing was compared", options.json);
        return Exit::numerical_failure;
    }
    comparison.warnings = reading.warnings;
    comparison.findings = reading.findings;
    std::vector<std::filesystem::path> files;
    try {
        files = diagnosis::write_comparison(comparison, options.directory.empty() ? "out/" + name : options.directory);
    } catch (const post::FileError& error) {
        tell_error(error.what(), "choose another directory with --out", options.json);
        return Exit::mistake;
    }
    if (options.json) {
        fmt::print("{}", diagnosis::comparison_json(comparison, files));
        return Exit::done;
    }
    fmt::print("{}\nFiles\n", diagnosis::comparison_text(comparison, may_be_bold()));
    for (const std::filesystem::path& file : files) {
        fmt::print("  {}\n", file.string());
    }
    return Exit::done;
}

}  // namespace

void add_compare_command(CLI::App& program, int& exit_code) {
    CLI::App* command = program.add_subcommand("compare", "Measured against simulated, channel by channel");
    const auto options = std::make_shared<Options>();
    command->add_option("CASE", options->case_file, "Case file (TOML) with measured runs or numbers")
        ->required()
        ->option_text(" ");
    command
        ->add_option("--data", options->data,
                     "A measured run (CSV or HDF5), once for each; they take the place of the case's own")
        ->option_text("FILE ...");
    command
        ->add_option("--out", options->directory,
                     "Where the files go; files of an earlier comparison there are replaced. Default: out/<case name>")
        ->option_text("DIR");
    command->add_flag("--json", options->json, "One JSON object instead of the page");
    command->footer(
        "The case is simulated as it stands: nothing is fitted. Differences are simulated - measured.\n"
        "Files: compare.csv (a row for each sample), compare_statistics.csv (a row for each figure).\n\n"
        "Exit code: 0 done, however far apart; 1 a mistake in the call, the case or the data; 2 the solver failed.\n\n"
        "Example:\n"
        "  tiretherm compare cases/practice/two_node_bench.toml --data run1.csv --data run2.csv --out /tmp/bench");
    command->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace tiretherm::app
