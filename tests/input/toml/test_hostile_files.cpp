// SPDX-License-Identifier: BSD-3-Clause
// Files that a reader must not follow to their end: too deep, too many within each other, pipes, devices, too large.

#include <chrono>
#include <fstream>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "input/measurements/measured_bench.hpp"
#include "input/toml/document.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// What a user reads of a case, with paths as seen from its folder.
std::string said_of(const Written& written, const std::string& name) {
    InputErrors errors;
    const std::optional<TomlValue> node = read_document(written.folder() / name, errors);
    std::string text;
    for (const InputError& error : errors.in_order()) {
        text += render(error);
    }
    return replaced(node ? "sound: " + text : text, written.folder().generic_string() + "/", "");
}

std::string repeated(const std::string& piece, int times) {
    std::string text;
    text.reserve(piece.size() * static_cast<std::size_t>(times));
    for (int i = 0; i < times; ++i) {
        text += piece;
    }
    return text;
}

double seconds_of(const std::function<void()>& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

// A table within a table for each dot: a million of them do not fit onto a stack of 8 MB.
TEST(HostileToml, AKeyOfAMillionPartsIsRefusedWithItsPlace) {
    const Written written;
    written.add("key.toml", "title = \"x\"\n" + repeated("a.", 1'000'000) + "a = 1\n");
    const std::string said = said_of(written, "key.toml");
    EXPECT_TRUE(said.starts_with("key.toml:2:1: keys and values stand more than 64 deep within each other\n"))
        << said.substr(0, 200);
    EXPECT_NE(said.find("remedy: no key of a case has more than a few parts"), std::string::npos);
    written.add("heading.toml", "[" + repeated("a . \"b\".", 150'000) + "a]\nx = 1\n");
    EXPECT_TRUE(said_of(written, "heading.toml").starts_with("heading.toml:1:2: keys and values stand more than 64"));
}

// Parts of keys and brackets add up: 5 times (1 + 12) levels and one for the innermost key are 66.
TEST(HostileToml, PartsOfKeysAndBracketsCountTogether) {
    const Written written;
    const std::string key = "a.b.c.d.e.f.g.h.i.j.k.l.m";
    written.add("case.toml", "x = 1\ny" + repeated(" = { " + key, 5) + " = 1" + repeated(" }", 5) + "\n");
    EXPECT_TRUE(said_of(written, "case.toml").starts_with("case.toml:2:")) << said_of(written, "case.toml");
    written.add("lists.toml", "x = " + repeated("[", 100'000) + repeated("]", 100'000) + "\n");
    EXPECT_TRUE(said_of(written, "lists.toml").starts_with("lists.toml:1:")) << said_of(written, "lists.toml");
}

// Dots and brackets of texts, comments and numbers make nothing deeper; a table of four levels and lists of two are usual.
TEST(HostileToml, DotsOfTextsCommentsAndNumbersDoNotCount) {
    const Written written;
    const std::string dots = repeated(".[{", 200);
    written.add("case.toml", "a = \"" + dots + "\\\"" + dots + "\" # " + dots + "\nb = '" + dots + "'\nc = '''\n" +
                                 dots + "\n'''\nd = \"\"\"\n" + dots + "\"\" \\\"\"\"\"\n" + "e = [" +
                                 repeated("[1.5, 2.5], ", 500) + "[0.5, 1.5]]\n[f.\"g.h\".i]\nj.k = { l = 1.0 }\n" +
                                 repeated("[[m]]\nn = 1.5\n", 200));
    EXPECT_EQ(said_of(written, "case.toml"), "sound: ");
}

// 40 000 files in a row do not fit onto a stack either; 60 are more than anybody has written.
TEST(HostileInclude, AChainOfFilesIsRefusedWhereItGetsTooLong) {
    const Written written;
    for (int i = 0; i < 200; ++i) {
        written.add("c" + std::to_string(i) + ".toml", "include = [\"c" + std::to_string(i + 1) + ".toml\"]\n");
    }
    written.add("c200.toml", "x = 1\n");
    EXPECT_EQ(said_of(written, "c0.toml"),
              "c63.toml:1:12: more than 64 files include one another in a row\n"
              "    include = [\"c64.toml\"]\n"
              "               ^~~~~~~~~~\n"
              "    remedy: include the last ones directly: include = [\"one.toml\", \"two.toml\"]\n");
    EXPECT_EQ(said_of(written, "c140.toml"), "sound: ");
}

// Read anew each time, 30 files that include the next one twice are read 2^30 times: hours. Once each, milliseconds.
TEST(HostileInclude, AFileThatIsIncludedTwiceIsReadOnce) {
    const Written written;
    for (int i = 0; i < 30; ++i) {
        const std::string next = "\"e" + std::to_string(i + 1) + ".toml\"";
        written.add("e" + std::to_string(i) + ".toml", "include = [" + next + ", " + next + "]\n");
    }
    written.add("e30.toml", "x = 1\n[[material]]\nname = \"rubber\"\ndensity = 1\n[[material]]\nname = \"steel\"\n");
    EXPECT_LT(seconds_of([&] { EXPECT_EQ(said_of(written, "e0.toml"), "sound: "); }), 5.0);
    written.add("e30.toml", "x = \n");
    EXPECT_LT(seconds_of([&] { EXPECT_TRUE(said_of(written, "e0.toml").starts_with("e30.toml:1:")); }), 5.0);
}

// Of a base that two parts include there is one rubber and one steel; the part that is included last wins, with the
// base below it: rubber has the density of the base, not that of the first part, and the colour that only that one gives.
TEST(HostileInclude, ABaseOfTwoPartsIsMergedAsIfEachHadItsOwn) {
    const Written written;
    written.add("base.toml", "x = 1\n[[material]]\nname = \"rubber\"\ndensity = 1\n[[material]]\nname = \"steel\"\n");
    written.add("one.toml",
                "include = \"base.toml\"\nx = 2\n[[material]]\nname = \"rubber\"\ndensity = 2\ncolour = 3\n");
    written.add("two.toml", "include = \"base.toml\"\ny = 5\n");
    written.add("case.toml", "include = [\"one.toml\", \"two.toml\"]\n");
    InputErrors errors;
    const std::optional<TomlValue> merged = read_document(written.folder() / "case.toml", errors);
    ASSERT_TRUE(merged);
    EXPECT_EQ(merged->find("x")->number, 1.0);
    EXPECT_EQ(merged->find("y")->number, 5.0);
    const TomlValue& materials = *merged->find("material");
    ASSERT_EQ(materials.items.size(), 2U);
    EXPECT_EQ(materials.items[0].find("density")->number, 1.0);
    EXPECT_EQ(materials.items[0].find("colour")->number, 3.0);
    EXPECT_EQ(materials.items[1].find("name")->text, "steel");
}

// /dev/zero has no end and a pipe none until its writer closes it; nobody writes into this one.
TEST(HostileFile, OnlyRegularFilesAreRead) {
    const Written written;
    ASSERT_EQ(::mkfifo((written.folder() / "pipe.toml").c_str(), 0600), 0);
    ASSERT_EQ(::mkfifo((written.folder() / "pipe.h5").c_str(), 0600), 0);
    std::filesystem::create_directory(written.folder() / "folder.toml");
    std::filesystem::create_symlink("/dev/zero", written.folder() / "zero.csv");
    EXPECT_EQ(said_of(written, "pipe.toml"),
              "pipe.toml: the file is a pipe, not a regular file\n"
              "    remedy: write what comes out of it into a file and give that\n");
    EXPECT_EQ(said_of(written, "folder.toml"), "folder.toml: the file is a directory\n    remedy: give a file\n");
    written.add("case.toml",
                std::string(bench) +
                    "[[run]]\nname = \"a\"\nfile = \"zero.csv\"\n[[run]]\nname = \"b\"\nfile = \"pipe.h5\"\n"
                    "[[run]]\nname = \"c\"\nfile = \"/dev/zero\"\n");
    const std::string said = error_report(read_experiment(written.folder() / "case.toml"));
    EXPECT_NE(said.find("zero.csv is a device, not a regular file\n"), std::string::npos) << said;
    EXPECT_NE(said.find("pipe.h5 is a pipe, not a regular file\n"), std::string::npos) << said;
    EXPECT_NE(said.find("the file /dev/zero is a device, not a regular file\n"), std::string::npos) << said;
}

// A file of 3 GB that occupies no disk: zeros that nobody wrote. The limit is 512 MB, of a case 16 MB.
TEST(HostileFile, WhatIsTooLargeIsNotRead) {
    const Written written;
    written.add("huge.toml", "x = 1\n");
    std::filesystem::resize_file(written.folder() / "huge.toml", std::uintmax_t{3} << 30U);
    EXPECT_EQ(said_of(written, "huge.toml"),
              "huge.toml: the file is too large: it has 3 GB, and at most 512 MB are read\n"
              "    remedy: split it, or leave out what the case does not need\n");
    written.add("large.toml", "x = 1\n" + repeated("# a comment of no use at all\n", 600'000));
    EXPECT_TRUE(said_of(written, "large.toml").starts_with("large.toml: the file is too large: it has 16.6 MB"));
}

}  // namespace tiretherm::input
