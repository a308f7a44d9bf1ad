// SPDX-License-Identifier: BSD-3-Clause
// The journal of a study gives back every digit and survives lines that are cut off or damaged, other builds and a
// second process.

#include <sys/stat.h>

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "post/report/file.hpp"
#include "post/study/study_journal.hpp"
#include "tests/post/scratch.hpp"

// What survives the end of a study, however it ends.
namespace tiretherm::post {

using namespace diagnosis;  // whose results are rendered
namespace {

RunIdentity run(int i) {
    return {.fingerprint = fmt::format("{:016x}", i), .values = {fmt::format("speed = {} m/s", i)}};
}

/// Numbers that no short decimal holds.
StudyOutcome outcome(int i) {
    return {.failure = {},
            .hottest = 300.0 + i / 3.0,
            .hottest_time = i / 7.0,
            .hottest_layer = "tread",
            .hottest_zone = "crown",
            .channel_final = {i / 9.0, -1e-300},
            .channel_min = {1.0 / 3.0, 2.0},
            .channel_max = {1e17 / 3.0, 3.0},
            .energy_closure = 1e-13 / 3.0,
            .steps = 12 + i,
            .parts = {{.hottest = 310.0 + i / 11.0, .critical = 383.15}},
            .warnings = {{.law = "k of \"rubber\"", .coldest = 293.0 + i / 13.0, .hottest = 400.0}}};
}

/// Two runs, written and closed.
void write_two(const std::filesystem::path& path) {
    StudyJournal journal(path, 2, "build 1", false);
    journal.add(run(1), outcome(1));
    journal.add(run(2), StudyOutcome{.failure = "t = 3 s: it burns"});
}

}  // namespace

TEST(StudyJournal, GivesBackEveryDigit) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
    ASSERT_NE(journal.find(run(1)), nullptr);
    EXPECT_EQ(*journal.find(run(1)), outcome(1));
    ASSERT_NE(journal.find(run(2)), nullptr);
    EXPECT_EQ(journal.find(run(2))->failure, "t = 3 s: it burns");
    EXPECT_EQ(journal.find(run(3)), nullptr);
}

// Somebody's log of another program, a note, a list of runs without what ours have: nothing of them changes.
TEST(StudyJournal, FileOfSomebodyElseIsRefusedAndLeftAsItIs) {
    const sample::Scratch scratch;
    for (const std::string text :
         {"precious\n", "no end of a line", "{\"run\": 1, \"loss\": 0.5}\n{\"run\": 2, \"loss\": 0.4}\n",
          "{\"run\":\"a\",\"accuracy\":0.9}\n", "[]\n\n", "\n\xFF\xFE\n"}) {
        for (const bool fresh : {false, true}) {
            replace_file(scratch / "runs.jsonl", text);
            EXPECT_THROW(StudyJournal(scratch / "runs.jsonl", 2, "build 1", fresh), FileError) << text;
            EXPECT_EQ(read_text(scratch / "runs.jsonl"), text);
        }
    }
    for (const char* nothing : {"", "\n", "   \n\n"}) {
        replace_file(scratch / "runs.jsonl", nothing);
        EXPECT_NO_THROW(StudyJournal(scratch / "runs.jsonl", 2, "build 1", false)) << nothing;
    }
}

TEST(StudyJournal, LineThatWasCutOffIsDroppedAndTheNextOneIsWhole) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    const std::string text = read_text(scratch / "runs.jsonl");
    for (const std::size_t cut : {std::size_t{1}, std::size_t{20}, text.size() - text.find('\n') - 2}) {
        replace_file(scratch / "runs.jsonl", text.substr(0, text.size() - cut));
        {
            StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
            EXPECT_NE(journal.find(run(1)), nullptr);
            EXPECT_EQ(journal.find(run(2)), nullptr) << cut;
            journal.add(run(3), outcome(3));
        }
        const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
        EXPECT_NE(journal.find(run(1)), nullptr);
        ASSERT_NE(journal.find(run(3)), nullptr);
        EXPECT_EQ(*journal.find(run(3)), outcome(3));
    }
}

