// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm study`: runs a case many times on a grid or with random draws, in several threads; runs that are already
// there are kept.

#include <memory>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/terminal.hpp"
#include "calls/calls.hpp"
#include "diagnosis/study/study_part.hpp"

namespace tiretherm::app {

namespace {

using StudyOptions = Told<calls::StudyOptions>;

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
    command->add_flag("--fresh", options->fresh, "Make all runs again, also those that are kept");
    command->add_flag("--no-report", options->no_report, "No report.html and no page.txt");
    add_told_options(*command, *options, "summary");
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
    command->callback([options, &exit_code] { exit_code = make(*options, calls::study); });
}

}  // namespace tiretherm::app
