// SPDX-License-Identifier: BSD-3-Clause
// Calls that attack or wish too much: damaged journals, full disks, outputs that take nothing, sizes beyond limits, names with
// control characters. All of them end with a sentence and exit code 1.

#include <sys/mount.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/spawned.hpp"

namespace tiretherm::app_test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string bench_data = cases + "practice/two_node_bench.toml --data " + cases + "practice/run1.csv";

/// Three speeds of the two-node tire.
const std::string three = "case = \"" + two_node + R"("
[[vary]]
key = "drive.speed"
values = ["60 km/h", "90 km/h", "120 km/h"]
)";

/// A cube of rubber of n cells a side, for a second.
std::string cube(int n, const std::string& more = "") {
    return fmt::format(R"({1}
[mesh]
kind = "block"
x = [{{ to = "30 mm", cells = {0} }}]
y = [{{ to = "30 mm", cells = {0} }}]
[[mesh.layer]]
name = "tread"
thickness = "30 mm"
cells = {0}
material = "rubber"
[[material]]
name = "rubber"
density = "1100 kg/m3"
heat_capacity = "1800 J/kgK"
conductivity = "0.3 W/mK"
[effects.uniform_source]
power_density = "1e4 W/m3"
[initial]
temperature = "23 degC"
[time]
end = "1 s"
[[sensor]]
name = "inside"
kind = "layer"
layer = "tread"
)",
                       n, more);
}

/// Runs a line of the shell. @returns its exit code
int shell(const std::string& line) {
    const int status = std::system(line.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

// ---- journals -------------------------------------------------------------------------------------------------------

// Each value of the wrong type or length in the place of a list crashed the program, or would show numbers of nothing. The
// study ends with the files of one that nobody damaged.
TEST(Attacked, DamagedJournalOfAStudyIsMadeAnewAndToldOf) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", three);
    ASSERT_EQ(call("study study.toml --quiet --out o", scratch.path()).exit_code, 0);
    const auto whole = files_of(scratch / "o");
    const std::string journal = whole.at("runs.jsonl");
    for (const char* key : {"\"min\":", "\"max\":", "\"final\":"}) {
        for (const char* value : {"[]", "{}", "null", "[1]", "7", "[[],[]]"}) {
            SCOPED_TRACE(std::string(key) + value);
            std::string text = journal;
            const std::size_t at = text.find(key) + std::string(key).size();
            text.replace(at, text.find(']', at) + 1 - at, value);
            post::replace_file(scratch / "o/runs.jsonl", text);
            const Call again = call("study study.toml --out o", scratch.path());
            EXPECT_EQ(again.exit_code, 0) << again.err;
            EXPECT_TRUE(has(again.out, "2 kept, 1 made now")) << again.out;
            EXPECT_TRUE(has(again.out, "1 damaged line of runs.jsonl could not be read and was dropped")) << again.out;
            EXPECT_EQ(files_of(scratch / "o").at("study.csv"), whole.at("study.csv"));
        }
    }
}

// A list of what is to be moved and removed, as an archive may bring it along in a hidden folder.
TEST(Attacked, PlantedListOfRemovalsIsRefusedByEveryCommand) {
    for (const std::string& command : {std::string("run case.toml"), "compare " + bench_data,
                                       std::string("study study.toml"), std::string("validate table.toml")}) {
        const sample::Scratch scratch;
        post::replace_file(scratch / "case.toml", "include = [\"" + two_node + "\"]\n");
        post::replace_file(scratch / "study.toml", three);
        post::replace_file(scratch / "table.toml", post::read_text(cases + "validation.toml"));
        post::replace_file(scratch / "precious.txt", "mine");
        fs::create_directories(scratch / ".tiretherm/new");
        post::replace_file(scratch / ".tiretherm/new/precious.txt", "planted");
        post::replace_file(scratch / ".tiretherm/commit", "-case.toml\n-study.toml\n+precious.txt\n");
        const auto before = files_of(scratch.path());
        const Call refused = call(command + " --out .", scratch.path());
        EXPECT_EQ(refused.exit_code, 1) << command;
        fs::remove(scratch / ".tiretherm/lock");  // of the call itself
        EXPECT_EQ(files_of(scratch.path()), before) << refused.err;
    }
}

TEST(Attacked, RunsOfAnotherProgramAreLeftAsTheyAre) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", three);
    fs::create_directories(scratch / "o");
    post::replace_file(scratch / "o/runs.jsonl", "{\"run\": 1, \"loss\": 0.5}\n");
    for (const char* more : {"", " --fresh"}) {
        const Call refused = call(std::string("study study.toml --out o") + more, scratch.path());
        EXPECT_EQ(refused.exit_code, 1);
        EXPECT_TRUE(
            has(refused.err, "runs.jsonl: it holds something else than the runs of a study and is left as it is"))
            << refused.err;
        EXPECT_EQ(post::read_text(scratch / "o/runs.jsonl"), "{\"run\": 1, \"loss\": 0.5}\n");
    }
}

