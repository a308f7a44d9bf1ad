// SPDX-License-Identifier: BSD-3-Clause
// `tiretherm study`: runs, files and journal; an interrupted study ends with the same files, for any number of threads.

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/program.hpp"
#include "tests/app/spawned.hpp"

namespace tiretherm::app_test {
namespace {

using Json = nlohmann::json;

const std::string studies = TIRETHERM_SOURCE_DIR "/cases/studies/";

/// Three speeds by two loads of the two-node tire.
const std::string six = "title = \"Six\"\ncase = \"" + two_node + R"("
critical = "60 degC"
[[vary]]
key = "drive.speed"
values = ["60 km/h", "90 km/h", "120 km/h"]
[[vary]]
key = "drive.vertical_load"
values = ["3000 N", "4000 N"]
)";

/// A few dozen runs of some hundredths of a second each, so that the study can be interrupted in the middle.
const std::string many = "case = \"" + two_node + R"("
[[vary]]
key = "drive.speed"
from = "60 km/h"
to = "120 km/h"
count = 40
[[vary]]
key = "time.step"
values = ["0.25 s"]
)";

/// Lines of a file; 0 where there is none.
std::ptrdiff_t lines(const std::filesystem::path& path) {
    std::error_code error;
    const std::string text = std::filesystem::exists(path, error) ? post::read_text(path) : "";
    return std::count(text.begin(), text.end(), '\n');
}

/// Begins a study and ends it by a signal when three of its runs are done. @returns the status of its process
int interrupt(const std::filesystem::path& folder, int signal) {
    const std::string study = (folder / "study.toml").string();
    const std::string out = (folder / "out").string();
    const pid_t child = fork();
    if (child == 0) {
        const int null = open("/dev/null", O_RDWR);
        dup2(null, STDOUT_FILENO);
        dup2(open((folder / "err").c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
        execl(TIRETHERM_PROGRAM, "tiretherm", "study", study.c_str(), "--threads", "2", "--out", out.c_str(), nullptr);
        _exit(99);
    }
    for (int i = 0; i < 6000 && lines(folder / "out/runs.jsonl") < 3; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

}  // namespace

// 67.6 degC is what `tiretherm run` gives for the case alone with 120 km/h in its [drive], printed to 0.1 K.
TEST(Study, MakesAllRunsAndLeavesTheFilesThatItNames) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    const Call study = call("study study.toml --json --out results", scratch.path());
    EXPECT_EQ(study.exit_code, 0);
    EXPECT_EQ(study.err, "");
    const Json json = Json::parse(study.out);
    EXPECT_EQ(json["runs"], 6);
    EXPECT_EQ(json["made"], 6);
    EXPECT_EQ(json["hottest"]["values"]["drive.speed"], "120 km/h");
    EXPECT_EQ(json["hottest"]["values"]["drive.vertical_load"], "4000 N");
    EXPECT_NEAR(json["hottest"]["temperature"].get<double>(), 67.6, 0.06);
    EXPECT_EQ(json["outputs"].size(), 5U);
    for (const std::string file : json["outputs"]) {
        EXPECT_GT(std::filesystem::file_size(scratch.path() / file), 100U) << file;
    }
    EXPECT_EQ(lines(scratch / "results/study.csv"), 7);
}

TEST(Study, ShippedSectionStudyFindsItsHotSpotInTheShoulder) {
    // The two corners of the shipped grid; 35 runs would take too long here. What this program gives, printed to 0.1 K: a
    // change must be meant.
    const sample::Scratch scratch;
    std::string text = post::read_text(studies + "hot_spot_speed_and_load.toml");
    text.replace(text.find("\"../section") + 1, 10, TIRETHERM_SOURCE_DIR "/cases/section");
    text.replace(text.find("count = 7"), 9, "count = 2");
    text.replace(text.find("count = 5"), 9, "count = 2");
    post::replace_file(scratch / "study.toml", text);
    const Json json = Json::parse(call("study study.toml --json --out o", scratch.path()).out);
    EXPECT_EQ(json["runs"], 4);
    EXPECT_NEAR(json["hottest"]["temperature"].get<double>(), 109.1, 0.06);
    EXPECT_EQ(json["hottest"]["zone"], "outside_shoulder");
    EXPECT_NEAR(json["coldest"]["temperature"].get<double>(), 43.5, 0.06);
}

TEST(Study, ShippedSamplesAreTheSameEverywhere) {
    // 300 runs of two nodes. What this program gives, to 0.1 K: the draws follow from the seed alone.
    const sample::Scratch scratch;
    const Call study = call("study --json --out o " + studies + "uncertain_two_node.toml", scratch.path());
    EXPECT_EQ(study.exit_code, 0);
    const Json points = Json::parse(study.out)["points"];
    ASSERT_EQ(points.size(), 3U);
    EXPECT_NEAR(points[1]["hottest"]["median"].get<double>(), 81.0, 0.06);
    EXPECT_NEAR(points[2]["hottest"]["p95"].get<double>(), 90.1, 0.06);
    EXPECT_EQ(points[2]["passes_critical"]["of"], 100);
}

TEST(Study, SecondCallMakesOnlyWhatIsNewOrChanged) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    call("study study.toml --quiet --out o", scratch.path());
    const std::string csv = post::read_text(scratch / "o/study.csv");
    EXPECT_EQ(Json::parse(call("study study.toml --json --out o", scratch.path()).out)["kept"], 6);
    EXPECT_EQ(post::read_text(scratch / "o/study.csv"), csv);
    EXPECT_EQ(Json::parse(call("study study.toml --json --fresh --out o", scratch.path()).out)["kept"], 0);
    std::string more = "# another remark\n" + six;
    more.replace(more.find("\"4000 N\""), 8, "\"4000 N\", \"5000 N\"");
    post::replace_file(scratch / "study.toml", more);
    const Json grown = Json::parse(call("study study.toml --json --out o", scratch.path()).out);
    EXPECT_EQ(grown["kept"], 6);
    EXPECT_EQ(grown["made"], 3);
}

TEST(Study, FilesAreTheSameForAnyNumberOfThreads) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    call("study study.toml --quiet --threads 1 --out one", scratch.path());
    call("study study.toml --quiet --threads 3 --out three", scratch.path());
    for (const char* file : {"study.csv", "study.h5"}) {
        EXPECT_EQ(post::read_text(scratch / "one" / file), post::read_text(scratch / "three" / file)) << file;
    }
}

