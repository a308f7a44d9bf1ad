// SPDX-License-Identifier: BSD-3-Clause
// Wrong files of loggers, and wrong choices of laps, in tests/bad_cases/loggers: the messages are compared character by character.

#include <gtest/gtest.h>

#include "tests/input/measurements/measured_bench.hpp"
#include "tests/input/model/expected.hpp"

namespace tiretherm::input {

namespace {

std::filesystem::path logs_folder() { return expected::folder() / "loggers"; }

class BadLog : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(BadLog, IsExplainedToTheCharacter) {
    const ExperimentReading reading = read_experiment(logs_folder() / (GetParam() + ".toml"));
    EXPECT_FALSE(reading.experiment.has_value());
    EXPECT_FALSE(reading.errors.empty());
    EXPECT_EQ(expected::relative(error_report(reading)), expected::text_of(logs_folder() / (GetParam() + ".txt")));
}

INSTANTIATE_TEST_SUITE_P(All, BadLog, testing::ValuesIn(expected::names(logs_folder())),
                         [](const auto& bad) { return bad.param; });

// The file whose laps are chosen wrongly is sound.
TEST(GoodLog, WhatTheBadOnesUseIsSound) {
    const Written written;
    const std::string bench_of_them = (expected::folder() / "data/bench.inc").generic_string();
    const std::string log = (logs_folder() / "aim.csv").generic_string();
    const ExperimentReading reading = read_experiment(written.add(
        "case.toml", "include = [\"" + bench_of_them + "\"]\n[[run]]\nfile = \"" + log + "\"\nlaps = \"1\"\n"));
    EXPECT_TRUE(reading.experiment.has_value()) << error_report(reading);
}

}  // namespace tiretherm::input
