// SPDX-License-Identifier: BSD-3-Clause
// run, identify, diagnose and study killed by SIGKILL at random moments: the same call goes on and ends with the files of a
// call that nobody killed, byte by byte.

#include <random>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/app/spawned.hpp"

namespace tiretherm::app_test {
namespace {

/// A run of some seconds with sensors that lag, fields, hot spots and steps that the error chooses.
std::string long_run() {
    return "include = [\"" + cases + R"(section/4000N_100kmh.toml"]
[time]
end = "3600 s"
tolerance = "1e-6 K"
output = "5 s"
fields = "600 s"
[[critical]]
name = "belt edge"
layers = ["belt"]
temperature = "110 degC"
)";
}

std::string study_of(int runs) {
    return fmt::format(
        "case = \"{}two_node/4000N_100kmh.toml\"\n[[vary]]\nkey = \"drive.speed\"\nfrom = \"60 km/h\"\nto = "
        "\"120 km/h\"\ncount = {}\n[[vary]]\nkey = \"time.step\"\nvalues = [\"0.25 s\"]\n",
        cases, runs);
}

std::string data_option(const std::string& name) {
    const std::string file = cases + "practice/" + name;
    return " --data " + file + "1.csv --data " + file + "2.csv --data " + file + "3.csv";
}

/// A command to be killed and the call of it.
struct Killed {
    std::string name;
    std::string arguments;
};

std::vector<Killed> commands() {
    return {{"run", "run run.toml --out o"},
            {"identify", "identify " + cases + "practice/two_node_bench.toml --out o" + data_option("run")},
            {"diagnose", "diagnose " + cases + "practice/two_node_bench.toml --out o" + data_option("puzzle")},
            {"study", "study study.toml --threads 2 --out o"}};
}

void write_cases(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    post::replace_file(folder / "run.toml", long_run());
    post::replace_file(folder / "study.toml", study_of(40));
}

std::map<std::string, std::string> result(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files = files_of(folder);
    if (files.contains("runs.jsonl")) {
        files["runs.jsonl"] = sorted_lines(files["runs.jsonl"]);
    }
    return files;
}

/// Kills a call again and again until `kills` have hit it, lets it end, and compares its files; begins anew whenever it
/// was faster than its killer.
/// @returns how many of the calls after a kill went on with what was kept
int kill_and_compare(const Killed& command, int kills, unsigned seed) {
    const sample::Scratch scratch;
    write_cases(scratch / "whole");
    write_cases(scratch / "killed");
    Spawned whole(command.arguments, scratch / "whole");
    EXPECT_EQ(whole.end(), 0) << whole.err();
    const double seconds = whole.seconds();
    const auto expected = result(scratch / "whole/o");
    EXPECT_FALSE(expected.empty());
    EXPECT_FALSE(expected.contains(".tiretherm/lock"));
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> moment(0.0, 0.8 * seconds);
    int went_on = 0;
    const auto compare = [&] {
        const auto found = result(scratch / "killed/o");
        EXPECT_EQ(found.size(), expected.size());
        for (const auto& [name, bytes] : expected) {
            EXPECT_TRUE(found.contains(name) && found.at(name) == bytes) << command.name << ": " << name << " differs";
        }
    };
    const auto count = [&](const Spawned& call) {
        went_on += call.err().find("an interrupted call is continued") != std::string::npos ? 1 : 0;
    };
    for (int hit = 0; hit < kills;) {
        Spawned call(command.arguments, scratch / "killed", "0");
        std::this_thread::sleep_for(std::chrono::duration<double>(moment(engine)));
        call.send(SIGKILL);
        const int end = call.end();
        count(call);
        if (end == -SIGKILL) {
            ++hit;
        } else {
            EXPECT_EQ(end, 0) << call.err();
            compare();
            std::filesystem::remove_all(scratch / "killed/o");
        }
        if (::testing::Test::HasFailure()) {
            return went_on;
        }
    }
    Spawned last(command.arguments, scratch / "killed", "0");
    EXPECT_EQ(last.end(), 0) << last.err();
    count(last);
    compare();
    return went_on;
}

}  // namespace

// Two kills in a row of a run; one of each other command.
TEST(Resume, KilledCallsGoOnToTheSameBytes) {
    for (const Killed& command : commands()) {
        SCOPED_TRACE(command.name);
        kill_and_compare(command, command.name == "run" ? 2 : 1, 20240517);
    }
}

// A hundred in all. Most of the calls that follow a kill must find something to go on with, or this would test nothing.
TEST(ResumeLong, AHundredKillsLeaveTheSameBytes) {
    for (const Killed& command : commands()) {
        SCOPED_TRACE(command.name);
        const int went_on = kill_and_compare(command, 25, 7);
        if (command.name != "study") {  // which tells of its runs on the page
            EXPECT_GE(went_on, 10);
        }
        RecordProperty(command.name + "_went_on", went_on);
    }
}

