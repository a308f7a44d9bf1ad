// SPDX-License-Identifier: BSD-3-Clause
// How large a case is, and that what is beyond [limits], or beyond what double precision resolves, is refused.

#include <gtest/gtest.h>

#include "input/model/size_limits.hpp"
#include "input/runs/reader.hpp"
#include "support/written.hpp"

namespace tiretherm::input {
namespace {

/// A sound slab of 4 by 4 by 6 cells over 60 s, with more tables.
Reading sized(const std::string& more) {
    const Written written;
    return read_case(
        written.add("case.toml", "include = [\"" TIRETHERM_SOURCE_DIR "/tests/bad_cases/good/slab.toml\"]\n" + more));
}

/// What is wrong, with its remedy; empty of a sound case.
std::string mistakes(const Reading& reading) {
    std::string all;
    for (const InputError& error : reading.errors) {
        all += error.what + "; " + error.remedy + "\n";
    }
    return all;
}

}  // namespace

// 60 s in rows of 0.5 s are 121 with the first; fields of 7 s at 0, 7, ... 56 and 60 s; steps of 0.25 s are 240.
TEST(CaseSize, CountsRowsFieldsAndSteps) {
    const Reading reading = sized("[time]\noutput = \"0.5 s\"\nfields = \"7 s\"\nstep = \"0.25 s\"\n");
    ASSERT_TRUE(reading.problem) << render(reading);
    const CaseSize size = size_of(*reading.problem);
    EXPECT_EQ(size.cells, 96.0);
    EXPECT_EQ(size.rows, 121.0);
    EXPECT_EQ(size.fields, 10.0);
    EXPECT_EQ(size.steps, 240.0);
}

TEST(CaseSize, RowOfEachStepIsNotCountedWhereStepsAreChosen) {
    const Reading reading = sized("");
    ASSERT_TRUE(reading.problem) << render(reading);
    const CaseSize size = size_of(*reading.problem);
    EXPECT_EQ(size.rows, 0.0);
    EXPECT_EQ(size.fields, 2.0);
    EXPECT_FALSE(size.steps);
}

TEST(CaseSize, BytesAreSpelledWithTwoOrThreeDigits) {
    EXPECT_EQ(spell_bytes(999.0), "999 B");
    EXPECT_EQ(spell_bytes(1500.0), "1.5 kB");
    EXPECT_EQ(spell_bytes(999.6e6), "1 GB");
    EXPECT_EQ(spell_bytes(123.4e9), "123 GB");
}

// 60 s in 1e-6 s are 6e7 rows of 2 numbers: over the 1e7 rows; with those raised to 1e8 about 9 GB of files, and 2.9 GB of
// memory, which may be; with fields of 1e-6 s some 400 GB.
TEST(SizeLimits, EachCanBeRaisedAndSaysHow) {
    const std::string rows = "[time]\noutput = \"1e-6 s\"\n";
    EXPECT_EQ(mistakes(sized(rows)),
              "the run would give 60 million rows, more than 10 million; take a longer output, or raise the limit: "
              "[limits] rows = 6.6e+07\n");
    EXPECT_EQ(mistakes(sized(rows + "[limits]\nrows = 1e8\n")), "");
    EXPECT_EQ(
        mistakes(sized(rows + "[limits]\nrows = 1e8\nmemory = \"1 GB\"\n")),
        "the run would take about 2.9 GB of memory, more than 1 GB; take a longer output, or, where the machine has "
        "as much, raise the limit: [limits] memory = \"3.5 GB\"\n");
    const std::string fields = "[time]\nfields = \"1e-6 s\"\n";
    const std::string many = mistakes(sized(fields));
    EXPECT_TRUE(many.starts_with("the run would write about ")) << many;
    EXPECT_NE(many.find("60 million fields of 96 cells), more than 20 GB"), std::string::npos) << many;
    EXPECT_EQ(mistakes(sized(fields + "[limits]\noutput = \"2 TB\"\n")), "");
    EXPECT_EQ(mistakes(sized("[time]\nstep = \"1e-8 s\"\noutput = \"1 s\"\n")),
              "the run would take 6000 million steps, more than 1000 million; take a longer step, or raise the limit: "
              "[limits] steps = 6.6e+09\n");
    EXPECT_EQ(mistakes(sized("[time]\nstep = \"1e-8 s\"\noutput = \"1 s\"\n[limits]\nsteps = 1e10\n")), "");
    EXPECT_EQ(mistakes(sized("[limits]\ncells = 95\n")),
              "the mesh has 96 cells, more than 95; take fewer cells, or raise the limit: [limits] cells = 1.1e+02\n");
    EXPECT_EQ(mistakes(sized("[limits]\ncells = 96\n")), "");
}

// A section has the cells of its zones and layers on both sides, times its sectors: 1e4 crown columns of 1e5 cells each were
// never counted.
TEST(SizeLimits, SectionsAndRingsAreCounted) {
    const Written written;
    const Reading reading = read_case(written.add(
        "case.toml", "include = [\"" TIRETHERM_SOURCE_DIR
                     "/tests/bad_cases/good/section.toml\"]\n[mesh]\ncrown_cells = 10000\nsectors = 256\n"));
    ASSERT_EQ(reading.errors.size(), 1U) << render(reading);
    EXPECT_NE(reading.errors[0].what.find(" million cells, more than 5 million"), std::string::npos) << render(reading);
}

// Doubles near 1e9 s are 1.2e-7 s apart, near 60 s 7e-15 s; temperatures of 300 K 6e-14 K.
TEST(SizeLimits, WhatDoublePrecisionDoesNotResolveIsRefused) {
    EXPECT_EQ(mistakes(sized("[time]\ntolerance = \"1e-300 K\"\n")),
              "a tolerance of 1e-300 K is below what double precision resolves; take 1e-12 K or more; the default is "
              "0.001 K\n");
    EXPECT_EQ(mistakes(sized("[time]\ntolerance = \"1e-12 K\"\n")), "");
    for (const std::string key : {"output", "fields", "step"}) {
        const std::string text = mistakes(sized("[time]\n" + key + " = \"1e-14 s\"\n"));
        EXPECT_NE(text.find(key + " = 1e-14 s is below what double precision resolves: times near 60 s are 7.1e-15 s "
                                  "apart; take a longer one"),
                  std::string::npos)
            << text;
    }
    EXPECT_NE(
        mistakes(sized("[time]\nstart = \"1e9 s\"\nend = \"1000000001 s\"\nstep = \"1e-6 s\"\n")).find("times near"),
        std::string::npos);
}

TEST(SizeLimits, AmountOfMemoryHasANumberAndAUnit) {
    for (const std::string value : {"20", "GB", "-1 GB", "0 GB", "nan GB", "1e999 GB", "20 GiB", "20 gb", "20 GB x"}) {
        EXPECT_EQ(
            mistakes(sized("[limits]\noutput = \"" + value + "\"\n")),
            "output: \"" + value +
                "\" is no amount of memory above 0; write output = \"20 GB\"; the units are B, kB, MB, GB and TB\n");
    }
    for (const std::string value : {"20 GB", "20GB", "2e4 MB", " 30000000000 B"}) {
        EXPECT_EQ(mistakes(sized("[limits]\noutput = \"" + value + "\"\n")), "") << value;
    }
}

}  // namespace tiretherm::input