// Names of files of dots alone lead to the folder above: "...csv" and "...toml" are called "..".
TEST(Attacked, ResultsStayInTheirFolderWhateverTheFilesAreCalled) {
    const sample::Scratch scratch;
    const fs::path here = scratch / "here";
    fs::create_directories(here);
    fs::copy_file(cases + "practice/run1.csv", here / "...csv");
    post::replace_file(here / "...toml",
                       "include = [\"" + cases + "practice/two_node_bench.toml\"]\n[[run]]\nfile = \"...csv\"\n");
    EXPECT_EQ(call("run ...toml --run .. --no-report", here).exit_code, 1);
    const Call run = call("run ...toml --run unnamed --no-report", here);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(call("run ...toml --no-report", here).exit_code, 0);
    EXPECT_TRUE(fs::exists(here / "out/unnamed/unnamed/results.h5"));
    EXPECT_TRUE(fs::exists(here / "out/unnamed/results.h5"));
    EXPECT_FALSE(fs::exists(scratch / "results.h5"));
    EXPECT_FALSE(fs::exists(here / "results.h5"));
    EXPECT_FALSE(fs::exists(here / "out/results.h5"));
}

// [run] where [[run]] is meant: every command names the line, as of every other slip.
TEST(Attacked, RunsThatAreNoListAreASentenceForEveryCommand) {
    const sample::Scratch scratch;
    for (const std::string runs : {"[run]\nfile = \"run1.csv\"\n", "[run]\n", "run = 3\n", "run = \"run1.csv\"\n",
                                   "run = [1, \"a\"]\n", "run = true\n"}) {
        const std::string text = "include = [\"" + cases + "practice/two_node_bench.toml\"]\n";
        post::replace_file(scratch / "case.toml", runs.starts_with("run =") ? runs + text : text + runs);
        for (const char* command : {"check", "run", "compare", "identify", "diagnose"}) {
            const Call refused = call(std::string(command) + " case.toml", scratch.path());
            EXPECT_EQ(refused.exit_code, 1) << command << " " << runs;
            EXPECT_TRUE(has(refused.err + refused.out, "case.toml:")) << runs << refused.err << refused.out;
            EXPECT_TRUE(has(refused.err + refused.out, "remedy: ")) << runs << refused.err << refused.out;
        }
    }
}

