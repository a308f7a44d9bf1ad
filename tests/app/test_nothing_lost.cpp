// SPDX-License-Identifier: BSD-3-Clause
// What a user has stays: earlier results under kills and full disks, files that a case reads, one call in a folder; Ctrl-C and
// SIGTERM end every command with a sentence.

#include <sys/mount.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/spawned.hpp"

namespace tiretherm::app_test {
namespace {

namespace fs = std::filesystem;

const std::string practice_bench = cases + "practice/two_node_bench.toml";

/// A case with two measured runs whose steps are so small that a simulation takes minutes.
void write_slow_bench(const fs::path& folder) {
    post::replace_file(folder / "bench.toml", "include = [\"" + practice_bench + "\"]\n[time]\nstep = \"0.0005 s\"\n");
}

std::string data(const fs::path& /*folder*/) {
    return " --data " + cases + "practice/run1.csv --data " + cases + "practice/run2.csv --data " + cases +
           "practice/run3.csv";
}

/// A case of its own with a measured run, its files in one folder.
void write_own_bench(const fs::path& folder, const std::string& name) {
    std::string text = post::read_text(practice_bench);
    text.replace(text.find("../tires"), 8, cases + "tires");
    text.erase(text.find("[[run]]"));
    post::replace_file(folder / name, text + "[[run]]\nfile = \"channels.csv\"\n");
    post::replace_file(folder / "channels.csv", post::read_text(cases + "practice/run1.csv"));
}

}  // namespace

// ---- earlier results ------------------------------------------------------------------------------------------------

TEST(NothingLost, EarlierRunSurvivesAKillAndAnEndThatFails) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "slow.toml", slow);
    ASSERT_EQ(call("run " + two_node + " --quiet --out o", scratch.path()).exit_code, 0);
    post::replace_file(scratch / "o/mine.txt", "mine");
    const auto before = files_of(scratch / "o");
    ASSERT_GT(before.size(), 5U);
    for (const int signal : {SIGKILL, SIGABRT}) {
        Spawned next("run slow.toml --out o", scratch.path());
        ASSERT_TRUE(next.works_in("o"));
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        next.send(signal);
        EXPECT_EQ(next.end(), -signal);
        auto after = files_of(scratch / "o");
        std::erase_if(after, [](const auto& file) { return file.first.starts_with(".tiretherm"); });
        EXPECT_EQ(after, before);
    }
    // The next call clears up.
    EXPECT_EQ(call("run " + two_node + " --quiet --out o --fresh", scratch.path()).exit_code, 0);
    EXPECT_EQ(files_of(scratch / "o"), before);
}

TEST(NothingLost, ResultsOfAnotherRunAreReplacedAsAWhole) {
    const sample::Scratch scratch;
    ASSERT_EQ(call("run " + two_node + " --quiet --fields 600 --mat --out o", scratch.path()).exit_code, 0);
    EXPECT_TRUE(fs::exists(scratch / "o/field_0006.vtu"));
    post::replace_file(scratch / "o/field_mine.vtu", "mine");
    post::replace_file(scratch / "elsewhere", "elsewhere");
    fs::remove(scratch / "o/results.h5");
    fs::create_symlink(scratch / "elsewhere", scratch / "o/results.h5");
    ASSERT_EQ(call("run " + two_node + " --quiet --out o", scratch.path()).exit_code, 0);
    ASSERT_EQ(call("run " + two_node + " --quiet --out fresh", scratch.path()).exit_code, 0);
    EXPECT_EQ(post::read_text(scratch / "elsewhere"), "elsewhere");
    EXPECT_EQ(post::read_text(scratch / "o/field_mine.vtu"), "mine");
    fs::remove(scratch / "o/field_mine.vtu");
    EXPECT_EQ(files_of(scratch / "o"), files_of(scratch / "fresh"));
}

TEST(NothingLost, OneCallAtATimeWorksInAFolder) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "slow.toml", slow);
    Spawned first("run slow.toml --out o", scratch.path());
    ASSERT_TRUE(first.works_in("o"));
    const std::string elsewhere = "another call of tiretherm works in o; nothing was ";
    const Call run = call("run " + two_node + " --out o", scratch.path());
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(
        run.err,
        "tiretherm: another call of tiretherm works in o; nothing was run; choose another directory with --out\n");
    for (const std::string& command :
         {"compare " + practice_bench + data(scratch.path()), "identify " + practice_bench + data(scratch.path()),
          "diagnose " + practice_bench + data(scratch.path()),
          "study " + cases + "studies/speed_and_load_two_node.toml"}) {
        const Call second = call(command + " --out o", scratch.path());
        EXPECT_EQ(second.exit_code, 1);
        EXPECT_TRUE(has(second.err, elsewhere)) << second.err;
    }
    first.send(SIGINT);
    EXPECT_EQ(first.end(), 130);
    EXPECT_TRUE(fs::exists(scratch / "o/results.h5"));
    EXPECT_FALSE(fs::exists(scratch / "o/.tiretherm"));
}

