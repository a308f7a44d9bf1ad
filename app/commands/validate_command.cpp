// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm validate`: runs the cases of a validation table and compares the models with the measured numbers.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/measured_call.hpp"
#include "calls/doing.hpp"
#include "calls/output.hpp"
#include "diagnosis/validation/validation_rows.hpp"
#include "diagnosis/validation/validation_runs.hpp"
#include "input/files/run_name.hpp"
#include "input/text/suggestions.hpp"
#include "input/validation/validation.hpp"
#include "post/report/progress.hpp"
#include "post/report/remark_text.hpp"
#include "post/validation/validation_report.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

constexpr const char* shipped = "cases/validation.toml";

struct ValidateOptions : Told<calls::MeasuredCall> {
    std::string table = shipped;
    std::vector<std::string> only;
    unsigned threads = 0;
    bool markdown = false;
    bool inputs = false;
};

using Clock = std::chrono::steady_clock;

/// Says what is wrong and returns true, or leaves the table as asked for.
bool refuses(input::ValidationReading& reading, const ValidateOptions& options) {
    if (!reading.table) {
        std::error_code error;
        if (!std::filesystem::exists(options.table, error) && options.table == shipped) {
            report_error(fmt::format("there is no {} here", shipped),
                         "call it in the folder of the source, or give a table: tiretherm validate EXPERIMENTS",
                         options.json);
        } else {
            report_errors({.errors = reading.errors, .warnings = reading.warnings}, "nothing was run", options.json);
        }
        return true;
    }
    const std::vector<std::string> known = reading.table->ids();
    if (!options.only.empty()) {
        if (const std::vector<std::string> unknown = reading.table->keep(options.only); !unknown.empty()) {
            report_error(fmt::format("there is no experiment \"{}\"", unknown.front()),
                         input::suggest(unknown.front(), known, "experiments"), options.json);
            return true;
        }
    }
    return false;
}

/// Writes the files of the call and prints its page.
int finish(const ValidateOptions& options, const diagnosis::ValidationRecord& record, post::OutputFolder& folder,
           calls::Caller& caller) {
    const auto page = calls::write_measured_page(
        options, folder, post::validation_names(), "validate", caller,
        [&](const std::filesystem::path& stage) { return post::write_validation(record, stage); },
        [&](const auto& files) { return post::validation_report(record, options.inputs, files); });
    if (!page) {
        return Exit::input_error;
    }
    if (!options.markdown) {
        caller.take(*page);
    }
    return Exit::done;
}

/// Files that the call reads: the table and its cases.
std::vector<std::string> files_of(const ValidateOptions& options, const input::Validation& table) {
    std::vector<std::string> files{options.table};
    for (const input::ValidationRun& run : table.runs) {
        if (std::ranges::find(files, run.file.string()) == files.end()) {
            files.push_back(run.file.string());
        }
    }
    return files;
}

int validate(const ValidateOptions& options, calls::Caller& caller) {
    input::ValidationReading reading =
        calls::while_reading(options.table, [&] { return input::read_validation(options.table); });
    if (refuses(reading, options)) {
        return Exit::input_error;
    }
    const input::Validation& table = *reading.table;
    std::unique_ptr<post::OutputFolder> folder;
    if (!options.markdown || !options.directory.empty()) {
        folder = calls::open_output(calls::folder_of(options, "out/" + input::plain_stem(options.table) + "/validate"),
                                    files_of(options, table), post::validation_names(), "nothing was run", caller);
        if (!folder) {
            return Exit::input_error;
        }
    }
    calls::now_doing("making the runs of " + options.table);
    const Clock::time_point begin = Clock::now();
    post::ProgressLine line(stderr, options.quiet);
    const diagnosis::RunResults results = diagnosis::run_all(
        table.runs, options.threads, [&](std::size_t done) { line.show({.done = done, .total = table.runs.size()}); });
    line.wipe();
    if (solver::stop_requested()) {
        report_error("stopped", "there is no table", options.json);
        return Exit::interrupted;
    }
    std::vector<std::string> warnings = reading.warnings;
    std::ranges::move(post::texts_of(results.warnings), std::back_inserter(warnings));
    const diagnosis::ValidationRecord record{.title = table.title,
                                             .models = table.models,
                                             .rows = diagnosis::validation_rows(table, results),
                                             .runs = table.runs.size(),
                                             .seconds = std::chrono::duration<double>(Clock::now() - begin).count(),
                                             .energy_closure = results.energy_closure,
                                             .warnings = warnings};
    if (folder) {
        if (const int written = finish(options, record, *folder, caller); written != Exit::done) {
            return written;
        }
    }
    if (options.markdown) {
        fmt::print("{}", post::validation_markdown(record));
        if (options.inputs) {
            fmt::print("\n{}", post::validation_inputs_markdown(record));
        }
    }
    const bool failed = std::any_of(results.failures.begin(), results.failures.end(),
                                    [](const std::string& failure) { return !failure.empty(); });
    return failed ? Exit::numerical_failure : Exit::done;
}

}  // namespace

void add_validate_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("validate", "Run the experiments of a table and compare the models with them");
    const auto options = std::make_shared<ValidateOptions>();
    command->add_option("EXPERIMENTS", options->table, "Table of measured numbers (TOML)")
        ->capture_default_str()
        ->option_text(fmt::format("[{}]", shipped));
    command->add_option("--only", options->only, "Only these experiments: M1,M2")
        ->option_text("ID,...")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--threads", options->threads, "Runs at a time. Default: as many as the machine can do")
        ->option_text("N")
        ->check(CLI::Range(1, 1024));
    add_out_option(*command, options->directory,
                   "Where the files go; those of an earlier validation there are replaced. Default: out/<table "
                   "name>/validate");
    command->add_flag("--no-report", options->no_report, "No report.html and no page.txt");
    add_told_options(*command, *options, "table");
    command->add_flag("--markdown", options->markdown, "The table for a README, and no files without --out")
        ->excludes("--json");
    command->add_flag("--inputs", options->inputs,
                      "Also the inputs of the experiments, and what those that are not printed change");
    command->footer(
        "u is the standard uncertainty of a measured number and of what the source does not print; a model is within\n"
        "it up to 2 u. A number whose verdict depends on what is not printed is not decidable.\n"
        "What a table may say is described in cases/README.md.\n"
        "Files: report.html (this page with charts, for a browser), page.txt (this page), validation.json (all "
        "figures).\n\n"
        "Exit code: 0 done, whatever the verdicts; 1 an error in the call, the table or a case; 2 a run failed;\n"
        "130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm validate --only M1,M2");
    command->callback([options, &exit_code] { exit_code = make(*options, validate); });
}

}  // namespace tiretherm::app
