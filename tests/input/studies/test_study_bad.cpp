// SPDX-License-Identifier: BSD-3-Clause
// Wrong studies in tests/bad_cases/study: the messages are compared character by character.

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "input/studies/study.hpp"
#include "tests/input/model/expected.hpp"

// Each study tests/bad_cases/study/NAME.toml is wrong in many ways; NAME.txt holds what the user must then read, to the
// character.
namespace tiretherm::input {

namespace {

std::filesystem::path studies() { return expected::folder() / "study"; }

class BadStudy : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadStudy, IsExplainedToTheCharacter) {
    const StudyReading reading = read_study(studies() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.study.has_value());
    const std::string report = render(CaseFindings{.errors = reading.errors, .warnings = reading.warnings});
    EXPECT_EQ(expected::relative(report), expected::text_of(studies() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadStudy, testing::ValuesIn(expected::names(studies())),
                         [](const auto& bad) { return bad.param; });

TEST(BadStudyFile, ThatIsNotThere) {
    const StudyReading reading = read_study("/no/such/study.toml");
    ASSERT_EQ(reading.errors.size(), 1U);
    EXPECT_EQ(reading.errors[0].what, "the file cannot be read: No such file or directory");
}

}  // namespace tiretherm::input
