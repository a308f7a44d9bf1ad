#include <algorithm>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "cases/reader.hpp"

// Each file tests/bad_cases/NAME.toml is wrong in one way, or in many; NAME.txt holds what the user must then read, to
// the character. A new message is reviewed by reading the difference of these files.
namespace tiretherm::cases {

namespace {

namespace fs = std::filesystem;

fs::path folder() { return fs::path(TIRETHERM_SOURCE_DIR) / "tests" / "bad_cases"; }

std::vector<std::string> names() {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder())) {
        if (entry.path().extension() == ".toml") {
            found.push_back(entry.path().stem().string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Paths as if the checker had been started in the folder.
std::string relative(std::string text) {
    const std::string prefix = folder().generic_string() + "/";
    for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) {
        text.erase(at, prefix.size());
    }
    return text;
}

class BadCase : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadCase, IsExplainedToTheCharacter) {
    const Reading reading = read_case(folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.problem.has_value());
    EXPECT_FALSE(reading.mistakes.empty());
    EXPECT_EQ(relative(render(reading)), text_of(folder() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadCase, testing::ValuesIn(names()), [](const auto& bad) { return bad.param; });

// What they include and mention must be sound, or they would be wrong for another reason.
TEST(GoodCase, WhatTheBadOnesIncludeIsSound) {
    for (const std::string_view name : {"good/tire.toml", "good/slab.toml"}) {
        const Reading reading = read_case(folder() / name);
        EXPECT_TRUE(reading.problem.has_value()) << render(reading);
        EXPECT_TRUE(reading.warnings.empty()) << render(reading);
    }
}

TEST(BadFile, ThatIsNotThere) {
    const Reading reading = read_case("/no/such/case.toml");
    ASSERT_EQ(reading.mistakes.size(), 1U);
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

}  // namespace tiretherm::cases