// A quarter of a second after 1e9 s, and a tolerance that refuses it: as small a part of the run as the smallest step.
TEST(Attacked, ShortStepsAfterALongTimeComeToAnEnd) {
    const sample::Scratch scratch;
    std::string rows = "[0, 0], [999999980, 0]";
    for (int i = 1; i <= 60; ++i) {
        rows += fmt::format(", [{:.2f}, {}]", 999999980.0 + 0.25 * i, i % 2 == 0 ? 20 : 150);
    }
    for (const char* tolerance : {"5e-4 K", "2e-4 K", "1e-4 K"}) {
        post::replace_file(
            scratch / "case.toml",
            fmt::format("include = [\"{}\"]\nunset = [\"drive.speed\"]\n[time]\nend = \"1e9 s\"\noutput = "
                        "\"1e9 s\"\ntolerance = \"{}\"\n[[drive.schedule]]\ncolumns = [\"time [s]\", "
                        "\"speed [km/h]\"]\nrows = [{}]\n",
                        two_node, tolerance, rows));
        EXPECT_NE(shell(fmt::format("cd '{}' && timeout -s KILL 60 '{}' run case.toml --quiet --no-report --no-vtk "
                                    ">/dev/null 2>&1",
                                    scratch.path().string(), TIRETHERM_PROGRAM)),
                  137)
            << tolerance;
    }
}

// ---- full disks -----------------------------------------------------------------------------------------------------

TEST(Attacked, FullDiskIsASentenceForEveryCommandAndLeavesNoDraft) {
    const sample::Scratch scratch;
    const fs::path disk = scratch / "disk";
    fs::create_directories(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1M") != 0) {
        GTEST_SKIP() << "a small disk cannot be mounted here: that needs root";
    }
    post::replace_file(scratch / "study.toml", three);
    for (const std::string& command :
         {"run " + two_node + " --mat --fields 600 --out disk/o", std::string("study study.toml --out disk/o"),
          "identify " + bench_data + " --out disk/o", std::string("new 225/50R17 --out disk/o/x.toml")}) {
        int failed = 0;
        for (const std::size_t kilobytes : {0U, 1U, 2U, 4U, 8U, 12U, 20U, 32U, 48U, 80U, 128U, 200U}) {
            SCOPED_TRACE(fmt::format("{} kB free: {}", kilobytes, command));
            fs::remove_all(disk / "o");
            fs::remove(disk / "fill");
            post::replace_file(disk / "fill", std::string(fs::space(disk).available - kilobytes * 1024, 'x'));
            const Call full = call(command, scratch.path());
            if (full.exit_code == 0) {
                continue;
            }
            ++failed;
            EXPECT_EQ(full.exit_code, 1);
            EXPECT_TRUE(has(full.err, "No space left on device")) << full.err;
            if (command.starts_with("study")) {  // keeps the runs that are done
                EXPECT_FALSE(fs::exists(disk / "o/.tiretherm"));
                EXPECT_FALSE(fs::exists(disk / "o/study.csv"));
            } else if (command.starts_with("identify")) {  // on a slow machine it keeps its simulations
                std::error_code none;
                for (const fs::directory_entry& left : fs::recursive_directory_iterator(disk / "o", none)) {
                    EXPECT_TRUE(left.is_directory() || left.path().extension() == ".simulations") << left.path();
                }
            } else {
                EXPECT_FALSE(fs::exists(disk / "o"));
            }
        }
        EXPECT_GT(failed, 1) << command;
    }
    umount(disk.c_str());
}

// ---- outputs --------------------------------------------------------------------------------------------------------

TEST(Attacked, FullStandardOutputIsAnError) {
    for (const std::string& command : {"check " + two_node, "check " + two_node + " --json", std::string("effects"),
                                       std::string("keys"), std::string("--help"), std::string("run --help")}) {
        const sample::Scratch scratch;
        EXPECT_EQ(shell(fmt::format("cd '{}' && '{}' {} >/dev/full 2>err", scratch.path().string(), TIRETHERM_PROGRAM,
                                    command)),
                  1)
            << command;
        EXPECT_EQ(post::read_text(scratch / "err"),
                  "tiretherm: standard output cannot be written: No space left on device\n")
            << command;
    }
    const sample::Scratch scratch;
    EXPECT_EQ(shell(fmt::format("cd '{}' && '{}' run {} --json >/dev/full 2>err", scratch.path().string(),
                                TIRETHERM_PROGRAM, two_node)),
              1);
    EXPECT_TRUE(has(post::read_text(scratch / "err"), "standard output cannot be written"));
}