TEST(Resume, RunGoesOnWhereItWasAndSaysSo) {
    const sample::Scratch scratch;
    write_cases(scratch.path());
    {
        Spawned call("run run.toml --out o", scratch.path(), "0");
        for (int i = 0; i < 6000 && !std::filesystem::exists(scratch / "o/.tiretherm/run.state"); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        call.send(SIGKILL);
        ASSERT_EQ(call.end(), -SIGKILL);
    }
    const Call other = call("run run.toml --quiet --no-vtk --out other", scratch.path());
    EXPECT_EQ(other.err, "");
    const Call next = call("run run.toml --quiet --out o", scratch.path());
    EXPECT_EQ(next.exit_code, 0);
    EXPECT_TRUE(next.err.starts_with("tiretherm: an interrupted call is continued: ")) << next.err;
    EXPECT_TRUE(next.err.ends_with(" s of 3600 s are kept\n")) << next.err;
    EXPECT_FALSE(std::filesystem::exists(scratch / "o/.tiretherm"));
    EXPECT_EQ(call("run run.toml --quiet --out o", scratch.path()).err, "");  // over: the next one begins anew
}

// What was kept counts only for the same call: another option, another case, and --fresh begin anew.
TEST(Resume, WhatIsKeptCountsForTheSameCallAlone) {
    const sample::Scratch scratch;
    write_cases(scratch.path());
    for (const char* change : {"--fresh", "--fields 900", "case"}) {
        SCOPED_TRACE(change);
        std::filesystem::remove_all(scratch / "o");
        {
            Spawned call("run run.toml --out o", scratch.path(), "0");
            for (int i = 0; i < 6000 && !std::filesystem::exists(scratch / "o/.tiretherm/run.state"); ++i) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
            }
            call.send(SIGKILL);
            ASSERT_EQ(call.end(), -SIGKILL);
        }
        const bool other_case = std::string(change) == "case";
        if (other_case) {
            post::replace_file(scratch / "run.toml", long_run() + "# another remark\n");
        }
        const Call next =
            call(fmt::format("run run.toml --quiet --out o {}", other_case ? "" : change), scratch.path());
        EXPECT_EQ(next.exit_code, 0);
        EXPECT_EQ(next.err, "");
        EXPECT_FALSE(std::filesystem::exists(scratch / "o/.tiretherm"));
    }
}

// Each call is cut short as soon as it has kept something more; none begins anew before there is an answer.
TEST(Resume, ADiagnosisGoesOnAfterEveryTimeLimit) {
    const sample::Scratch scratch;
    const std::string folder = TIRETHERM_SOURCE_DIR "/cases/practice/";
    const std::string command = fmt::format(
        "diagnose {0}section_bench.toml --data {0}section_run1.csv --no-by-run --quiet --out o --time-limit ", folder);
    int limit = 4;
    bool kept = false;
    for (int i = 0; i < 5; ++i) {
        Spawned call(command + std::to_string(limit), scratch.path(), "0");
        const int end = call.end();
        EXPECT_EQ(call.err().find("an interrupted call is continued: ") != std::string::npos, kept) << call.err();
        // New ones or, on a slow machine, none.
        kept = call.err().find(" kept in o, ") != std::string::npos;
        EXPECT_TRUE(end == 0 || end == 2) << call.err();
        EXPECT_EQ(std::filesystem::exists(scratch / "o/.tiretherm/diagnose.simulations"), kept);
        EXPECT_EQ(call.out(), "");
        if (end == 0) {
            return;  // a quick machine
        }
        limit *= kept ? 1 : 4;  // a machine on which a simulation takes longer
    }
    EXPECT_TRUE(kept);
}

// A time that does not fit into a clock of 64 bits is as good as none; one of a moment is no signal: not 130.
TEST(Resume, TimeLimitsThatAreLongOrShortAreNoSignals) {
    const sample::Scratch scratch;
    const std::string folder = TIRETHERM_SOURCE_DIR "/cases/practice/";
    const std::string command = fmt::format(
        "diagnose {0}two_node_bench.toml --data {0}puzzle1.csv --no-by-run --quiet --out o --time-limit ", folder);
    for (const char* limit : {"1e10", "1e18", "1e300"}) {
        const Call whole = call(command + limit, scratch.path());
        EXPECT_EQ(whole.exit_code, 0) << limit << whole.err;
        EXPECT_EQ(whole.out + whole.err, "");
    }
    const Call cut = call(command + "1e-6", scratch.path());
    EXPECT_EQ(cut.exit_code, 2);
    EXPECT_TRUE(cut.err.starts_with("tiretherm: the time limit has passed")) << cut.err;
}

}  // namespace tiretherm::app_test