// ---- inputs ---------------------------------------------------------------------------------------------------------

TEST(NothingLost, NoCommandWritesOverAFileThatItsCaseReads) {
    const sample::Scratch scratch;
    write_own_bench(scratch.path(), "identified.toml");
    write_own_bench(scratch.path(), "extended.toml");
    write_own_bench(scratch.path(), "case.toml");
    fs::create_directory_symlink(scratch.path(), scratch / "link");
    const auto before = files_of(scratch.path());
    for (const std::string& folder : {std::string("."), std::string("link"), scratch.path().string()}) {
        for (const std::string command : {"identify identified.toml", "diagnose extended.toml", "run case.toml"}) {
            const Call refused = call(command + " --out " + folder, scratch.path());
            EXPECT_EQ(refused.exit_code, 1) << command;
            EXPECT_TRUE(has(refused.err, " would be replaced, and it is a file that the call reads (")) << refused.err;
            EXPECT_TRUE(has(refused.err, "choose another directory with --out")) << refused.err;
            EXPECT_EQ(files_of(scratch.path()), before) << command;
        }
    }
    // Through a link in the folder, too.
    fs::create_directories(scratch / "o");
    fs::create_symlink(scratch / "channels.csv", scratch / "o/channels.csv");
    EXPECT_EQ(call("run case.toml --out o", scratch.path()).exit_code, 1);
    EXPECT_EQ(post::read_text(scratch / "channels.csv"), post::read_text(cases + "practice/run1.csv"));
    // Where nothing is in the way, all of them work.
    EXPECT_EQ(call("identify identified.toml --out fine", scratch.path()).exit_code, 0);
}

TEST(NothingLost, LogsAndSheetsAreNoTargetsOfCases) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "drive.csv", post::read_text(cases + "practice/run1.csv"));
    fs::create_symlink("drive.csv", scratch / "link.toml");
    for (const char* target : {"drive.csv", "./drive.csv", "link.toml"}) {
        const Call refused = call(std::string("new drive.csv --force --out ") + target, scratch.path());
        EXPECT_EQ(refused.exit_code, 1);
        EXPECT_TRUE(has(refused.err, " would be replaced, and it is a file that the call reads")) << refused.err;
        EXPECT_EQ(post::read_text(scratch / "drive.csv"), post::read_text(cases + "practice/run1.csv"));
    }
}

TEST(NothingLost, EmptyNameOfAFolderIsRefused) {
    for (const std::string& command :
         {"run " + two_node, "compare " + practice_bench, "identify " + practice_bench, "diagnose " + practice_bench,
          "study " + cases + "studies/speed_and_load_two_node.toml", std::string("new '225/50 R17'")}) {
        const sample::Scratch scratch;
        const Call refused = call(command + " --out ''", scratch.path());
        EXPECT_EQ(refused.exit_code, 1) << command;
        EXPECT_TRUE(has(refused.err, "--out: it is empty; give a name or leave the option out")) << refused.err;
        EXPECT_TRUE(fs::is_empty(scratch.path())) << command;
    }
}

// ---- titles ---------------------------------------------------------------------------------------------------------