TEST(Study, KilledInTheMiddleGoesOnToTheSameFiles) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", many);
    EXPECT_TRUE(WIFSIGNALED(interrupt(scratch.path(), SIGKILL)));
    const std::ptrdiff_t done = lines(scratch / "out/runs.jsonl");
    ASSERT_GE(done, 3);
    ASSERT_LT(done, 40);
    EXPECT_FALSE(std::filesystem::exists(scratch / "out/study.csv"));
    const Json json = Json::parse(call("study study.toml --json --out out", scratch.path()).out);
    EXPECT_EQ(json["kept"], done);
    EXPECT_EQ(json["made"], 40 - done);
    call("study study.toml --quiet --out whole", scratch.path());
    for (const char* file : {"study.csv", "study.h5"}) {
        EXPECT_EQ(post::read_text(scratch / "out" / file), post::read_text(scratch / "whole" / file)) << file;
    }
}

TEST(Study, CtrlCKeepsWhatIsDoneAndSaysHowToGoOn) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", many);
    std::filesystem::create_directories(scratch / "out");
    post::replace_file(scratch / "out/study.csv", "of another study\n");
    const int status = interrupt(scratch.path(), SIGINT);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_EQ(post::read_text(scratch / "out/study.csv"), "of another study\n");  // until the new one is whole
    const std::string err = post::read_text(scratch / "err");
    EXPECT_NE(
        err.find(fmt::format("tiretherm: stopped; {} of 40 runs are kept in ", lines(scratch / "out/runs.jsonl"))),
        std::string::npos)
        << err;
    EXPECT_NE(err.find("the same call goes on from there"), std::string::npos) << err;
}

