// SPDX-License-Identifier: BSD-3-Clause
// The folder of a call's files: all or nothing, one call at a time, links replaced, inputs and files of others left alone.

#include "post/report/output_folder.hpp"

#include <sys/stat.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "post/report/file.hpp"
#include "tests/post/scratch.hpp"

namespace tiretherm::post {
namespace {

namespace fs = std::filesystem;

/// A folder with a result of an earlier call, a file that is nobody's and an old table.
struct Earlier {
    sample::Scratch scratch;
    fs::path folder = scratch / "out";

    Earlier() {
        write("a.csv", "old a");
        write("b.csv", "old b");
        write("stale.csv", "old stale");
        write("mine.txt", "mine");
    }
    void write(const std::string& name, const std::string& text) const {
        fs::create_directories((folder / name).parent_path());
        replace_file(folder / name, text);
    }
    /// First line of a list of this folder, which has a hidden folder already.
    [[nodiscard]] std::string head() const {
        struct stat about {};
        EXPECT_EQ(stat((folder / ".tiretherm").c_str(), &about), 0);
        return fmt::format("tiretherm {}\n", about.st_ino);
    }
    [[nodiscard]] std::string text(const std::string& name) const {
        return fs::exists(folder / name) ? read_text(folder / name) : "none";
    }
    void expect_old() const {
        EXPECT_EQ(text("a.csv"), "old a");
        EXPECT_EQ(text("b.csv"), "old b");
        EXPECT_EQ(text("stale.csv"), "old stale");
        EXPECT_EQ(text("mine.txt"), "mine");
    }
    void expect_new() const {
        EXPECT_EQ(text("a.csv"), "new a");
        EXPECT_EQ(text("b.csv"), "new b");
        EXPECT_EQ(text("stale.csv"), "none");
        EXPECT_EQ(text("mine.txt"), "mine");
        EXPECT_FALSE(fs::exists(folder / ".tiretherm"));
    }
};

void fill(const OutputFolder& folder) {
    replace_file(folder.stage() / "a.csv", "new a");
    replace_file(folder.stage() / "b.csv", "new b");
}

}  // namespace

TEST(OutputFolder, NothingChangesBeforeTheEndAndNothingStaysBehind) {
    const Earlier earlier;
    {
        const OutputFolder folder(earlier.folder);
        fill(folder);
        earlier.expect_old();
    }
    earlier.expect_old();
    EXPECT_FALSE(fs::exists(earlier.folder / ".tiretherm"));
    { const OutputFolder folder(earlier.scratch / "fresh/deep"); }
    EXPECT_FALSE(fs::exists(earlier.scratch / "fresh/deep"));  // nothing came into it
}

TEST(OutputFolder, CommitReplacesRemovesWhatIsStaleAndLeavesTheRest) {
    const Earlier earlier;
    {
        OutputFolder folder(earlier.folder);
        fill(folder);
        EXPECT_EQ(folder.home(folder.stage() / "a.csv"), earlier.folder / "a.csv");
        folder.commit({"stale.csv", "b.csv", "never_was.csv"});
    }
    earlier.expect_new();
}

// Each state in which a kill can leave a commit: some of its removals and moves are done.
TEST(OutputFolder, NextCallFinishesACommitThatWasCutShort) {
    for (int done = 0; done <= 3; ++done) {
        const Earlier earlier;
        earlier.write(".tiretherm/new/a.csv", "new a");
        earlier.write(".tiretherm/new/b.csv", "new b");
        earlier.write(".tiretherm/commit", earlier.head() + "-stale.csv\n+a.csv\n+b.csv\n");
        if (done > 0) {
            fs::remove(earlier.folder / "stale.csv");
        }
        for (const char* name : {"a.csv", "b.csv"}) {
            if (done > (name[0] == 'a' ? 1 : 2)) {
                fs::rename(earlier.folder / ".tiretherm/new" / name, earlier.folder / name);
            }
        }
        { const OutputFolder folder(earlier.folder); }
        earlier.expect_new();
    }
}

TEST(OutputFolder, StageWithoutAListIsThrownAway) {
    const Earlier earlier;
    earlier.write(".tiretherm/new/a.csv", "half of a");
    { const OutputFolder folder(earlier.folder); }
    earlier.expect_old();
}

TEST(OutputFolder, AListLeadsNowhereElse) {
    const Earlier earlier;
    replace_file(earlier.scratch / "victim", "victim");
    fs::create_directories(earlier.folder / ".tiretherm/new");
    earlier.write(".tiretherm/commit", earlier.head() + "-../victim\n\nnonsense\n");
    { const OutputFolder folder(earlier.folder); }
    EXPECT_EQ(read_text(earlier.scratch / "victim"), "victim");
    earlier.expect_old();
}

// A list that came with an archive or a repository knows no number of the folder that it was unpacked to.
TEST(OutputFolder, AListThatWasNotWrittenInThisFolderIsRefused) {
    for (const std::string head : {"", "tiretherm 1\n", "tiretherm 0\n", "\n"}) {
        const Earlier earlier;
        earlier.write(".tiretherm/new/b.csv", "planted");
        earlier.write(".tiretherm/commit", head + "-mine.txt\n-a.csv\n+b.csv\n");
        try {
            const OutputFolder folder(earlier.folder);
            ADD_FAILURE() << "the list was followed";
        } catch (const OutputError& error) {
            EXPECT_NE(std::string(error.what()).find(".tiretherm/commit was not written by a call in this folder"),
                      std::string::npos)
                << error.what();
        }
        earlier.expect_old();
        EXPECT_EQ(earlier.text(".tiretherm/new/b.csv"), "planted");
    }
}

// An earlier call may have been about to replace what this one reads, a fitted case for one.
TEST(OutputFolder, AListThatNamesAnInputIsRefused) {
    const Earlier earlier;
    fs::create_directories(earlier.folder / ".tiretherm/new");
    earlier.write(".tiretherm/commit", earlier.head() + "-stale.csv\n-a.csv\n");
    EXPECT_THROW(OutputFolder(earlier.folder, {(earlier.folder / "a.csv").string()}), OutputError);
    earlier.expect_old();
}

TEST(OutputFolder, OneCallAtATime) {
    const Earlier earlier;
    {
        const OutputFolder first(earlier.folder);
        fill(first);
        try {
            const OutputFolder second(earlier.folder);
            FAIL() << "two calls in one folder";
        } catch (const OutputError& error) {
            EXPECT_EQ(error.what(), "another call of tiretherm works in " + earlier.folder.string());
        }
        EXPECT_TRUE(fs::exists(first.stage() / "a.csv"));
    }
    EXPECT_NO_THROW(const OutputFolder again(earlier.folder));
}

TEST(OutputFolder, LinkInThePlaceOfAFileIsReplacedAndAFolderThatIsALinkFollowed) {
    const Earlier earlier;
    replace_file(earlier.scratch / "elsewhere", "elsewhere");
    fs::remove(earlier.folder / "a.csv");
    fs::create_symlink(earlier.scratch / "elsewhere", earlier.folder / "a.csv");
    fs::create_directory_symlink(earlier.folder, earlier.scratch / "link");
    {
        OutputFolder folder(earlier.scratch / "link");
        fill(folder);
        folder.commit({"stale.csv"});
    }
    earlier.expect_new();
    EXPECT_FALSE(fs::is_symlink(earlier.folder / "a.csv"));
    EXPECT_EQ(read_text(earlier.scratch / "elsewhere"), "elsewhere");
    EXPECT_TRUE(fs::is_symlink(earlier.scratch / "link"));
}

TEST(OutputFolder, HiddenFolderIsNeverALink) {
    const Earlier earlier;
    fs::create_directories(earlier.scratch / "other/new");
    replace_file(earlier.scratch / "other/new/theirs", "theirs");
    fs::create_directory_symlink(earlier.scratch / "other", earlier.folder / ".tiretherm");
    EXPECT_THROW(const OutputFolder folder(earlier.folder), FileError);
    EXPECT_EQ(read_text(earlier.scratch / "other/new/theirs"), "theirs");
}

TEST(OutputFolder, InputIsNeverReplacedByWhateverPath) {
    const Earlier earlier;
    fs::create_symlink(earlier.folder / "a.csv", earlier.scratch / "log.csv");
    OutputFolder folder(earlier.folder, {(earlier.scratch / "log.csv").string()});
    const std::vector<std::string> names{"b.csv", "a.csv"};
    EXPECT_THROW(folder.refuse_inputs(names), OutputError);
    fill(folder);
    try {
        folder.commit({"stale.csv"});
        FAIL() << "the input was replaced";
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("a.csv would be replaced"), std::string::npos) << error.what();
    }
    earlier.expect_old();
    EXPECT_THROW(folder.commit({"a.csv"}), OutputError);  // nor removed
}