// A file of results would otherwise be opened as number 1 and get the page as well.
TEST(Attacked, ClosedStandardOutputHarmsNoResult) {
    const sample::Scratch scratch;
    const std::string program =
        fmt::format("cd '{}' && '{}' run {} --out ", scratch.path().string(), TIRETHERM_PROGRAM, two_node);
    EXPECT_EQ(shell(program + "open --quiet"), 0);
    EXPECT_EQ(shell(program + "closed >&- 2>&- <&-"), 0);
    EXPECT_EQ(files_of(scratch / "open"), files_of(scratch / "closed"));
}

// A file, a device and a folder that cannot be: refused before anything is computed, which would take minutes here.
TEST(Attacked, PlacesThatCannotBeWrittenAreRefusedBeforeComputing) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "file", "mine");
    post::replace_file(scratch / "slow.toml", slow);
    post::replace_file(scratch / "study.toml",
                       "case = \"slow.toml\"\n[[vary]]\nkey = \"drive.speed\"\nvalues = [\"60 km/h\"]\n");
    for (const std::string& command :
         {std::string("run slow.toml"), std::string("study study.toml"), "compare " + bench_data,
          "identify " + bench_data, "diagnose " + bench_data, std::string("new 225/50R17 --force")}) {
        for (const char* out : {"file/x", "/proc/x/y", "/dev/null/x"}) {
            const Call refused = call(fmt::format("{} --out {}", command, out), scratch.path());
            EXPECT_EQ(refused.exit_code, 1) << command;
            EXPECT_TRUE(refused.err.starts_with("tiretherm: cannot create the directory ")) << refused.err;
            EXPECT_TRUE(has(refused.err, "with --out")) << refused.err;
        }
    }
    EXPECT_EQ(post::read_text(scratch / "file"), "mine");
}

// ---- sizes ----------------------------------------------------------------------------------------------------------

// 3600 s in rows of a second are 3601, a field at the start and at the end.
TEST(Attacked, CheckSaysHowLargeACaseIs) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "a.toml",
                       "include = [\"" + two_node + "\"]\n[time]\noutput = \"1 s\"\nstep = \"2 s\"\n");
    const Call text = call("check a.toml", scratch.path());
    EXPECT_TRUE(has(text.out, "  size      2 cells, 3 601 rows, 2 fields, 1 800 steps; about ")) << text.out;
    const Json size = Json::parse(call("check a.toml --json", scratch.path()).out)["size"];
    EXPECT_EQ(size["rows"], 3601);
    EXPECT_EQ(size["fields"], 2);
    EXPECT_EQ(size["steps"], 1800);
    EXPECT_GT(size["output_bytes"], 3601 * 3 * 8);
}

// 166 cells a side are 4.6 million: some 9 GB. The mesh is not made: 300 MB of address space are enough to refuse it.
TEST(Attacked, LargeMeshIsRefusedBeforeItIsMade) {
#ifdef TIRETHERM_SANITIZED
    GTEST_SKIP() << "the sanitizer needs the address space itself";
#endif
    const sample::Scratch scratch;
    post::replace_file(scratch / "large.toml", cube(166));
    EXPECT_EQ(shell(fmt::format("cd '{}' && ulimit -v 1000000 && '{}' check large.toml 2>err", scratch.path().string(),
                                TIRETHERM_PROGRAM)),
              1);
    const std::string err = post::read_text(scratch / "err");
    EXPECT_TRUE(has(err, "a run on the mesh's 4.57 million cells takes about 9.2 GB of memory, more than 8 GB")) << err;
    EXPECT_TRUE(has(err, "raise the limit: [limits] memory = \"11 GB\"")) << err;
}

