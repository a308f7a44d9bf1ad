// SPDX-License-Identifier: BSD-3-Clause
// Wrong cases in tests/bad_cases: the messages are compared character by character.

#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "input/runs/reader.hpp"
#include "tests/input/model/expected.hpp"

// Each file tests/bad_cases/NAME.toml is wrong in one way, or in many; NAME.txt holds what the user must then read, to
// the character. A new message is reviewed by reading the difference of these files.
namespace tiretherm::input {

namespace {

namespace fs = std::filesystem;

using expected::folder;
using expected::relative;

class BadCase : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadCase, IsExplainedToTheCharacter) {
    const Reading reading = read_case(folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.problem.has_value());
    EXPECT_FALSE(reading.errors.empty());
    EXPECT_EQ(relative(render(reading)), expected::text_of(folder() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadCase, testing::ValuesIn(expected::names(folder())),
                         [](const auto& bad) { return bad.param; });

// What they include and mention must be sound, or they would be wrong for another reason.
TEST(GoodCase, WhatTheBadOnesIncludeIsSound) {
    for (const std::string_view name : {"good/tire.toml", "good/slab.toml", "good/section.toml"}) {
        const Reading reading = read_case(folder() / name);
        EXPECT_TRUE(reading.problem.has_value()) << render(reading);
        EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    }
}

TEST(BadFile, ThatIsNotThere) {
    const Reading reading = read_case("/no/such/case.toml");
    ASSERT_EQ(reading.errors.size(), 1U);
    EXPECT_EQ(render(reading), "/no/such/case.toml: the file cannot be read: No such file or directory\n");
}

TEST(BadFile, ThatIsADirectory) {
    EXPECT_EQ(relative(render(read_case(folder() / "good"))),
              "good: the file is a directory\n    remedy: give a file\n");
}

TEST(BadFile, ThatMayNotBeRead) {
    const fs::path file = fs::temp_directory_path() / ("unreadable_" + std::to_string(::getpid()) + ".toml");
    std::ofstream(file) << "title = \"x\"\n";
    fs::permissions(file, fs::perms::none);
    const Reading reading = read_case(file);
    const bool may_read_anyway = std::ifstream(file).good();  // the superuser may
    fs::remove(file);
    if (may_read_anyway) {
        GTEST_SKIP() << "run by the superuser";
    }
    EXPECT_EQ(render(reading), file.generic_string() + ": the file cannot be read: Permission denied\n");
}

}  // namespace tiretherm::input