TEST(Study, RunThatFailsIsARowAndTheOthersStand) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "burning.toml", exploding);
    post::replace_file(scratch / "study.toml",
                       "case = \"burning.toml\"\n[[vary]]\nkey = \"effects.uniform_source.power_density\"\n"
                       "values = [\"1e3 W/m3\", \"1e12 W/m3\", \"2e3 W/m3\"]\n");
    const Call failed = call("study study.toml --out o", scratch.path());
    EXPECT_EQ(failed.exit_code, 2);
    EXPECT_NE(failed.err.find("1 of 3 runs failed, the first is run 2: "), std::string::npos) << failed.err;
    const std::string csv = post::read_text(scratch / "o/study.csv");
    EXPECT_NE(csv.find("\n3,2000,ok,"), std::string::npos) << csv;
    const Call json = call("study study.toml --json --out o", scratch.path());
    EXPECT_EQ(json.exit_code, 2);
    const Json found = Json::parse(json.out);
    EXPECT_EQ(found["runs"], 3);
    ASSERT_EQ(found["failed"].size(), 1U);
    EXPECT_EQ(found["failed"][0]["run"], 2);
}

TEST(Study, QuantityThatNothingLooksAtIsToldOf) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", "case = \"" + two_node +
                                                   "\"\n[[vary]]\nkey = \"drive.camber\"\n"
                                                   "values = [\"0 deg\", \"3 deg\"]\n");
    const Call study = call("study study.toml --out o", scratch.path());
    EXPECT_EQ(study.exit_code, 0);
    EXPECT_NE(study.out.find("\"drive.camber\" changed nothing"), std::string::npos) << study.out;
}

TEST(Study, ErrorsOfStudyAndCaseAreReportedAtOnceAndNothingIsWritten) {
    const sample::Scratch scratch;
    const std::string bad = TIRETHERM_SOURCE_DIR "/tests/bad_cases/study/many_errors.toml";
    const Call text = call("study " + bad, scratch.path());
    EXPECT_EQ(text.exit_code, 1);
    EXPECT_EQ(text.out, "");
    EXPECT_TRUE(text.err.ends_with("7 errors; nothing was run\n")) << text.err;
    const Json json = Json::parse(call("study --json " + bad, scratch.path()).out);
    EXPECT_EQ(json["errors"].size(), 7U);
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

TEST(Study, QuietSaysNothingAndUnwritableFolderIsNamed) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    const Call quiet = call("study study.toml --quiet", scratch.path());
    EXPECT_EQ(quiet.out + quiet.err, "");
    EXPECT_TRUE(std::filesystem::exists(scratch / "out/study/study.csv"));
    const Call wrong = call("study study.toml --out study.toml/results", scratch.path());
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_EQ(
        wrong.err,
        "tiretherm: cannot create the directory study.toml/results: Not a directory; nothing was run; choose another "
        "directory with --out\n");
}

/// Bytes of the files of a study that follow from its runs.
std::vector<std::string> tables_of(const std::filesystem::path& out) {
    std::vector<std::string> texts;
    for (const char* name : {"study.csv", "study.h5"}) {
        texts.push_back(post::read_text(out / name));
    }
    return texts;
}

TEST(StudyParts, PutTogetherAreTheBytesOfOneCall) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    ASSERT_EQ(call("study study.toml --quiet --threads 1 --out whole", scratch.path()).exit_code, 0);
    for (const char* part : {"3/4", "1/4", "4/4", "2/4"}) {
        const Call made = call(fmt::format("study study.toml --json --out parts --part {}", part), scratch.path());
        ASSERT_EQ(made.exit_code, 0) << made.err;
        const Json json = Json::parse(made.out);
        EXPECT_EQ(json["runs"], std::string(part) < "3/4" ? 2 : 1);  // six runs over four parts
        EXPECT_EQ(json["made"], json["runs"]);
    }
    const Call merged = call("study study.toml --json --out parts --merge", scratch.path());
    ASSERT_EQ(merged.exit_code, 0) << merged.err;
    EXPECT_EQ(Json::parse(merged.out)["made"], 0);
    EXPECT_EQ(tables_of(scratch / "parts"), tables_of(scratch / "whole"));
    EXPECT_EQ(post::read_text(scratch / "parts/runs.jsonl"), post::read_text(scratch / "whole/runs.jsonl"));
}