// The limit is raised, and the memory is not there: 3.4 million cells in 1 GB.
TEST(Attacked, MemoryThatIsNotThereIsASentence) {
#ifdef TIRETHERM_SANITIZED
    GTEST_SKIP() << "the sanitizer needs the address space itself";
#endif
    const sample::Scratch scratch;
    post::replace_file(scratch / "large.toml", cube(150, "[limits]\nmemory = \"100 GB\"\n"));
    EXPECT_EQ(shell(fmt::format("cd '{}' && ulimit -v 1000000 && '{}' check large.toml 2>err", scratch.path().string(),
                                TIRETHERM_PROGRAM)),
              1);
    EXPECT_EQ(
        post::read_text(scratch / "err"),
        "tiretherm: reading large.toml and the files that it names failed: there is not enough memory; take fewer "
        "cells, rows or samples; tiretherm check says how large a case is\n");
}

TEST(Attacked, IntervalOfFieldsIsATimeThatFits) {
    const sample::Scratch scratch;
    for (const char* value : {"-5", "0", "nan", "inf", "x", "1e400", "''"}) {
        const Call refused = call(fmt::format("run {} --fields {}", two_node, value), scratch.path());
        EXPECT_EQ(refused.exit_code, 1) << value;
        EXPECT_TRUE(has(refused.err, "is no number of seconds above 0")) << refused.err;
        EXPECT_LT(refused.err.size(), 120U);
    }
    const Call many = call("run " + two_node + " --fields 1e-7", scratch.path());
    EXPECT_EQ(many.exit_code, 1);
    EXPECT_TRUE(has(many.err, "--fields: the run would write about ")) << many.err;
    const Call beyond = call("run " + two_node + " --fields 1e-14", scratch.path());
    EXPECT_TRUE(has(beyond.err, "below what double precision resolves")) << beyond.err;
}

// ---- pages ----------------------------------------------------------------------------------------------------------

// 1e300 W in the surface: the run ends at once, at a temperature that means nothing.
TEST(Attacked, PageOfARunThatFailedInNonsenseShowsNone) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "a.toml", "include = [\"" + two_node +
                                               "\"]\n[[source]]\nname = \"s\"\nat = \"surface\"\nwatts = \"1 W\"\n"
                                               "follows = \"1e300\"\n");
    const Call run = call("run a.toml --out o", scratch.path());
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_TRUE(has(run.out, "No valid results: temperatures reached")) << run.out;
    EXPECT_FALSE(has(run.out, "Heat budget"));
    EXPECT_FALSE(has(run.out, "nan"));
    std::istringstream lines(run.out + run.err);
    for (std::string line; std::getline(lines, line);) {
        EXPECT_LT(line.size(), 220U) << line;
        EXPECT_FALSE(std::regex_search(line, std::regex("[0-9]{9}"))) << line;
    }
}

// ---- names ----------------------------------------------------------------------------------------------------------

TEST(Attacked, ControlCharactersOfFilesReachNoTerminal) {
    const sample::Scratch scratch;
    const std::string name = "a\033[31m\nb.toml";
    fs::copy_file(two_node, scratch / "copy");
    std::string text = post::read_text(scratch / "copy");
    for (std::size_t at = text.find("\"../"); at != std::string::npos; at = text.find("\"../", at)) {
        text.replace(at, 4, "\"" + cases);
    }
    post::replace_file(scratch / name, text);
    const std::string quoted = "\"$(printf 'a\\033[31m\\nb.toml')\"";
    for (const std::string& command :
         {"check " + quoted, "run " + quoted + " --out o", "check " + quoted + "x", "new " + quoted + " --out n.toml",
          "study " + quoted, "run " + quoted + " --out " + quoted + "/x"}) {
        const Call made = call(command, scratch.path());
        EXPECT_FALSE(has(made.out + made.err, "\033")) << command << made.out << made.err;
        EXPECT_FALSE(has(made.out + made.err, "\nb.toml")) << command << made.out << made.err;
    }
}

}  // namespace tiretherm::app_test