TEST(OutputFolder, DirectoryInThePlaceOfAFileChangesNothing) {
    const Earlier earlier;
    fs::remove(earlier.folder / "b.csv");
    fs::create_directories(earlier.folder / "b.csv/inside");
    {
        OutputFolder folder(earlier.folder);
        fill(folder);
        EXPECT_THROW(folder.commit({"stale.csv"}), FileError);
    }
    EXPECT_EQ(earlier.text("a.csv"), "old a");
    EXPECT_EQ(earlier.text("stale.csv"), "old stale");
    EXPECT_TRUE(fs::exists(earlier.folder / "b.csv/inside"));
}

TEST(OutputFolder, JournalStaysWhenWantedAndThatOfAnotherCallAlways) {
    const Earlier earlier;
    {
        OutputFolder folder(earlier.folder);
        replace_file(folder.journal("mine"), "kept");
        folder.keep_journals();
    }
    EXPECT_EQ(earlier.text(".tiretherm/mine"), "kept");
    {
        OutputFolder folder(earlier.folder);
        replace_file(folder.journal("other"), "short-lived");
    }
    EXPECT_EQ(earlier.text(".tiretherm/mine"), "kept");
    EXPECT_EQ(earlier.text(".tiretherm/other"), "none");
    EXPECT_EQ(earlier.text(".tiretherm/lock"), "none");
    {
        OutputFolder folder(earlier.folder);
        (void)folder.journal("mine");
    }
    EXPECT_FALSE(fs::exists(earlier.folder / ".tiretherm"));
}

TEST(OutputFolder, WhatCannotBeAFolderIsNamed) {
    const sample::Scratch scratch;
    replace_file(scratch / "file", "text");
    for (const fs::path& path : {scratch / "file", scratch / "file/below", fs::path("/proc/tiretherm")}) {
        try {
            const OutputFolder folder(path);
            FAIL() << path;
        } catch (const FileError& error) {
            EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
        }
    }
    EXPECT_EQ(read_text(scratch / "file"), "text");
}

TEST(File, FailedReplacementLeavesNoDraftAndFollowsNoLink) {
    const sample::Scratch scratch;
    fs::create_directories(scratch / "target/inside");
    EXPECT_THROW(replace_file(scratch / "target", "text"), FileError);
    EXPECT_FALSE(fs::exists(scratch / "target.part"));
    replace_file(scratch / "victim", "victim");
    fs::create_symlink(scratch / "victim", scratch / "table.csv.part");
    replace_file(scratch / "table.csv", "table");
    EXPECT_EQ(read_text(scratch / "victim"), "victim");
    EXPECT_EQ(read_text(scratch / "table.csv"), "table");
}

}  // namespace tiretherm::post