TEST(NothingLost, TitleOfSeveralLinesStaysInItsCommentAndControlsNoTerminal) {
    const sample::Scratch scratch;
    write_own_bench(scratch.path(), "case.toml");
    std::string text = post::read_text(scratch / "case.toml");
    const std::size_t title = text.find("title");
    text.replace(title, text.find('\n', title) - title, R"(title = "x\nevil = 1\n[mesh]\u001b[31m\u009b")");
    post::replace_file(scratch / "case.toml", text);
    for (const char* command : {"identify", "diagnose"}) {
        const Call made = call(std::string(command) + " case.toml --out o", scratch.path());
        ASSERT_EQ(made.exit_code, 0) << made.err;
        EXPECT_FALSE(has(made.out, "\033"));
        EXPECT_FALSE(has(made.out, "\xC2\x9B"));
    }
    const std::string fitted = post::read_text(scratch / "o/identified.toml");
    EXPECT_TRUE(fitted.starts_with("# x evil = 1 [mesh] [31m")) << fitted;
    EXPECT_EQ(call("check o/identified.toml", scratch.path()).exit_code, 0);
    std::string run = post::read_text(scratch / "case.toml");
    EXPECT_FALSE(has(call("compare case.toml --out c", scratch.path()).out, "\033"));
    EXPECT_FALSE(has(call("check case.toml", scratch.path()).out, "\033"));
}

// ---- signals --------------------------------------------------------------------------------------------------------

TEST(Stopped, EveryCommandThatSimulatesEndsWithASentence) {
    const sample::Scratch scratch;
    write_slow_bench(scratch.path());
    post::replace_file(scratch / "slow.toml", slow);
    post::replace_file(scratch / "study.toml",
                       "case = \"slow.toml\"\n[[vary]]\nkey = \"drive.speed\"\nvalues = [\"60 km/h\", \"90 km/h\"]\n");
    struct Stopped {
        std::string command;
        std::string sentence;
    };
    const std::vector<Stopped> all{
        {"run slow.toml", "tiretherm: stopped at t = "},
        {"compare bench.toml" + data({}), "stopped at t = "},
        {"identify bench.toml" + data({}), "tiretherm: stopped during the fit; nothing was fitted"},
        {"diagnose bench.toml" + data({}), "tiretherm: stopped during the first simulation; nothing was diagnosed"},
        {"study study.toml", "tiretherm: stopped; 0 of 2 runs are kept in o"}};
    for (const Stopped& stopped : all) {
        for (const int signal : {SIGINT, SIGTERM}) {
            SCOPED_TRACE(stopped.command);
            fs::remove_all(scratch / "o");
            Spawned call(stopped.command + " --out o", scratch.path());
            ASSERT_TRUE(call.works_in("o")) << call.err();
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            call.send(signal);
            EXPECT_EQ(call.end(), 130);
            EXPECT_TRUE(has(call.err(), stopped.sentence)) << call.err();
            EXPECT_FALSE(fs::exists(scratch / "o/.tiretherm"));
            EXPECT_EQ(fs::exists(scratch / "o/results.h5"), stopped.command.starts_with("run"));
        }
    }
}

TEST(Stopped, JsonSaysItInItsObject) {
    const sample::Scratch scratch;
    write_slow_bench(scratch.path());
    Spawned stopped("identify bench.toml --json --out o" + data({}), scratch.path());
    ASSERT_TRUE(stopped.works_in("o"));
    stopped.send(SIGTERM);
    EXPECT_EQ(stopped.end(), 130);
    EXPECT_TRUE(has(nlohmann::json::parse(stopped.out())["error"].get<std::string>(), "stopped during the fit"));
    EXPECT_EQ(stopped.err(), "");
}

// Commands that are quick, or have not begun with their runs, are hit between a signal that was too early and one that was too late.
TEST(Stopped, NewValidateAndAStudyBeforeItsRunsEndWithASentence) {
    const sample::Scratch scratch;
    post::replace_file(scratch / "study.toml", "case = \"" + two_node +
                                                   "\"\n[[vary]]\nkey = \"drive.speed\"\nfrom = \"60 km/h\"\nto = "
                                                   "\"120 km/h\"\ncount = 3000\n");
    struct Stopped {
        std::string command;
        std::string sentence;
    };
    for (const Stopped& stopped :
         {Stopped{"new " + cases + "practice/run1.csv --out o/new.toml", "tiretherm: stopped; no case was written\n"},
          Stopped{"validate " + cases + "validation.toml", "tiretherm: stopped; there is no table\n"},
          Stopped{"study study.toml --out o", "tiretherm: stopped; nothing was run\n"}}) {
        SCOPED_TRACE(stopped.command);
        bool heard = false;
        double early = 0.0;  // ms: a signal by then was too early for the sentence, at `late` too late
        double late = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 100 && !heard; ++i) {
            fs::remove_all(scratch / "o");
            const double wait = std::isfinite(late) ? 0.5 * (early + late) : std::max(1.0, 2.0 * early);
            Spawned call(stopped.command, scratch.path());
            std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(wait));
            call.send(SIGTERM);
            const int end = call.end();
            ASSERT_TRUE(end == 130 || end == 0 || end == -SIGTERM) << end;
            if (end == 130) {
                heard = call.err() == stopped.sentence;
                EXPECT_TRUE(has(call.err(), "tiretherm: stopped")) << call.err();
                EXPECT_FALSE(heard && fs::exists(scratch / "o")) << "something was written";
            }
            // With runs that are done it was too late as well.
            (end == -SIGTERM || has(call.err(), "while reading") ? early : late) = wait;
            if (late - early < 0.5) {  // no run is as fast as another
                early *= 0.7;
                late *= 1.3;
            }
        }
        EXPECT_TRUE(heard);
    }
}

