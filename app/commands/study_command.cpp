// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm study`: runs a case many times on a grid or with random draws, in several threads; runs that are already
// there are kept.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/build_identity.hpp"
#include "app/commands.hpp"
#include "app/commands/study_merge.hpp"
#include "app/failure.hpp"
#include "app/messages.hpp"
#include "app/mpi_ranks.hpp"
#include "app/output.hpp"
#include "diagnosis/study/study_runs.hpp"
#include "input/runs/runs.hpp"
#include "input/studies/study.hpp"
#include "post/report/progress.hpp"
#include "post/report/remark_text.hpp"
#include "post/study/study_files.hpp"
#include "post/study/study_journal.hpp"
#include "post/study/study_report.hpp"
#include "solver/stop_signal.hpp"

namespace tiretherm::app {

namespace {

struct StudyOptions {
    std::string study_file;
    std::string directory;
    unsigned threads = 0;
    std::string part;
    bool merge = false;
    bool mpi = false;
    bool fresh = false;
    bool json = false;
    bool quiet = false;
    bool no_report = false;
};

using Clock = std::chrono::steady_clock;

/// What a part's call has to say: its files come with the merge.
void report_part(const diagnosis::StudyPart& part, const diagnosis::StudyResults& results, std::size_t runs,
                 const StudyOptions& options) {
    if (options.json) {
        const nlohmann::ordered_json json{{"part", part.index},
                                          {"of", part.count},
                                          {"runs", runs},
                                          {"kept", results.kept},
                                          {"made", results.done - results.kept}};
        fmt::print("{}\n", json.dump(2));
    } else if (!options.quiet) {
        fmt::print(
            "Part {}: {} runs are done, {} of them were kept. When all parts are:\n  tiretherm study {} --merge{}\n",
            part.text(), runs, results.kept, options.study_file,
            options.directory.empty() ? "" : " --out " + options.directory);
    }
}

/// The failure that a call ends with whose runs did not all come to an end.
/// @param outcomes [n_runs], of which those of the part are looked at  @param runs of the part
int report_failed(std::span<const diagnosis::StudyOutcome> outcomes, const diagnosis::StudyPart& part, std::size_t runs,
                  const std::filesystem::path& directory, bool json) {
    std::vector<std::size_t> failed;
    for (std::size_t run = 0; run < outcomes.size(); ++run) {
        if (part.has(run) && !outcomes[run].ok()) {
            failed.push_back(run);
        }
    }
    if (failed.empty()) {
        return Exit::done;
    }
    if (!json) {
        std::fflush(stdout);
        report_error(fmt::format("{} of {} runs failed, the first is run {}: {}", failed.size(), runs,
                                 failed.front() + 1, outcomes[failed.front()].failure),
                     "the others are in " + directory.string(), false);
    }
    return Exit::numerical_failure;
}

/// Puts the runs of all parts into the journal. @returns false after a report where they do not fit together
bool merges(const input::Study& study, const std::filesystem::path& whole, post::StudyJournal& journal, bool json) {
    try {
        const std::vector<std::string> problems = merge_parts(study, whole, build_identity(), journal);
        for (std::size_t i = 0; i + 1 < problems.size() && !json; ++i) {
            report_error(problems[i], "", false);
        }
        if (!problems.empty()) {
            report_error(json ? fmt::format("{}", fmt::join(problems, "; ")) : problems.back(),
                         "nothing was written; what the parts have is kept", json);
        }
        return problems.empty();
    } catch (const std::runtime_error& error) {
        report_error(error.what(), "nothing was merged; call again when it has ended", json);
        return false;
    }
}

/// Adds what the runs themselves give reason to warn of; writes the files and prints the page.
/// @param kept a sentence on what a call that failed leaves  @returns false after a report where a file cannot be written
bool write_page(diagnosis::StudyRecord& record, post::StudyCall call, post::StudyFiles& files,
                const post::OutputFolder& folder, const std::string& kept, const StudyOptions& options) {
    std::ranges::move(post::texts_of(record.left_ranges()), std::back_inserter(record.warnings));
    for (const std::string& key : record.without_effect()) {
        record.warnings.push_back(fmt::format("\"{}\" changed nothing: no effect that is on looks at it", key));
    }
    post::Report page;
    try {
        files.write(record, [&](const std::vector<std::filesystem::path>& named) {
            call.files = named;
            page = post::study_report(record, call);
            return page;
        });
    } catch (const std::runtime_error& error) {
        report_error(folder.in_place(error.what()), kept, options.json);
        return false;
    }
    if (options.json || !options.quiet) {
        print_report(page, options.json);
    }
    return true;
}

int study(const StudyOptions& options) {
    solver::install_stop_handlers();
    input::StudyReading reading =
        while_reading(options.study_file, [&] { return input::read_study(options.study_file); });
    if (was_stopped("nothing was run", options.json)) {
        return Exit::interrupted;
    }
    if (!reading.study) {
        report_errors({.errors = reading.errors, .warnings = reading.warnings}, "nothing was run", options.json);
        return Exit::input_error;
    }
    const input::Study& study = *reading.study;
    const auto part = options.part.empty() ? diagnosis::StudyPart{} : *diagnosis::StudyPart::parse(options.part);
    const std::filesystem::path whole =
        options.directory.empty() ? "out/" + input::case_name(study.file) : options.directory;
    const std::filesystem::path directory = options.part.empty() ? whole : whole / part.folder();
    const auto folder =
        open_output(directory, reading.files, post::StudyFiles::names(), "nothing was run", options.json);
    if (!folder) {
        return Exit::input_error;
    }
    std::optional<post::StudyFiles> files;
    std::optional<post::StudyJournal> journal;
    try {
        files.emplace(*folder, !options.no_report);
        journal.emplace(files->journal(), study.channels.size(), build_identity(), options.fresh);
    } catch (const std::runtime_error& error) {
        report_error(error.what(), "nothing was run; choose another directory with --out", options.json);
        return Exit::input_error;
    }
    const std::size_t runs = part.size(study.runs.size());
    if (options.merge && !merges(study, whole, *journal, options.json)) {
        return Exit::input_error;
    }
    now_doing(fmt::format("making the runs of {} and writing to {}", options.study_file, directory.string()));
    const Clock::time_point begin = Clock::now();
    diagnosis::StudyResults results;
    {
        post::ProgressLine line(stderr, options.quiet);
        std::optional<std::size_t> kept;
        const auto show = [&](std::size_t done) {
            kept = kept.value_or(done - 1);
            line.show({.done = done, .total = runs, .kept = *kept});
        };
        results = diagnosis::run_study(study, *journal, options.threads, show, part);
    }
    const std::string kept = fmt::format("{} of {} runs are kept in {}; the same call goes on from there", results.done,
                                         runs, directory.string());
    if (!results.error.empty()) {
        report_error(results.error, kept, options.json);
        return Exit::input_error;
    }
    if (results.done < runs) {
        report_error("stopped", kept, options.json);
        return Exit::interrupted;
    }
    if (!options.part.empty()) {
        report_part(part, results, runs, options);
        return report_failed(results.outcomes, part, runs, directory, options.json);
    }
    const post::StudyCall call{.kept = results.kept,
                               .outdated = journal->outdated(),
                               .damaged = journal->damaged(),
                               .seconds = std::chrono::duration<double>(Clock::now() - begin).count(),
                               .run_seconds = results.run_seconds,
                               .threads = post::threads_used(options.threads, study.runs.size() - results.kept),
                               .files = {}};
    diagnosis::StudyRecord record = post::study_record(study, std::move(results.outcomes));
    record.warnings = std::move(reading.warnings);
    if (!write_page(record, call, *files, *folder, kept, options)) {
        return Exit::input_error;
    }
    return report_failed(record.outcomes, part, runs, directory, options.json);
}

/// Each rank makes a part, in one thread unless another number is asked for; the first puts them together.
int study_over_ranks(const StudyOptions& options) {
    const std::optional<MpiRanks> ranks = MpiRanks::join();
    if (!ranks) {
        report_error("this program was built without MPI",
                     "configure it with -DTIRETHERM_MPI=ON, or share the study by --part and --merge", options.json);
        return Exit::input_error;
    }
    StudyOptions mine = options;
    mine.threads = options.threads == 0 ? 1 : options.threads;
    if (ranks->size() == 1) {
        return study(mine);
    }
    mine.part = diagnosis::StudyPart{.index = ranks->rank() + 1, .count = ranks->size()}.text();
    mine.quiet = true;
    mine.json = false;
    const int worst = ranks->largest(study(mine));
    if (worst != Exit::done && worst != Exit::numerical_failure) {
        return worst;
    }
    StudyOptions all = options;
    all.merge = true;
    return ranks->rank() == 0 ? study(all) : Exit::done;
}

}  // namespace

void add_study_command(CLI::App& program, int& exit_code) {
    CLI::App* command =
        program.add_subcommand("study", "Run a case many times, with values on a grid or drawn at random");
    const auto options = std::make_shared<StudyOptions>();
    command->add_option("STUDY", options->study_file, "Study file (TOML)")->required()->option_text(" ");
    add_out_option(*command, options->directory,
                   "Where the files go; runs that an earlier call made there are kept. Default: out/<study name>");
    command->add_option("--threads", options->threads, "Runs at a time. Default: as many as the machine can do")
        ->option_text("N")
        ->check(CLI::Range(1, 1024));
    CLI::Option* part =
        command
            ->add_option(
                "--part", options->part,
                "Make the K-th of N parts of the runs alone, 1/16 to 16/16, in the folder part_K_of_N of --out")
            ->option_text("K/N")
            ->check(CLI::Validator(
                [](const std::string& text) {
                    return diagnosis::StudyPart::parse(text)
                               ? std::string()
                               : fmt::format("\"{}\" is no part; write 3/16 for the third of sixteen", text);
                },
                ""));
    command->add_flag("--merge", options->merge, "Put the parts together: the files are those of one call for all runs")
        ->excludes(part);
    command
        ->add_flag("--mpi", options->mpi,
                   "Share the runs out over the ranks of mpirun and put them together; in a program built with "
                   "TIRETHERM_MPI")
        ->excludes(part);
    command->add_flag("--fresh", options->fresh, "Make all runs again, also those that are kept");
    command->add_flag("--no-report", options->no_report, "No report.html and no page.txt");
    add_quiet_option(*command, options->quiet);
    command->add_flag("--json", options->json, "One JSON object instead of the summary");
    command->footer(
        "A study names a case and what to change in it:\n"
        "  case = \"../two_node/4000N_100kmh.toml\"\n"
        "  critical = \"110 degC\"                    # optional\n"
        "  [[vary]]                                 # sides of a grid\n"
        "  key = \"drive.speed\"\n"
        "  values = [\"80 km/h\", \"120 km/h\"]         # or from, to and count\n"
        "  [[draw]]                                 # at random at each point of the grid\n"
        "  key = \"effects.road_contact.Hc\"\n"
        "  distribution = \"normal\"                  # or lognormal; uniform: from, to\n"
        "  mean = \"500 W/m2K\"                       # low and high cut any of them\n"
        "  standard_deviation = \"50 W/m2K\"\n"
        "  [sample]\n"
        "  count = 200\n"
        "A key is a path into the case; in lists a name stands for its table: mesh.layer.tread.thickness.\n\n"
        "Files: report.html (this page with maps, curves or the distribution of the hottest temperature, for a "
        "browser),\n"
        "page.txt (this page), study.csv and study.h5 (a row for each run), runs.jsonl (the runs as they are made).\n"
        "Charts as pictures: tiretherm report DIR --png\n"
        "Each run that is done is kept, whatever ends the program; the next call makes what is missing and what has\n"
        "changed. Ctrl-C ends a study early.\n\n"
        "Several machines share a study by --part, each part in any order and as often as it takes, for example in a "
        "job\n"
        "array: tiretherm study STUDY --part $SLURM_ARRAY_TASK_ID/16 --out DIR. Then --merge with the same --out; it "
        "says\n"
        "which parts are missing.\n\n"
        "Exit code: 0 done, 1 an error in the call, the study or the case, 2 runs failed, 130 interrupted.\n\n"
        "Example:\n"
        "  tiretherm study cases/studies/speed_and_load_two_node.toml --out out/map");
    command->callback(
        [options, &exit_code] { exit_code = options->mpi ? study_over_ranks(*options) : study(*options); });
}

}  // namespace tiretherm::app
