// SPDX-License-Identifier: BSD-3-Clause
// A study that goes on makes those runs again whose case reads a file that has changed, whatever file it is.

#include <gtest/gtest.h>

#include "input/studies/study.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

/// A case that reads a file, by the tables that name it, and two contents of that file.
struct Reads {
    std::string name;
    std::string tables;
    std::string file;
    std::string before;
    std::string after;
};

std::string source(const std::string& path) { return (source_folder() / path).string(); }

std::string tir(const std::string& of_load) {
    return "[MODEL]\nFITTYP = 61\n[DIMENSION]\nUNLOADED_RADIUS = 0.33\nWIDTH = 0.225\n[VERTICAL]\nFNOMIN = " + of_load +
           "\n[LATERAL_COEFFICIENTS]\nPCY1 = 1.3\nPDY1 = 1.0\nPKY1 = -20\nPKY2 = 2\n[LONGITUDINAL_COEFFICIENTS]\n"
           "PCX1 = 1.6\nPDX1 = 1.1\nPKX1 = 25\n";
}

std::vector<Reads> all_kinds() {
    const std::string cornering = "[drive]\nslip_angle = \"2 deg\"\nlateral_force = \"2000 N\"\n";
    return {
        {.name = "field_of_friction",
         .tables = cornering + "[effects.sliding_friction]\nfield = \"files/data\"\n",
         .file = "files/data",
         .before = "y [mm],friction_power [W/m2]\n-50,1\n0,2\n50,1\n",
         .after = "y [mm],friction_power [W/m2]\n-50,1\n0,3\n50,1\n"},
        {.name = "field_of_watts",
         .tables = cornering + "[effects.sliding_friction]\nfield = \"files/data\"\nuse = \"watts\"\n",
         .file = "files/data",
         .before = "y [mm],friction_power [W/m2]\n-50,1\n0,2\n50,1\n",
         .after = "y [mm],friction_power [W/m2]\n-50,1\n0,2\n50,2\n"},
        {.name = "table_of_the_total",
         .tables = "[effects.strain_energy_loss]\ntotal = \"files/data\"\n",
         .file = "files/data",
         .before = "speed [km/h],vertical_load [kN],force [N]\n0,4,40\n200,4,50\n",
         .after = "speed [km/h],vertical_load [kN],force [N]\n0,4,40\n200,4,51\n"},
        {.name = "property_file",
         .tables = "[tire]\nproperty_file = \"files/data\"\n",
         .file = "files/data",
         .before = tir("4000"),
         .after = tir("4100")},
        {.name = "included_case",
         .tables = "include = [\"files/data\"]\n",
         .file = "files/data",
         .before = "[effects.strain_energy_loss]\ntotal = \"drum\"\n",
         .after = "[effects.strain_energy_loss]\ntotal = \"drum\"\nlambda_blk = 0.9\n"},
    };
}

class StudyOfFiles : public testing::TestWithParam<Reads> {};

}  // namespace

TEST_P(StudyOfFiles, ChangeIsSeenInTheFingerprint) {
    const Reads& reads = GetParam();
    const Written written;
    written.add("files/drum", "speed [km/h],vertical_load [kN],force [N]\n0,4,40\n200,4,50\n");
    const std::string good = "\"" + source("tests/bad_cases/good/section.toml") + "\"";
    std::string text = reads.tables;
    if (const std::size_t at = text.find("include = ["); at != std::string::npos) {
        text.insert(at + 11, good + ", ");
    } else {
        text = "include = [" + good + "]\n" + text;
    }
    written.add("case.toml", text);
    const auto print = [&](const std::string& content) {
        written.add(reads.file, content);
        const StudyReading reading = read_study(written.add(
            "study.toml",
            "case = \"case.toml\"\n[[vary]]\nkey = \"initial.temperature\"\nvalues = [\"20 degC\", \"21 degC\"]\n"));
        std::string report;
        for (const InputError& error : reading.errors) {
            report += render(error);
        }
        EXPECT_TRUE(reading.study.has_value()) << report;
        return reading.study ? reading.study->runs.at(1).fingerprint : std::string();
    };
    const std::string before = print(reads.before);
    EXPECT_EQ(print(reads.before), before);
    EXPECT_NE(print(reads.after), before);
}

INSTANTIATE_TEST_SUITE_P(EveryKind, StudyOfFiles, testing::ValuesIn(all_kinds()),
                         [](const auto& reads) { return reads.param.name; });

// The path in an included file counts from there: the drum's table lies beside it, not beside the case.
TEST(StudyOfFiles, FileOfAnIncludedCaseIsSeenWhereItLies) {
    const Written written;
    written.add("case.toml",
                "include = [\"" + source("tests/bad_cases/good/section.toml") + "\", \"files/loss.toml\"]\n");
    written.add("files/loss.toml", "[effects.strain_energy_loss]\ntotal = \"drum.csv\"\n");
    const auto print = [&](const std::string& force) {
        written.add("files/drum.csv", "speed [km/h],vertical_load [kN],force [N]\n0,4,40\n200,4," + force + "\n");
        const StudyReading reading = read_study(written.add(
            "study.toml", "case = \"case.toml\"\n[[vary]]\nkey = \"initial.temperature\"\nvalues = [\"20 degC\"]\n"));
        EXPECT_TRUE(reading.study.has_value());
        return reading.study ? reading.study->runs.at(0).fingerprint : std::string();
    };
    EXPECT_NE(print("50"), print("51"));
}

}  // namespace tiretherm::input