// Reading 1 500 000 lines takes longer than a signal to a program that hears it: the first one ends the call, and there is no case.
TEST(Stopped, NewHearsTheFirstSignalWhileItReads) {
    const sample::Scratch scratch;
    std::string log = "time [s],speed [km/h],vertical_load [N],surface_temperature [degC],air_temperature [degC]\n";
    for (int i = 0; i < 1'500'000; ++i) {
        log += fmt::format("{:.2f},{},4000,{},20\n", 0.01 * i, 100 + i % 7, 40 + i % 5);
    }
    post::replace_file(scratch / "log.csv", log);
    Spawned call("new log.csv --out case.toml", scratch.path());
    ASSERT_TRUE(call.hears(SIGINT));
    call.send(SIGINT);
    EXPECT_EQ(call.end(), 130) << call.err();
    EXPECT_EQ(call.err(),
              "tiretherm: stopped while reading log.csv and the files that it names; nothing was written\n");
    EXPECT_FALSE(fs::exists(scratch / "case.toml"));
}

// ---- full disk ------------------------------------------------------------------------------------------------------

// The journal of a diagnosis takes at most half of what is free: of 3.5 MB it leaves more than the 1.6 MB of the files. Where
// they do not fit either, what was simulated is kept for the call that finds room.
TEST(NothingLost, ADiagnosisOnANearlyFullDiskLosesNeitherAnswerNorJournal) {
    const sample::Scratch scratch;
    const fs::path disk = scratch / "disk";
    fs::create_directories(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=16M") != 0) {
        GTEST_SKIP() << "a small disk cannot be mounted here: that needs root";
    }
    const std::string command = "diagnose " + practice_bench + data({}) + " --no-by-run --quiet --out disk/o";
    const auto leave = [&](std::size_t kilobytes) {
        fs::remove_all(disk / "o");
        fs::remove(disk / "fill");
        post::replace_file(disk / "fill", std::string(fs::space(disk).available - kilobytes * 1024, 'x'));
    };
    leave(3500);
    Spawned with_room(command, scratch.path(), "0");
    EXPECT_EQ(with_room.end(), 0) << with_room.err();
    EXPECT_TRUE(fs::exists(disk / "o/diagnosis.json"));
    EXPECT_FALSE(fs::exists(disk / "o/.tiretherm"));
    leave(900);
    Spawned without(command, scratch.path(), "0");
    EXPECT_EQ(without.end(), 1);
    EXPECT_TRUE(has(without.err(), "make room: the same call goes on from what is kept")) << without.err();
    EXPECT_TRUE(has(without.err(), "the disk is nearly full: not all simulations were kept")) << without.err();
    fs::remove(disk / "fill");
    Spawned next(command, scratch.path(), "0");
    EXPECT_EQ(next.end(), 0) << next.err();
    EXPECT_TRUE(has(next.err(), "an interrupted call is continued: ")) << next.err();
    umount(disk.c_str());
}

TEST(NothingLost, FullDiskIsASentenceAndCostsNothing) {
    const sample::Scratch scratch;
    const fs::path disk = scratch / "disk";
    fs::create_directories(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=1M") != 0) {
        GTEST_SKIP() << "a small disk cannot be mounted here: that needs root";
    }
    const auto begin = [&] {
        fs::remove(disk / "fill");
        fs::remove_all(disk / "o");
        EXPECT_EQ(call("run " + two_node + " --quiet --no-report --out disk/o", scratch.path()).exit_code, 0);
        return files_of(disk / "o");
    };
    const auto before = begin();
    int failed = 0;
    for (std::size_t free = 0; free <= 400 * 1024; free += 20 * 1024) {
        for (const std::string& command :
             {"run " + two_node + " --no-report --fields 300", "compare --no-report " + practice_bench + data({})}) {
            SCOPED_TRACE(fmt::format("{} B free: {}", free, command));
            fs::remove(disk / "fill");
            const std::size_t room = fs::space(disk).available;
            ASSERT_GT(room, free);
            post::replace_file(disk / "fill", std::string(room - free, 'x'));
            const Call full = call(command + " --out disk/o", scratch.path());
            if (full.exit_code == 0) {
                EXPECT_EQ(begin(), before);
                continue;
            }
            ++failed;
            EXPECT_EQ(full.exit_code, 1);
            EXPECT_TRUE(has(full.err, "No space left on device")) << full.err;
            EXPECT_EQ(files_of(disk / "o"), before);
        }
    }
    EXPECT_GT(failed, 10);
    umount(disk.c_str());
}

}  // namespace tiretherm::app_test