TEST(StudyJournal, DamagedLineCostsItsRunAlone) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    replace_file(scratch / "runs.jsonl", "{\"run\": 3}\nnot a line\n\n" + read_text(scratch / "runs.jsonl"));
    const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
    EXPECT_NE(journal.find(run(1)), nullptr);
    EXPECT_NE(journal.find(run(2)), nullptr);
}

// The one line of a run with another value in the place of one of its own. Each costs this run alone, is counted once, and
// is gone for the next call.
TEST(StudyJournal, ValueOfAnotherTypeOrLengthCostsItsRunAlone) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    const std::string whole = read_text(scratch / "runs.jsonl");
    const std::size_t second = whole.find('\n') + 1;
    for (const std::string key : {"run", "values", "hottest", "hottest_layer", "final", "min", "max", "steps"}) {
        for (const std::string value : {"[]", "{}", "null", "[1]", "[1,2,3]", "[[1],[2]]", "{\"a\":1,\"b\":2}"}) {
            SCOPED_TRACE(key + ": " + value);
            nlohmann::ordered_json line = nlohmann::ordered_json::parse(whole.substr(0, second));
            line[key] = nlohmann::ordered_json::parse(value);
            if (key == "values" && value == "[]") {
                continue;  // another run, rightly written
            }
            replace_file(scratch / "runs.jsonl", line.dump() + "\n" + whole.substr(second));
            {
                StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
                EXPECT_EQ(journal.find(run(1)), nullptr);
                EXPECT_NE(journal.find(run(2)), nullptr);
                EXPECT_EQ(journal.damaged(), 1U);
                journal.add(run(1), outcome(1));
            }
            const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
            EXPECT_EQ(*journal.find(run(1)), outcome(1));
            EXPECT_EQ(journal.damaged(), 0U);
        }
    }
}

// A failed run without a reason would count as one that came to its end, without any channel.
TEST(StudyJournal, FailureWithoutAReasonIsDamaged) {
    const sample::Scratch scratch;
    replace_file(scratch / "runs.jsonl", "{\"run\":\"1\",\"values\":[],\"build\":\"build 1\",\"failure\":\"\"}\n");
    const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
    EXPECT_EQ(journal.find({.fingerprint = "1", .values = {}}), nullptr);
    EXPECT_EQ(journal.damaged(), 1U);
}

TEST(StudyJournal, WhatIsNoRegularFileIsRefused) {
    const sample::Scratch scratch;
    ASSERT_EQ(mkfifo((scratch / "runs.jsonl").c_str(), 0600), 0);
    EXPECT_THROW(StudyJournal(scratch / "runs.jsonl", 2, "build 1", false), FileError);
}

TEST(StudyJournal, RunsOfAnotherBuildDoNotCount) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    const StudyJournal journal(scratch / "runs.jsonl", 2, "build 2", false);
    EXPECT_EQ(journal.find(run(1)), nullptr);
    EXPECT_EQ(journal.outdated(), 2U);
}

TEST(StudyJournal, SameFingerprintWithOtherValuesIsAnotherRun) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", false);
    RunIdentity other = run(1);
    other.values[0] = "speed = 9 m/s";
    EXPECT_EQ(journal.find(other), nullptr);
}

TEST(StudyJournal, FreshOneForgets) {
    const sample::Scratch scratch;
    write_two(scratch / "runs.jsonl");
    const StudyJournal journal(scratch / "runs.jsonl", 2, "build 1", true);
    EXPECT_EQ(journal.find(run(1)), nullptr);
    EXPECT_EQ(read_text(scratch / "runs.jsonl"), "");
}

TEST(StudyJournal, TwoAtATimeAreRefusedInOneFolder) {
    const sample::Scratch scratch;
    const StudyJournal first(scratch / "runs.jsonl", 2, "build 1", false);
    EXPECT_THROW(StudyJournal(scratch / "runs.jsonl", 2, "build 1", false), StudyJournal::Busy);
}

TEST(StudyJournal, FolderThatCannotBeWrittenIsNamed) {
    try {
        const StudyJournal journal("/proc/runs.jsonl", 2, "build 1", false);
        FAIL() << "opened";
    } catch (const FileError& error) {
        EXPECT_EQ(error.path(), "/proc/runs.jsonl");
    }
}

}  // namespace tiretherm::post
