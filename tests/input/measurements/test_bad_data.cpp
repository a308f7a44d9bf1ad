// SPDX-License-Identifier: BSD-3-Clause
// Wrong measured runs in tests/bad_cases/data: the messages are compared character by character.

#include <gtest/gtest.h>

#include "tests/input/measurements/measured_bench.hpp"
#include "tests/input/model/expected.hpp"

// Each file tests/bad_cases/data/NAME.toml has a measured run that is wrong in one way, or in many; NAME.txt holds what
// the user must then read, to the character.
namespace tiretherm::input {

namespace {

std::filesystem::path data_folder() { return expected::folder() / "data"; }

class BadData : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadData, IsExplainedToTheCharacter) {
    const ExperimentReading reading = read_experiment(data_folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.experiment.has_value());
    EXPECT_FALSE(reading.errors.empty());
    EXPECT_EQ(expected::relative(error_report(reading)), expected::text_of(data_folder() / (GetParam() + ".txt")));
}

// `tiretherm check` and `run` read the same case and must refuse it with the same words.
TEST_P(BadData, IsNoCaseToRunEither) {
    const Reading reading = read_case(data_folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.problem.has_value());
    EXPECT_EQ(expected::relative(render(reading)), expected::text_of(data_folder() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadData, testing::ValuesIn(expected::names(data_folder())),
                         [](const auto& bad) { return bad.param; });

TEST(GoodData, WhatTheBadOnesUseIsSound) {
    const Written written;
    const std::string bench_of_them = (data_folder() / "bench.inc").generic_string();
    const std::string log = (data_folder() / "good.csv").generic_string();
    const ExperimentReading reading = read_experiment(
        written.add("case.toml", "include = [\"" + bench_of_them + "\"]\n[[run]]\nfile = \"" + log + "\"\n"));
    EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
    EXPECT_TRUE(reading.warnings.empty()) << error_report(reading);
    EXPECT_TRUE(reading.data_warnings.empty());
}

}  // namespace tiretherm::input
