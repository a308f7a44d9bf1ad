// SPDX-License-Identifier: BSD-3-Clause
// Wrong validation tables in tests/bad_cases/validation: the messages are compared character by character.

#include <gtest/gtest.h>

#include "input/runs/reader.hpp"
#include "input/validation/validation.hpp"
#include "tests/input/model/expected.hpp"

// Each table tests/bad_cases/validation/NAME.toml is wrong in many ways; NAME.txt holds what the user must then read,
// to the character.
namespace tiretherm::input {

namespace {

std::filesystem::path folder() { return expected::folder() / "validation"; }

class BadTable : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadTable, IsExplainedToTheCharacter) {
    const ValidationReading reading = read_validation(folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.table.has_value());
    const std::string report = render(CaseFindings{.errors = reading.errors, .warnings = reading.warnings});
    EXPECT_EQ(expected::relative(report), expected::text_of(folder() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadTable, testing::ValuesIn(expected::names(folder())),
                         [](const auto& bad) { return bad.param; });

TEST(BadTableFile, ThatIsNotThere) {
    const ValidationReading reading = read_validation("/no/such/table.toml");
    ASSERT_EQ(reading.errors.size(), 1U);
    EXPECT_EQ(reading.errors[0].what, "the file cannot be read: No such file or directory");
}

}  // namespace tiretherm::input