TEST(StudyParts, ThatAreMissingAreToldByNameAndNothingIsWritten) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    ASSERT_EQ(call("study study.toml --quiet --out parts --part 1/3", scratch.path()).exit_code, 0);
    const Call merged = call("study study.toml --out parts --merge", scratch.path());
    EXPECT_EQ(merged.exit_code, 1);
    EXPECT_EQ(
        merged.err,
        "tiretherm: part 2/3: 2 of 2 runs are missing; --part 2/3 makes them\n"
        "tiretherm: part 3/3: 2 of 2 runs are missing; --part 3/3 makes them; nothing was written; what the parts have "
        "is kept\n");
    EXPECT_FALSE(std::filesystem::exists(scratch / "parts/study.csv"));
    const Call none = call("study study.toml --out nothing --merge", scratch.path());
    EXPECT_EQ(none.exit_code, 1);
    EXPECT_NE(none.err.find("holds no part of the study"), std::string::npos) << none.err;
}

TEST(StudyParts, OfAnotherStateOfTheCaseAreToldAndLeftOut) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    for (const char* part : {"1/2", "2/2"}) {
        ASSERT_EQ(call(fmt::format("study study.toml --quiet --out parts --part {}", part), scratch.path()).exit_code,
                  0);
    }
    std::string changed = six;
    changed.replace(changed.find("3000 N"), 6, "3500 N");
    post::replace_file(scratch / "study.toml", changed);
    const Call merged = call("study study.toml --out parts --merge", scratch.path());
    EXPECT_EQ(merged.exit_code, 1);
    EXPECT_NE(merged.err.find("part 1/2: none of its runs is of this study"), std::string::npos) << merged.err;
    EXPECT_NE(merged.err.find("part 1/2: 3 of 3 runs are missing"), std::string::npos) << merged.err;
}

TEST(StudyParts, KilledAtAnyMomentGoOnAndLoseNothing) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", many);
    const std::filesystem::path journal = scratch / "parts/part_1_of_2/runs.jsonl";
    std::ptrdiff_t before = 0;
    for (int kills = 0; kills < 3; ++kills) {
        Spawned part("study study.toml --out parts --part 1/2 --threads 1", scratch.path());
        for (int i = 0; i < 4000 && lines(journal) < before + 2; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        part.send(SIGKILL);
        part.wait();
        const std::ptrdiff_t now = lines(journal);
        EXPECT_GE(now, before + 2);
        before = now;
    }
    const Call rest = call("study study.toml --json --out parts --part 1/2", scratch.path());
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(Json::parse(rest.out)["runs"], 20);
    EXPECT_GE(Json::parse(rest.out)["kept"].get<std::ptrdiff_t>(), before - 1);  // the last line may have been cut off
    ASSERT_EQ(call("study study.toml --quiet --out parts --part 2/2", scratch.path()).exit_code, 0);
    ASSERT_EQ(call("study study.toml --quiet --out parts --merge", scratch.path()).exit_code, 0);
    ASSERT_EQ(call("study study.toml --quiet --out whole", scratch.path()).exit_code, 0);
    EXPECT_EQ(tables_of(scratch / "parts"), tables_of(scratch / "whole"));
}

TEST(StudyParts, WhatIsNoPartIsRefused) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", six);
    for (const char* part : {"0/4", "5/4", "x/y", "3", "03/4", "1/", "-1/4", "1/4/2", "1/1000000"}) {
        const Call refused = call(fmt::format("study study.toml --out parts --part {}", part), scratch.path());
        EXPECT_EQ(refused.exit_code, 1) << part;
        EXPECT_NE(refused.err.find("is no part; write 3/16 for the third of sixteen"), std::string::npos)
            << refused.err;
    }
    EXPECT_EQ(call("study study.toml --out parts --part 1/2 --merge", scratch.path()).exit_code, 1);
    EXPECT_FALSE(std::filesystem::exists(scratch / "parts"));
}

}  // namespace tiretherm::app_test
